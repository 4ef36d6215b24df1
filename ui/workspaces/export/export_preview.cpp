#include "workspaces/export/export_preview.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <cmath>

#include "common/format.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "interchange/names.h"
#include "viewer/viewer_widget.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui {

namespace {

constexpr int kTreeHeight = 20 * kGrid;

// People count from 1.
QString counted(std::size_t index) {
  return QLocale().toString(qulonglong{index} + 1);
}

}  // namespace

ExportPreview::ExportPreview(StudioContext& context, SolveModel& model, QWidget* parent)
    : QWidget(parent), context_(context), model_(model) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  auto* card = new Card(tr("What will be written"), this);
  layout->addWidget(card);
  picture_ = new QVBoxLayout;
  picture_->setSpacing(kGrid / 2);
  other_ = dim_label(tr("Only the open solve is shown here. Open this one in Solve to see it."), card);
  other_->setAlignment(Qt::AlignCenter);
  other_->setWordWrap(true);
  at_ = dim_label({}, card);
  at_->setFont(tabular(font()));
  at_->setAlignment(Qt::AlignRight);
  picture_->addWidget(other_, 1);
  picture_->addWidget(at_);
  card->body()->addLayout(picture_, 1);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid / 2);
  file_ = add_fact(form, tr("File"));
  frames_ = add_fact(form, tr("Frames"));
  range_ = add_fact(form, tr("Time"));
  joints_ = add_fact(form, tr("Joints"));
  unit_ = add_fact(form, tr("Lengths"));
  card->body()->addLayout(form);
  tree_ = new QTreeWidget(card);
  tree_->setColumnCount(2);
  tree_->setHeaderLabels({tr("Joint in the file"), tr("Bone length")});
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  tree_->header()->setStretchLastSection(false);
  tree_->setAccessibleName(tr("Joints of the file"));
  tree_->setMinimumHeight(kTreeHeight / 3);
  tree_->setMaximumHeight(kTreeHeight);
  card->body()->addWidget(tree_);

  connect(&model_, &SolveModel::skeleton_changed, this, &ExportPreview::show_figure);
  connect(&model_, &SolveModel::solve_changed, this, &ExportPreview::show_figure);
  connect(&model_, &SolveModel::pose_changed, this, &ExportPreview::show_pose);
  connect(&context_.time(), &TimeModel::playhead_changed, this, &ExportPreview::show_pose);
  connect(&context_.selection(), &Selection::changed, this, [this] {
    if (viewer_ != nullptr && context_.selection().item().kind == SelectionKind::kSegment) {
      viewer_->select(context_.selection().item().index);
    }
  });
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this](const QTreeWidgetItem* item) {
    if (item != nullptr) {
      context_.selection().select(SelectionKind::kSegment, item->data(0, Qt::UserRole).toInt());
    }
  });
}

QLabel* ExportPreview::add_fact(QFormLayout* form, const QString& name) {
  auto* value = new ElidedLabel({}, this);
  value->setFont(tabular(font()));
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setAccessibleName(name);
  form->addRow(dim_label(name, this), value);
  return value;
}

void ExportPreview::set_active(bool active) {
  active_ = active;
  if (active_ && viewer_ == nullptr) {
    viewer_ = new ViewerWidget(this);
    viewer_->setMinimumHeight(18 * kGrid);
    viewer_->setAccessibleName(tr("Preview of the file"));
    picture_->insertWidget(0, viewer_, 1);
    connect(viewer_, &ViewerWidget::segment_clicked, this, [this](int segment) {
      if (segment >= 0) {
        context_.selection().select(SelectionKind::kSegment, segment);
      }
    });
  }
  show_figure();
  if (active_) {
    QTimer::singleShot(0, viewer_, &ViewerWidget::frame_all);  // When the picture has its size.
  }
}

void ExportPreview::set_plan(const ExportPlan& plan, bool open) {
  plan_ = plan;
  open_ = open;
  show_facts();
  show_pose();
}

