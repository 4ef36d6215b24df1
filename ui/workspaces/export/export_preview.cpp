#include "workspaces/export/export_preview.h"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QTimer>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "interchange/names.h"
#include "viewer/viewer_widget.h"

namespace limbwave::ui {

namespace {

constexpr int kTreeHeight = 15 * kGrid;
constexpr int kInstants = 60;  // At which the way of the figure is looked at.

// People count from 1.
QString counted(std::size_t index) {
  return QLocale().toString(qulonglong{index} + 1);
}

QString count(std::size_t number) {
  return QLocale().toString(qulonglong(number));
}

// Two digits of what is known roughly.
std::uintmax_t rounded(std::uintmax_t bytes) {
  std::uintmax_t step = 1;
  while (bytes / step >= 100) {
    step *= 10;
  }
  return (bytes + step / 2) / step * step;
}

std::vector<Eigen::Vector3d> extent(const PreparedExport& prepared) {
  std::vector<Eigen::Vector3d> points;
  std::vector<body::SegmentPose> poses;
  for (int i = 0; i < kInstants; ++i) {
    prepared.pose_at(prepared.lead_s + (prepared.report.duration_s - prepared.lead_s) * i / (kInstants - 1), poses);
    for (std::size_t s = 0; s < poses.size(); ++s) {
      points.push_back(poses[s].p_WL);
      points.emplace_back(poses[s].p_WL + poses[s].R_WL * Eigen::Vector3d(prepared.skeleton.segments[s].length, 0, 0));
    }
  }
  return points;
}

}  // namespace

ExportPreview::ExportPreview(StudioContext& context, SolveModel& solves, ExportModel& model, QWidget* parent)
    : QWidget(parent), context_(context), solves_(solves), model_(model) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* card = new Card(tr("What will be written"), this);
  layout->addWidget(card);
  make_picture(card->body());
  make_facts(card->body());
  tree_ = new QTreeWidget(card);
  tree_->setColumnCount(2);
  tree_->setHeaderLabels({tr("Bone in the file"), tr("Length")});
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  tree_->header()->setStretchLastSection(false);
  tree_->setAccessibleName(tr("Bones of the file"));
  tree_->setMinimumHeight(kTreeHeight / 2);
  tree_->setMaximumHeight(kTreeHeight);
  card->body()->addWidget(tree_);
  follow();
}

void ExportPreview::make_picture(QVBoxLayout* column) {
  picture_ = new QVBoxLayout;
  picture_->setSpacing(kGrid / 2);
  instead_ = dim_label({}, this);
  instead_->setAlignment(Qt::AlignCenter);
  instead_->setWordWrap(true);
  rest_ = new QPushButton(tr("Rest pose"), this);
  rest_->setCheckable(true);
  rest_->setToolTip(tr("Show how the skeleton of the file stands by itself"));
  at_ = dim_label({}, this);
  at_->setFont(tabular(font()));
  auto* row = new QHBoxLayout;
  row->addWidget(rest_);
  row->addStretch();
  row->addWidget(at_);
  picture_->addWidget(instead_, 1);
  picture_->addLayout(row);
  column->addLayout(picture_, 1);
}

void ExportPreview::make_facts(QVBoxLayout* column) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(2 * kGrid);
  grid->setVerticalSpacing(kGrid / 2);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  file_ = add_fact(grid, tr("File"), 0, 0, true);
  range_ = add_fact(grid, tr("Time"), 1, 0, true);
  frames_ = add_fact(grid, tr("Frames"), 2, 0);
  keys_ = add_fact(grid, tr("Keys"), 2, 1);
  bones_ = add_fact(grid, tr("Bones"), 3, 0);
  unit_ = add_fact(grid, tr("Lengths"), 3, 1);
  size_ = add_fact(grid, tr("Size"), 4, 0);
  actors_ = add_fact(grid, tr("Actors"), 4, 1);
  actors_name_ = static_cast<QLabel*>(grid->itemAtPosition(4, 2)->widget());
  column->addLayout(grid);
}

