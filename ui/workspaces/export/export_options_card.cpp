#include "workspaces/export/export_options_card.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QProgressBar>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"
#include "interchange/bone_map.h"

namespace limbwave::ui {

namespace {

using interchange::FileUnit;
using interchange::RestPose;
using motion::RootMotion;

constexpr int kAsPreset = -1;
constexpr double kAnother = -1.0, kProposed = -2.0;  // In place of a frame rate.

QDoubleSpinBox* seconds_box(const QString& name, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setDecimals(3);
  box->setSingleStep(0.1);
  box->setSuffix(ExportOptionsCard::tr(" s"));
  box->setAccessibleName(name);
  return box;
}

// The preset's own value first, then all others.
void fill(QComboBox* box, const QString& preset, const std::vector<std::pair<QString, QVariant>>& others,
          const QVariant& chosen) {
  box->clear();
  box->addItem(ExportOptionsCard::tr("As the preset: %1").arg(preset), kAsPreset);
  for (const auto& [text, value] : others) {
    box->addItem(text, value);
  }
  box->setCurrentIndex(std::max(0, box->findData(chosen)));
}

template <typename T>
QVariant number(const std::optional<T>& value) {
  return value ? static_cast<int>(*value) : kAsPreset;
}

template <typename T>
std::optional<T> choice(const QComboBox* box) {
  const int value = box->currentData().toInt();
  return value == kAsPreset ? std::nullopt : std::optional<T>(static_cast<T>(value));
}

}  // namespace

ExportOptionsCard::ExportOptionsCard(StudioContext& context, ExportModel& model, QWidget* parent)
    : Card(tr("Options"), parent), context_(context), model_(model) {
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  make_time_rows(form);
  make_figure_rows(form);
  make_body_rows(form);
  body()->addLayout(form);
  follow();
  show_choices();
}

void ExportOptionsCard::make_time_rows(QFormLayout* form) {
  rates_ = new QComboBox(this);
  rates_->setAccessibleName(tr("Frame rate"));
  any_ = new QDoubleSpinBox(this);
  any_->setRange(kLowestRate, kHighestRate);
  any_->setDecimals(3);
  any_->setSuffix(tr(" Hz"));
  any_->setAccessibleName(tr("Frames a second"));
  auto* rate_row = new QHBoxLayout;
  rate_row->addWidget(rates_, 1);
  rate_row->addWidget(any_);
  form->addRow(tr("Frame rate"), rate_row);
  ranges_ = new QComboBox(this);
  ranges_->setAccessibleName(tr("Range"));
  form->addRow(tr("Range"), ranges_);
  part_ = new QWidget(this);
  auto* part_row = new QHBoxLayout(part_);
  part_row->setContentsMargins(0, 0, 0, 0);
  from_ = seconds_box(tr("From"), part_);
  to_ = seconds_box(tr("To"), part_);
  part_row->addWidget(from_, 1);
  part_row->addWidget(dim_label(tr("to"), part_));
  part_row->addWidget(to_, 1);
  form->addRow(QString(), part_);
}

void ExportOptionsCard::make_figure_rows(QFormLayout* form) {
  const auto box = [&](const QString& name) {
    auto* made = new QComboBox(this);
    made->setAccessibleName(name);
    made->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    made->setMinimumContentsLength(16);
    form->addRow(name, made);
    return made;
  };
  root_ = box(tr("Way over the floor"));
  rest_ = box(tr("Rest pose"));
  rest_frame_ = new QCheckBox(tr("Rest pose on frame 0"), this);
  form->addRow(QString(), rest_frame_);
  names_ = box(tr("Bone names"));
  units_ = box(tr("Unit of length"));
  tolerance_ = new QDoubleSpinBox(this);
  tolerance_->setRange(0.0, kMostTolerance);
  tolerance_->setDecimals(2);
  tolerance_->setSingleStep(0.1);
  tolerance_->setSuffix(tr("°"));
  tolerance_->setSpecialValueText(tr("Keep all keys"));
  tolerance_->setAccessibleName(tr("Leave out keys within"));
  form->addRow(tr("Leave out keys within"), tolerance_);
}

void ExportOptionsCard::make_body_rows(QFormLayout* form) {
  bodies_ = new QComboBox(this);
  bodies_->setAccessibleName(tr("Body"));
  bodies_->addItem(tr("Mannequin"), static_cast<int>(ExportBody::kMannequin));
  bodies_->addItem(tr("Your own mesh"), static_cast<int>(ExportBody::kOwnMesh));
  bodies_->addItem(tr("None, bones only"), static_cast<int>(ExportBody::kNone));
  form->addRow(tr("Body"), bodies_);
  mesh_row_ = new QWidget(this);
  auto* row = new QHBoxLayout(mesh_row_);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  mesh_ = new ElidedLabel({}, mesh_row_);
  auto* choose = new QPushButton(tr("Choose mesh…"), mesh_row_);
  choose->setToolTip(tr("A .obj, .glb, .gltf or .fbx of a body; it is skinned to the bones by itself"));
  row->addWidget(mesh_, 1);
  row->addWidget(choose);
  form->addRow(QString(), mesh_row_);
  skinning_ = new QWidget(this);
  auto* progress_row = new QHBoxLayout(skinning_);
  progress_row->setContentsMargins(0, 0, 0, 0);
  progress_row->setSpacing(kGrid);
  progress_ = new QProgressBar(skinning_);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setAccessibleName(tr("Skinning"));
  step_ = dim_label({}, skinning_);
  stop_ = new QPushButton(skinning_);
  progress_row->addWidget(progress_, 1);
  progress_row->addWidget(step_, 1);
  progress_row->addWidget(stop_);
  form->addRow(QString(), skinning_);
  connect(choose, &QPushButton::clicked, this, &ExportOptionsCard::choose_mesh);
  connect(stop_, &QPushButton::clicked, this, [this] {
    if (model_.preparing() != nullptr) {
      model_.preparing()->cancel();
    } else {
      model_.prepare();
    }
  });
}

void ExportOptionsCard::follow() {
  for (QComboBox* box : {rates_, ranges_, root_, rest_, names_, units_, bodies_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &ExportOptionsCard::read);
    box->setFocusPolicy(Qt::StrongFocus);
    box->installEventFilter(this);
  }
  for (QDoubleSpinBox* box : {any_, from_, to_, tolerance_}) {
    box->setKeyboardTracking(false);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ExportOptionsCard::read);
    box->setFocusPolicy(Qt::StrongFocus);
    box->installEventFilter(this);
  }
  connect(rest_frame_, &QCheckBox::toggled, this, &ExportOptionsCard::read);
  connect(&model_, &ExportModel::choices_changed, this, &ExportOptionsCard::show_choices);
  connect(&model_, &ExportModel::prepared_changed, this, [this] { show_preparing(); });
  connect(&context_.time(), &TimeModel::visible_changed, this, [this] { ranges_->setItemText(1, visible_text()); });
  connect(&context_.time(), &TimeModel::extent_changed, this, &ExportOptionsCard::show_choices);
}