void ExportPreview::show_facts() {
  const auto set = [](QLabel* label, const QString& text) { static_cast<ElidedLabel*>(label)->set_text(text); };
  set(file_, QString::fromStdString(plan_.file.filename().string()));
  set(unit_, plan_.unit == ExportUnit::kMetres ? tr("in metres") : tr("in centimetres"));
  if (!model_.solve() || !open_) {
    for (QLabel* label : {frames_, range_, joints_}) {
      set(label, QStringLiteral("–"));
    }
    tree_->hide();
    return;
  }
  tree_->show();
  const motion::Clip& clip = model_.solve()->clip;
  const ExportRange range = range_of(plan_, clip.duration());
  const QString rate = locale().toString(plan_.fps, 'g', 6);
  set(frames_,
      tr("%1 at %2 Hz").arg(locale().toString(qulonglong(motion::frame_count(range.duration_s(), plan_.fps))), rate));
  set(range_, tr("%1, from %2 to %3")
                  .arg(format_clock_tenths(range.duration_s()), format_clock_tenths(range.begin_s),
                       format_clock_tenths(range.end_s)));
  set(joints_, locale().toString(qulonglong(clip.skeleton.segments.size())));
  show_joints();
}

void ExportPreview::show_joints() {
  const body::Skeleton& skeleton = model_.skeleton();
  const double scale = plan_.unit == ExportUnit::kMetres ? 1.0 : 100.0;
  const QString unit = plan_.unit == ExportUnit::kMetres ? tr("m") : tr("cm");
  const QSignalBlocker quiet(tree_);
  tree_->clear();
  interchange::UniqueNames unique;  // As the writer names them.
  std::vector<QTreeWidgetItem*> items;
  for (std::size_t i = 0; i < skeleton.segments.size(); ++i) {
    const body::Segment& segment = skeleton.segments[i];
    const auto parent = static_cast<std::size_t>(std::max(segment.parent, 0));
    auto* item =
        segment.parent >= 0 && parent < items.size() ? new QTreeWidgetItem(items[parent]) : new QTreeWidgetItem(tree_);
    item->setText(0, QString::fromStdString(unique(interchange::plain_name(segment.name))));
    item->setText(
        1, QStringLiteral("%1 %2").arg(locale().toString(scale * segment.length, 'f', scale > 1.0 ? 1 : 3), unit));
    item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    item->setData(0, Qt::UserRole, static_cast<int>(i));
    items.push_back(item);
  }
  tree_->expandAll();
}

void ExportPreview::show_figure() {
  if (viewer_ != nullptr && model_.solve()) {
    viewer_->set_skeleton(model_.skeleton());
    viewer_->set_extent(motion_extent(model_.solve()->clip, 60));
  }
  if (active_) {
    show_facts();
    show_pose();
  }
}

void ExportPreview::show_pose() {
  const bool shown = open_ && model_.solve() != nullptr;
  other_->setVisible(!open_);
  at_->setVisible(shown);
  if (viewer_ != nullptr) {
    viewer_->setVisible(shown);
  }
  if (!active_ || !shown) {
    return;
  }
  const ExportRange range = range_of(plan_, model_.solve()->clip.duration());
  const std::size_t last = motion::frame_count(range.duration_s(), plan_.fps) - 1;
  // The file stands still between its frames; a little is added for times that lie on one.
  const double passed = std::max(0.0, context_.time().playhead_s() - range.begin_s);
  frame_ = std::min(last, static_cast<std::size_t>(std::floor(passed * plan_.fps + 1e-6)));
  at_->setText(tr("Frame %1 of %2").arg(counted(frame_), counted(last)));
  if (viewer_ != nullptr) {
    model_.pose_at(range.begin_s + static_cast<double>(frame_) / plan_.fps, poses_);
    viewer_->set_pose(poses_);
  }
}

}  // namespace limbwave::ui
