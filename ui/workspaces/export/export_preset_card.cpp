#include "workspaces/export/export_preset_card.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QFormLayout>
#include <QMenu>
#include <QSignalBlocker>
#include <QUrl>

#include "base/files.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

ExportPresetCard::ExportPresetCard(ExportModel& model, QWidget* parent)
    : Card(tr("For"), parent),
      model_(model),
      presets_(new QComboBox(this)),
      formats_(new QComboBox(this)),
      comment_(new QLabel(this)),
      facts_(dim_label({}, this)),
      format_hint_(dim_label({}, this)) {
  presets_->setAccessibleName(tr("Preset"));
  formats_->setAccessibleName(tr("Format"));
  for (const ExportFormat& one : export_formats()) {
    formats_->addItem(one.title, one.id);
  }
  for (QLabel* label : {comment_, facts_, format_hint_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  facts_->setAccessibleName(tr("What the preset sets"));
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  row->addWidget(presets_, 1);
  row->addWidget(make_menu());
  form->addRow(tr("Program"), row);
  form->addRow(tr("Format"), formats_);
  body()->addLayout(form);
  for (QLabel* label : {format_hint_, comment_, facts_}) {
    body()->addWidget(label);
  }
  connect(presets_, &QComboBox::currentIndexChanged, this,
          [this] { model_.choose_preset(presets_->currentData().toString().toStdString()); });
  connect(formats_, &QComboBox::currentIndexChanged, this, [this] {
    ExportChoices choices = model_.choices();
    choices.format = formats_->currentData().toString();
    model_.change(choices);
  });
  connect(&model_, &ExportModel::choices_changed, this, &ExportPresetCard::show_choices);
  show_choices();
}

QToolButton* ExportPresetCard::make_menu() {
  QToolButton* button = icon_button(QStringLiteral("menu"), tr("Your own presets and bone names"), this);
  auto* menu = new QMenu(button);
  menu->addAction(icon(QStringLiteral("folder")), tr("Open the folder of your presets"), this,
                  [this] { open_folder("presets"); });
  menu->addAction(icon(QStringLiteral("folder")), tr("Open the folder of your bone names"), this,
                  [this] { open_folder("bone_maps"); });
  menu->addAction(icon(QStringLiteral("refresh")), tr("Read them again"), this, [this] { model_.read_presets(); });
  button->setMenu(menu);
  button->setPopupMode(QToolButton::InstantPopup);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void ExportPresetCard::open_folder(const char* name) {
  const std::filesystem::path folder = user_data_folder() / name;
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(folder.string())));
}

void ExportPresetCard::show_choices() {
  const QSignalBlocker quiet_presets(presets_), quiet_formats(formats_);
  presets_->clear();
  for (const PresetEntry& one : model_.presets()) {
    presets_->addItem(preset_title(one), QString::fromStdString(one.name));
    if (!one.preset) {
      presets_->setItemIcon(presets_->count() - 1, icon(QStringLiteral("warning")));
    }
  }
  const ExportChoices& choices = model_.choices();
  presets_->setCurrentIndex(presets_->findData(QString::fromStdString(choices.preset)));
  formats_->setCurrentIndex(formats_->findData(choices.format));
  const ExportFormat format = export_format(choices.format);
  format_hint_->setText(format.hint);
  const PresetEntry& entry = model_.preset();
  if (!entry.preset) {
    comment_->setText(tr("This preset cannot be read; what is wrong with it stands below."));
    facts_->clear();
    return;
  }
  comment_->setText(preset_comment(*entry.preset));
  comment_->setVisible(!comment_->text().isEmpty());
  QStringList lines;
  for (const QString& fact : preset_facts(effective_preset(choices, *entry.preset), format)) {
    lines << QStringLiteral("• ") + fact;
  }
  facts_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace limbwave::ui