bool ExportOptionsCard::eventFilter(QObject* watched, QEvent* event) {
  const auto* widget = qobject_cast<QWidget*>(watched);
  if (event->type() == QEvent::Wheel && widget != nullptr && !widget->hasFocus()) {
    event->ignore();
    return true;
  }
  return Card::eventFilter(watched, event);
}

void ExportOptionsCard::show_choices() {
  const ExportChoices& choices = model_.choices();
  showing_ = true;
  show_time(choices);
  show_figure(choices, model_.preset().preset.value_or(interchange::Preset()));
  show_body(choices);
  showing_ = false;
}

QString ExportOptionsCard::own_rate_text() const {
  const double rate = model_.source_rate_hz();
  return rate > 0.0 ? tr("As the motion has it: %1 Hz").arg(locale().toString(rate, 'g', 6))
                    : tr("As the motion has it");
}

QString ExportOptionsCard::proposed_rate_text() const {
  const double rate = model_.proposed_rate_hz(), own = model_.source_rate_hz();
  const double shown = rate > 0.0 ? rate : own;
  if (shown <= 0.0) {
    return tr("Proposed");
  }
  const QString text = tr("Proposed: %1 frames a second").arg(locale().toString(shown, 'g', 6));
  return std::abs(shown - own) < 1e-9 * own ? tr("%1, as the motion has them").arg(text) : text;
}

