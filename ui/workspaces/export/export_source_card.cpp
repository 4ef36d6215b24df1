#include "workspaces/export/export_source_card.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QFileDialog>
#include <QListWidget>
#include <QMenu>
#include <QSignalBlocker>

#include "common/icons.h"
#include "common/theme.h"
#include "interchange/animation_file.h"

namespace limbwave::ui {

QString animation_filter() {
  QStringList endings;
  for (const std::string& ending : interchange::animation_endings()) {
    endings << QLatin1Char('*') + QString::fromStdString(ending);
  }
  return ExportSourceCard::tr("Animations (%1);;All files (*)").arg(endings.join(QLatin1Char(' ')));
}

ExportSourceCard::ExportSourceCard(StudioContext& context, ExportModel& model, QWidget* parent)
    : Card(tr("Motion"), parent), context_(context), model_(model), source_(new QComboBox(this)) {
  source_->setAccessibleName(tr("Motion"));
  source_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  source_->setMinimumContentsLength(18);
  auto* open = new QPushButton(tr("Open animation…"), this);
  open->setToolTip(tr("A .bvh, .fbx, .glb, .gltf or .vrm of another program, to look at it and to export it on"));
  auto* add = new QPushButton(tr("Add actor"), this);
  add->setToolTip(tr("Somebody else who goes into the same file"));
  auto* menu = new QMenu(add);
  menu->addAction(icon(QStringLiteral("folder")), tr("A take…"), this, &ExportSourceCard::choose_take);
  menu->addAction(icon(QStringLiteral("import")), tr("An animation…"), this, [this] { choose_animation(true); });
  add->setMenu(menu);
  set_style_property(add, "menu", true);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  row->addWidget(source_, 1);
  row->addWidget(open);
  row->addWidget(add);
  body()->addLayout(row);
  body()->addWidget(make_others());

  connect(source_, &QComboBox::currentIndexChanged, &model_.sources(), &ExportSourceList::choose);
  connect(open, &QPushButton::clicked, this, [this] { choose_animation(); });
  connect(&model_.sources(), &ExportSourceList::changed, this, &ExportSourceCard::show_sources);
  show_sources();
}

QWidget* ExportSourceCard::make_others() {
  others_box_ = new QWidget(this);
  auto* row = new QHBoxLayout(others_box_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  others_ = new QListWidget(others_box_);
  others_->setAccessibleName(tr("Other actors"));
  others_->setTextElideMode(Qt::ElideMiddle);
  remove_ = new QPushButton(tr("Remove"), others_box_);
  row->addWidget(others_, 1);
  row->addWidget(remove_, 0, Qt::AlignTop);
  connect(remove_, &QPushButton::clicked, this, [this] { model_.sources().remove_other(others_->currentRow()); });
  return others_box_;
}

void ExportSourceCard::show_sources() {
  const QSignalBlocker quiet(source_);
  source_->clear();
  for (const ExportSource& one : model_.sources().offered()) {
    source_->addItem(one.title);
    source_->setItemData(source_->count() - 1, QString::fromStdString(one.origin.string()), Qt::ToolTipRole);
  }
  source_->setCurrentIndex(model_.sources().chosen());
  source_->setToolTip(source_->currentData(Qt::ToolTipRole).toString());
  const int row = others_->currentRow();
  others_->clear();
  for (const ExportSource& one : model_.sources().others()) {
    auto* item = new QListWidgetItem(icon(QStringLiteral("person")), one.title, others_);
    item->setToolTip(QString::fromStdString(one.origin.string()));
  }
  const int count = others_->count();
  others_box_->setVisible(count > 0);
  if (count > 0) {
    constexpr int kRows = 4;
    others_->setCurrentRow(std::clamp(row, 0, count - 1));
    others_->setFixedHeight(others_->sizeHintForRow(0) * std::min(kRows, count) + 2 * kGrid);
  }
}

void ExportSourceCard::choose_animation(bool as_actor) {
  const QString file =
      QFileDialog::getOpenFileName(window(), tr("Open an animation"), context_.takes_folder(), animation_filter());
  if (!file.isEmpty()) {
    model_.sources().open_animation(file, as_actor);
  }
}

void ExportSourceCard::choose_take() {
  const QString folder = QFileDialog::getExistingDirectory(
      window(), tr("Add a solved take (a folder that ends in .take)"), context_.takes_folder());
  if (!folder.isEmpty()) {
    model_.sources().add_take(folder);
  }
}

}  // namespace limbwave::ui
