#include "workspaces/solve/bone_card.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "base/units.h"
#include "common/shown_names.h"
#include "common/theme.h"
#include "timeline/timeline_layout.h"
#include "workspaces/solve/quality_text.h"

namespace limbwave::ui {

namespace {

constexpr int kSliderSteps = 1800;  // 0.1° each, to both sides.

}  // namespace

int segment_of_selection(const SelectedItem& item, const SolveModel& model) {
  switch (item.kind) {
    case SelectionKind::kSegment:
    case SelectionKind::kHeadingKey:
      return item.index;
    case SelectionKind::kSensor:
      return model.segment_of_sensor(item.index);
    case SelectionKind::kNone:
    case SelectionKind::kMarker:
      break;
  }
  return -1;
}

BoneCard::BoneCard(StudioContext& context, SolveModel& model, QWidget* parent)
    : Card(tr("Bone"), parent), context_(context), model_(model), live_headings_(LiveHeadings::of(context)) {
  build();
  connect(&context_.selection(), &Selection::changed, this, &BoneCard::follow_selection);
  connect(&context_.time(), &TimeModel::playhead_changed, this, &BoneCard::show_heading);
  connect(&model_, &SolveModel::skeleton_changed, this, &BoneCard::show_skeleton);
  connect(&model_, &SolveModel::solve_changed, this, &BoneCard::show_skeleton);
  connect(&model_, &SolveModel::shows_live_changed, this, &BoneCard::follow_selection);
  connect(&live_headings_, &LiveHeadings::changed, this, &BoneCard::show_heading);
  connect(&context_.live(), &LiveModel::recording_changed, this, &BoneCard::show_heading);
  connect(&model_.keys(), &KeyModel::keys_changed, this, &BoneCard::show_keys);
  connect(&model_.key_editor(), &KeyEditor::selection_changed, this, &BoneCard::show_keys);
  show_skeleton();
}

void BoneCard::build() {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(kGrid);
  grid->setColumnStretch(1, 1);
  bones_ = new QComboBox(this);
  bones_->setAccessibleName(tr("Selected bone"));
  bones_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  bones_->setMinimumContentsLength(8);
  length_ = new QDoubleSpinBox(this);
  length_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  length_->setRange(10.0, 2000.0);
  length_->setDecimals(1);
  length_->setSuffix(tr(" mm"));
  length_->setSingleStep(5.0);
  length_->setKeyboardTracking(false);
  length_->setAccessibleName(tr("Length of the bone in millimetres"));
  heading_ = new QDoubleSpinBox(this);
  heading_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  heading_->setRange(-3600.0, 3600.0);
  heading_->setDecimals(1);
  heading_->setSuffix(tr("°"));
  heading_->setKeyboardTracking(false);
  heading_->setAccessibleName(tr("Rotation about the vertical at the playhead in degrees"));
  slider_ = new QSlider(Qt::Horizontal, this);
  slider_->setRange(-kSliderSteps, kSliderSteps);
  slider_->setSingleStep(10);
  slider_->setPageStep(150);
  slider_->setAccessibleName(heading_->accessibleName());
  slider_->setToolTip(tr("Sets a key at the playhead"));
  grid->addWidget(dim_label(tr("Name"), this), 0, 0);
  grid->addWidget(bones_, 0, 1);
  grid->addWidget(dim_label(tr("Length"), this), 1, 0);
  grid->addWidget(length_, 1, 1);
  grid->addWidget(dim_label(tr("Rotation"), this), 2, 0);
  grid->addWidget(heading_, 2, 1);
  grid->addWidget(slider_, 3, 0, 1, 2);
  body()->addLayout(grid);
  hint_ = dim_label({}, this);
  hint_->setWordWrap(true);
  body()->addWidget(hint_);
  auto* row = new QHBoxLayout;
  set_key_ = new QPushButton(tr("Set key"), this);
  set_key_->setToolTip(tr("Sets a key of the rotation at the playhead (I)"));
  delete_key_ = new QPushButton(tr("Delete key"), this);
  delete_key_->setToolTip(tr("Deletes the selected keys (Del)"));
  straight_ = new QPushButton(tr("Back to 0°"), this);
  straight_->setToolTip(tr("Takes the rotation of this bone away"));
  row->addWidget(straight_, 1);
  row->addWidget(set_key_, 1);
  row->addWidget(delete_key_, 1);
  body()->addLayout(row);
  list_ = new QListWidget(this);
  list_->setAccessibleName(tr("Keys of the rotation about the vertical"));
  list_->setFont(tabular(font()));
  list_->setMaximumHeight(14 * kGrid);
  list_->setMinimumHeight(6 * kGrid);
  body()->addWidget(list_);

  connect(bones_, &QComboBox::activated, this,
          [this](int index) { context_.selection().select(SelectionKind::kSegment, index); });
  connect(length_, &QDoubleSpinBox::valueChanged, this, [this](double mm) {
    if (!showing_) {
      model_.change_length(segment_, mm / 1000.0);
    }
  });
  connect(heading_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
    if (!showing_) {
      turn_to(radians(value), kNoGesture);
    }
  });
  connect(slider_, &QSlider::sliderPressed, this, [this] {
    gesture_ = model_.shows_live() ? live_headings_.begin_gesture() : model_.key_editor().begin_gesture();
  });
  connect(slider_, &QSlider::sliderReleased, this, [this] { gesture_ = kNoGesture; });
  connect(slider_, &QSlider::valueChanged, this, [this](int steps) {
    if (!showing_) {
      turn_to(radians(steps / 10.0), gesture_);
    }
  });
  connect(set_key_, &QPushButton::clicked, this,
          [this] { turn_to(model_.keys().value_at(segment_, context_.time().playhead_s()), kNoGesture); });
  connect(straight_, &QPushButton::clicked, this, [this] { turn_to(0.0, kNoGesture); });
  connect(delete_key_, &QPushButton::clicked, this,
          [this] { model_.key_editor().remove(model_.key_editor().selected()); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int index) {
    if (!showing_ && index >= 0 && segment_ >= 0 && segment_ < model_.keys().lane_count()) {
      const LaneKey key = model_.keys().keys(segment_)[static_cast<std::size_t>(index)];
      model_.key_editor().select({{segment_, key.id}});
      context_.time().set_playhead(key.time_s);
    }
  });
}