QLabel* ExportPreview::add_fact(QGridLayout* grid, const QString& name, int row, int half, bool wide) {
  auto* value = new ElidedLabel({}, this);
  value->setFont(tabular(font()));
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  grid->addWidget(dim_label(name, this), row, 2 * half);
  grid->addWidget(value, row, 2 * half + 1, 1, wide ? 3 : 1);
  return value;
}

void ExportPreview::follow() {
  connect(&model_, &ExportModel::prepared_changed, this, &ExportPreview::show_prepared);
  connect(&model_, &ExportModel::choices_changed, this, &ExportPreview::show_prepared);
  connect(&model_, &ExportModel::file_changed, this, &ExportPreview::show_facts);
  connect(&context_.time(), &TimeModel::playhead_changed, this, &ExportPreview::show_pose);
  connect(rest_, &QPushButton::toggled, this, &ExportPreview::show_pose);
  connect(&context_.selection(), &Selection::changed, this, &ExportPreview::show_selection);
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item != nullptr) {
      select_bone(item->data(0, Qt::UserRole).toInt());
    }
  });
}

void ExportPreview::set_active(bool active) {
  active_ = active;
  if (active_ && viewer_ == nullptr) {
    viewer_ = new ViewerWidget(this);
    viewer_->setMinimumHeight(18 * kGrid);
    viewer_->setAccessibleName(tr("Preview of the file"));
    picture_->insertWidget(0, viewer_, 1);
    connect(viewer_, &ViewerWidget::segment_clicked, this, [this](int bone) {
      if (bone >= 0) {
        select_bone(bone);
      }
    });
  }
  show_prepared();
  if (active_) {
    QTimer::singleShot(0, viewer_, &ViewerWidget::frame_all);  // When the picture has its size.
  }
}

void ExportPreview::show_prepared() {
  if (!active_) {
    return;
  }
  // Nothing of other choices stands beside a problem.
  const auto prepared = model_.choice_problem().isEmpty() ? model_.prepared() : nullptr;
  if (prepared != shown_) {
    const bool other = prepared && (!shown_ || shown_->skeleton.segments.size() != prepared->skeleton.segments.size());
    shown_ = prepared;
    if (shown_) {
      viewer_->set_skeleton(shown_->skeleton);
      viewer_->set_extent(extent(*shown_));
      show_bones();
      show_selection();
    }
    if (other) {
      QTimer::singleShot(0, viewer_, &ViewerWidget::frame_all);
    }
  }
  show_facts();
  show_pose();
}

void ExportPreview::show_facts() {
  const auto set = [](QLabel* label, const QString& text) { static_cast<ElidedLabel*>(label)->set_text(text); };
  set(file_, QString::fromStdString(std::filesystem::path(model_.file().toStdString()).filename().string()));
  tree_->setVisible(shown_ != nullptr);
  if (!shown_) {
    for (QLabel* label : {frames_, range_, actors_, bones_, keys_, unit_, size_}) {
      set(label, QStringLiteral("–"));
    }
    return;
  }
  const interchange::ExportReport& report = shown_->report;
  set(frames_, tr("%1 at %2 Hz").arg(count(report.frames), locale().toString(report.fps, 'g', 6)));
  const double begin = model_.begin_s(), duration = report.duration_s - shown_->lead_s;
  set(range_,
      tr("%1, from %2 to %3")
              .arg(format_clock_tenths(duration), format_clock_tenths(begin), format_clock_tenths(begin + duration)) +
          (shown_->lead_s > 0.0 ? tr(", behind one frame of rest") : QString()));
  actors_->setVisible(report.actors > 1);
  actors_name_->setVisible(report.actors > 1);
  set(actors_, count(report.actors));
  set(bones_, count(report.bones));
  const bool fewer = report.keys_after < report.keys_before;
  const QString left = count(report.keys_after);
  set(keys_, !fewer ? left
                    : tr("%1 of %2 (%3 %)")
                          .arg(left, count(report.keys_before))
                          .arg(std::lround(100.0 * static_cast<double>(report.keys_after) /
                                           static_cast<double>(report.keys_before))));
  set(unit_, model_.preset().preset
                 ? tr("in %1").arg(unit_text(effective_preset(model_.choices(), *model_.preset().preset).unit))
                 : QStringLiteral("–"));
  set(size_, tr("about %1").arg(size_text(rounded(shown_->bytes))));
}