QString ExportOptionsCard::visible_text() const {
  const TimeModel& time = context_.time();
  return tr("What the timeline shows (%1 to %2)")
      .arg(format_clock_tenths(time.visible_begin_s()), format_clock_tenths(time.visible_end_s()));
}

void ExportOptionsCard::show_time(const ExportChoices& choices) {
  rates_->clear();
  rates_->addItem(proposed_rate_text(), kProposed);
  rates_->addItem(own_rate_text(), 0.0);
  for (const double rate : export_rates()) {
    rates_->addItem(tr("%1 frames a second").arg(locale().toString(rate, 'g', 6)), rate);
  }
  rates_->addItem(tr("Another rate"), kAnother);
  const int listed = rates_->findData(choices.fps.value_or(kProposed));
  any_rate_ = listed < 0 || (any_rate_ && choices.fps && *choices.fps == any_->value());
  rates_->setCurrentIndex(any_rate_ ? rates_->count() - 1 : listed);
  any_->setVisible(any_rate_);
  if (choices.fps && *choices.fps > 0.0) {
    any_->setValue(*choices.fps);
  }

  const TimeModel& time = context_.time();
  ranges_->clear();
  ranges_->addItem(tr("Everything (%1)").arg(format_clock_tenths(time.duration_s())),
                   static_cast<int>(ExportRange::kAll));
  ranges_->addItem(visible_text(), static_cast<int>(ExportRange::kVisible));
  ranges_->addItem(tr("From … to …"), static_cast<int>(ExportRange::kPart));
  ranges_->setCurrentIndex(static_cast<int>(choices.range));
  part_->setVisible(choices.range == ExportRange::kPart);
  for (QDoubleSpinBox* box : {from_, to_}) {
    box->setRange(0.0, std::max(0.0, time.duration_s()));
  }
  if (choices.range == ExportRange::kPart) {
    from_->setValue(choices.begin_s);
    to_->setValue(choices.end_s);
  }
}

void ExportOptionsCard::show_figure(const ExportChoices& choices, const interchange::Preset& preset) {
  const ExportFormat format = export_format(choices.format);
  fill(root_, root_motion_text(preset),
       {{tr("Free, on the hips"), static_cast<int>(RootMotion::kFree)},
        {tr("In place"), static_cast<int>(RootMotion::kInPlace)}},
       number(choices.root_motion));
  fill(rest_, rest_text(preset.rest),
       {{tr("As captured"), static_cast<int>(RestPose::kAsIs)}, {tr("T-pose"), static_cast<int>(RestPose::kTPose)}},
       number(choices.rest));
  std::vector<std::pair<QString, QVariant>> names{{tr("As captured"), QString()}};
  for (const std::string& map : interchange::bone_map_names()) {
    names.emplace_back(bone_map_title(map), QString::fromStdString(map));
  }
  fill(names_, bone_map_title(preset.bone_map), names,
       choices.bone_map ? QVariant(QString::fromStdString(*choices.bone_map)) : QVariant(kAsPreset));
  fill(units_, unit_text(format.format == interchange::FileFormat::kBvh ? preset.bvh_unit : preset.unit),
       {{tr("Centimetres"), static_cast<int>(FileUnit::kCentimetres)},
        {tr("Metres"), static_cast<int>(FileUnit::kMetres)}},
       number(choices.unit));
  units_->setEnabled(format.has_unit);
  units_->setToolTip(format.has_unit ? QString()
                                     : tr("Lengths in %1 files are always in metres").arg(format.extension));
  const bool table = format.format == interchange::FileFormat::kCsv;
  rest_frame_->setEnabled(!table);
  rest_frame_->setChecked(!table && choices.rest_frame.value_or(preset.rest_frame));
  tolerance_->setEnabled(format.has_frames);
  tolerance_->setValue(choices.key_tolerance_deg);
  tolerance_->setToolTip(format.has_frames ? tr("Keys are left out as long as no joint turns by more than this")
                                           : tr("%1 files have every frame").arg(format.extension));
}