void BoneCard::turn_to(double heading, int gesture) {
  if (model_.shows_live()) {
    live_headings_.set(segment_, heading, gesture);
  } else {
    model_.key_editor().set_value(segment_, context_.time().playhead_s(), heading, gesture);
  }
}

double BoneCard::heading() const {
  return model_.shows_live() ? live_headings_.value(segment_)
                             : model_.keys().value_at(segment_, context_.time().playhead_s());
}

void BoneCard::follow_selection() {
  segment_ = segment_of_selection(context_.selection().item(), model_);
  show_skeleton();
}

void BoneCard::show_skeleton() {
  showing_ = true;
  const bool live = model_.shows_live();
  const auto& segments = model_.shown_skeleton().segments;
  if (segment_ >= static_cast<int>(segments.size())) {
    segment_ = -1;
  }
  bool same = bones_->count() == static_cast<int>(segments.size());
  for (int i = 0; same && i < bones_->count(); ++i) {
    same = bones_->itemText(i) == shown_name(segments[static_cast<std::size_t>(i)].name);
  }
  if (!same) {
    bones_->clear();
    for (const body::Segment& segment : segments) {
      bones_->addItem(shown_name(segment.name));
    }
  }
  bones_->setPlaceholderText(segments.empty() ? tr("No skeleton yet") : tr("Choose a bone"));
  bones_->setCurrentIndex(segment_);
  bones_->setToolTip(bones_->currentText());
  bones_->setEnabled(!segments.empty());
  length_->setEnabled(!live && segment_ >= 0 && model_.solve() != nullptr);
  length_->setToolTip(live ? tr("Lengths are edited in a take") : QString());
  if (segment_ >= 0) {
    length_->setValue(1000.0 * segments[static_cast<std::size_t>(segment_)].length);
  } else {
    length_->setValue(length_->minimum());
  }
  length_->setSpecialValueText(segment_ >= 0 ? QString() : tr("–"));
  showing_ = false;
  show_heading();
  show_keys();
}