void ExportPreview::show_bones() {
  const QSignalBlocker quiet(tree_);
  tree_->clear();
  const bool metres = !model_.preset().preset || effective_preset(model_.choices(), *model_.preset().preset).unit ==
                                                     interchange::FileUnit::kMetres;
  const bool plain = model_.choices().format == QLatin1String("bvh");
  interchange::UniqueNames unique;  // As the writers name them.
  std::vector<QTreeWidgetItem*> items;
  for (const body::Segment& segment : shown_->skeleton.segments) {
    auto* item = segment.parent < 0 ? new QTreeWidgetItem(tree_)
                                    : new QTreeWidgetItem(items[static_cast<std::size_t>(segment.parent)]);
    const std::string name = plain ? interchange::plain_name(segment.name) : segment.name;
    item->setText(0, QString::fromStdString(unique(name)));
    item->setText(1, metres ? tr("%1 m").arg(locale().toString(segment.length, 'f', 3))
                            : tr("%1 cm").arg(locale().toString(100.0 * segment.length, 'f', 1)));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setData(0, Qt::UserRole, static_cast<int>(items.size()));
    items.push_back(item);
  }
  tree_->expandAll();
}

int ExportPreview::bones_before() const {
  return shown_ && !shown_->clips.empty() ? static_cast<int>(shown_->clips.front().skeleton.segments.size()) -
                                                static_cast<int>(solves_.skeleton().segments.size())
                                          : 0;
}

void ExportPreview::select_bone(int bone) {
  viewer_->select(bone);
  const ExportSource* source = model_.sources().source();
  const int segment = bone - bones_before();
  if (source != nullptr && source->kind == ExportSource::Kind::kOpenSolve && segment >= 0 &&
      segment < static_cast<int>(solves_.skeleton().segments.size())) {
    context_.selection().select(SelectionKind::kSegment, segment);
  }
}

void ExportPreview::show_selection() {
  const ExportSource* source = model_.sources().source();
  const int segment = context_.selection().index_of(SelectionKind::kSegment);
  if (viewer_ != nullptr && shown_ && segment >= 0 && source != nullptr &&
      source->kind == ExportSource::Kind::kOpenSolve) {
    viewer_->select(segment + bones_before());
  }
}

void ExportPreview::show_pose() {
  instead_->setVisible(!shown_);
  at_->setVisible(shown_ != nullptr);
  rest_->setVisible(shown_ != nullptr);
  if (viewer_ != nullptr) {
    viewer_->setVisible(shown_ != nullptr);
  }
  if (!shown_) {
    instead_->setText(model_.preparing() != nullptr ? tr("The preview is being made.")
                                                    : tr("There is no preview of these choices."));
    at_->clear();
    return;
  }
  if (!active_) {
    return;
  }
  // The file stands still between its frames; a little is added for times that lie on one.
  const double passed = std::max(0.0, context_.time().playhead_s() - model_.begin_s()) + shown_->lead_s;
  const std::size_t last = std::max<std::size_t>(1, shown_->report.frames) - 1;
  frame_ = std::min(last, static_cast<std::size_t>(std::floor(passed * shown_->report.fps + 1e-6)));
  const double time = static_cast<double>(frame_) / shown_->report.fps;
  if (rest_->isChecked()) {
    at_->setText(tr("At rest"));
    shown_->rest_pose(poses_);
  } else {
    const double end = shown_->clips.front().duration();
    at_->setText(shown_->partial && time > end ? tr("Very long: the picture ends at %1").arg(format_clock(end))
                                               : tr("Frame %1 of %2").arg(counted(frame_), counted(last)));
    shown_->pose_at(time, poses_);
  }
  if (!model_.up_to_date()) {
    at_->setText(tr("Of earlier choices; being made again"));
  }
  viewer_->set_pose(poses_);
}

}  // namespace limbwave::ui