void ExportOptionsCard::show_body(const ExportChoices& choices) {
  const ExportFormat format = export_format(choices.format);
  bodies_->setCurrentIndex(bodies_->findData(static_cast<int>(choices.body)));
  bodies_->setEnabled(format.has_frames);
  bodies_->setToolTip(format.has_frames ? QString() : tr("%1 files have no body").arg(format.extension));
  mesh_row_->setVisible(format.has_frames && choices.body == ExportBody::kOwnMesh);
  const QString file = QString::fromStdString(choices.mesh.string());
  mesh_->set_text(file.isEmpty() ? tr("No mesh is chosen") : QFileInfo(file).fileName());
  mesh_->setToolTip(file);
  mesh_->setAccessibleName(tr("Mesh"));
  show_preparing();
}

void ExportOptionsCard::show_preparing() {
  const ExportChoices& choices = model_.choices();
  const bool own = mesh_row_->isVisibleTo(this) && !choices.mesh.empty();
  Job* job = model_.preparing();
  const bool stopped = model_.refusal() && is_cancelled(*model_.refusal());
  skinning_->setVisible(own);
  progress_->setVisible(job != nullptr);
  stop_->setVisible(job != nullptr || stopped);
  stop_->setText(job != nullptr ? tr("Stop") : tr("Skin it"));
  if (job == nullptr) {
    const auto& prepared = model_.prepared();
    step_->setText(stopped ? tr("Skinning was stopped")
                           : (prepared && model_.up_to_date()
                                  ? tr("%1 vertices skinned").arg(locale().toString(qulonglong(prepared->vertices)))
                                  : QString()));
    return;
  }
  const auto show_job = [this, job] {
    progress_->setValue(static_cast<int>(1000 * job->fraction()));
    const double left = job->left_s();
    step_->setText(left < 3.0 ? job->step() : tr("%1, %2 left").arg(job->step(), format_clock(left)));
  };
  disconnect(job, nullptr, this, nullptr);
  connect(job, &Job::changed, this, show_job);
  show_job();
}

void ExportOptionsCard::read() {
  if (showing_) {
    return;
  }
  ExportChoices choices = model_.choices();
  const double rate = rates_->currentData().toDouble();
  any_rate_ = rate == kAnother;
  if (any_rate_ && sender() == rates_) {
    // Starts from what it was.
    const double now = model_.file_rate_hz();
    const QSignalBlocker quiet(any_);
    any_->setValue(now > 0.0 ? now : any_->value());
  }
  if (rate == kProposed) {
    choices.fps.reset();
  } else {
    choices.fps = any_rate_ ? any_->value() : rate;
  }
  const auto range = static_cast<ExportRange>(ranges_->currentData().toInt());
  if (range == ExportRange::kPart && choices.range != ExportRange::kPart) {
    choices.begin_s = context_.time().visible_begin_s();
    choices.end_s = context_.time().visible_end_s();
  } else if (range == ExportRange::kPart) {
    choices.begin_s = from_->value();
    choices.end_s = to_->value();
  }
  choices.range = range;
  choices.root_motion = choice<RootMotion>(root_);
  choices.rest = choice<RestPose>(rest_);
  if (sender() == rest_frame_) {
    const bool usual = model_.preset().preset && model_.preset().preset->rest_frame;
    choices.rest_frame = rest_frame_->isChecked() == usual ? std::nullopt : std::optional(rest_frame_->isChecked());
  }
  const QVariant names = names_->currentData();
  choices.bone_map =
      names.typeId() == QMetaType::QString ? std::optional(names.toString().toStdString()) : std::nullopt;
  if (units_->isEnabled()) {
    choices.unit = choice<FileUnit>(units_);
  }
  choices.key_tolerance_deg = tolerance_->value();
  choices.body = static_cast<ExportBody>(bodies_->currentData().toInt());
  model_.change(choices);
  show_choices();  // Also where nothing changed but the way it is shown.
}

void ExportOptionsCard::choose_mesh() {
  const QString file = QFileDialog::getOpenFileName(window(), tr("Choose a mesh"),
                                                    QString::fromStdString(model_.choices().mesh.string()),
                                                    tr("Meshes (*.obj *.glb *.gltf *.fbx);;All files (*)"));
  if (!file.isEmpty()) {
    ExportChoices choices = model_.choices();
    choices.mesh = file.toStdString();
    model_.change(choices);
  }
}

}  // namespace limbwave::ui