void BoneCard::show_heading() {
  showing_ = true;
  const bool live = model_.shows_live();
  const bool turns = segment_ >= 0 && model_.shown_sensor(segment_) && (live || model_.solve() != nullptr);
  for (QWidget* widget : std::initializer_list<QWidget*>{heading_, slider_, set_key_}) {
    widget->setEnabled(turns);
  }
  set_key_->setVisible(!live);
  delete_key_->setVisible(!live);
  straight_->setVisible(live);
  const double value = degrees(heading());
  straight_->setEnabled(turns && value != 0.0);
  // What is being typed is left alone, though the figure plays on.
  const bool typing =
      heading_->hasFocus() &&
      heading_->text() != heading_->prefix() + heading_->textFromValue(heading_->value()) + heading_->suffix();
  if (!typing && (!heading_->hasFocus() || std::abs(heading_->value() - value) > 0.05)) {
    heading_->setValue(value);
  }
  if (!slider_->isSliderDown()) {
    slider_->setValue(static_cast<int>(std::lround(10.0 * std::remainder(value, 360.0))));
  }
  slider_->setToolTip(live ? tr("Turns the live figure") : tr("Sets a key at the playhead"));
  if (segment_ < 0) {
    hint_->setText(tr("Click a bone in the view, or choose one here."));
  } else if (!turns) {
    hint_->setText(live || model_.solve() ? tr("No sensor is worn here: it follows its parent.")
                                          : tr("Rotations can be keyed once the take is solved."));
  } else if (!model_.shows_inclination()) {
    hint_->setText(live ? tr("Turns the bone about the vertical, beyond what its sensors say; what hangs on it without "
                             "sensors follows. It holds from now on.")
                        : tr("Turns the bone about the vertical, beyond what its sensors say; what hangs on it without "
                             "sensors follows. Turning it sets a key at the playhead."));
  } else if (!live) {
    hint_->setText(tr("About the vertical, which gravity cannot tell. Turning it sets a key at the playhead."));
  } else {
    hint_->setText(context_.live().recording() && !context_.live().aside()
                       ? tr("About the vertical, which gravity cannot tell. It holds from now on and becomes a key of "
                            "the take that is being recorded.")
                       : tr("About the vertical, which gravity cannot tell. It holds from now on, for the next take "
                            "too."));
  }
  showing_ = false;
}

void BoneCard::show_keys() {
  show_heading();
  showing_ = true;
  QStringList texts;
  int current = -1;
  if (!model_.shows_live() && segment_ >= 0 && segment_ < model_.keys().lane_count()) {
    for (const LaneKey& key : model_.keys().keys(segment_)) {
      if (model_.key_editor().is_selected({segment_, key.id})) {
        current = static_cast<int>(texts.size());
      }
      texts << tr("%1    %2°").arg(time_text(key.time_s, 0.001), signed_number(degrees(key.value), 1));
    }
  }
  while (list_->count() > texts.size()) {
    delete list_->takeItem(list_->count() - 1);
  }
  for (int i = 0; i < static_cast<int>(texts.size()); ++i) {
    if (i < list_->count()) {
      list_->item(i)->setText(texts[i]);
    } else {
      list_->addItem(texts[i]);
    }
  }
  list_->setCurrentRow(current);
  list_->setVisible(!texts.isEmpty());
  delete_key_->setEnabled(current >= 0);
  showing_ = false;
}

}  // namespace limbwave::ui
