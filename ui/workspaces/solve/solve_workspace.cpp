#include "workspaces/solve/solve_workspace.h"

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/core_text.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/latency_text.h"
#include "common/shown_names.h"
#include "common/theme.h"
#include "common/widgets.h"
#include "workspaces/record_banner.h"
#include "workspaces/solve/bone_card.h"
#include "workspaces/solve/quality_text.h"
#include "workspaces/solve/solve_pose.h"

namespace limbwave::ui {

namespace {

constexpr int kLiveStatusMs = 500;
constexpr int kExtentInstants = 60;
constexpr double kLongestWay_m = 12.0;
constexpr int kVerdictIcon = 18;

std::vector<ViewerSensor> viewer_sensors(const body::Rig& rig, const body::Skeleton& skeleton) {
  std::vector<ViewerSensor> list;
  for (const body::Accelerometer& sensor : rig.accelerometers) {
    list.push_back({shown_name(sensor.name), skeleton.find(sensor.segment), sensor.R_LS, sensor.p_LS});
  }
  return list;
}

}  // namespace

SolveWorkspace::SolveWorkspace(StudioContext& context, QWidget* parent)
    : Workspace(parent), context_(context), model_(SolveModel::of(context)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  layout->setSpacing(0);
  layout->addWidget(new RecordBanner(context_, this));
  layout->addWidget(pages_, 1);
  empty_ = new EmptyState(QStringLiteral("solve"), pages_);
  empty_button_ = empty_->add_button(tr("Capture a take"), true);
  pages_->addWidget(empty_);
  main_page_ = make_main_page();
  pages_->addWidget(main_page_);
  live_timer_.setInterval(kLiveStatusMs);
  follow_context();
  show_figure();
  show_state();
  follow_live();
}

void SolveWorkspace::follow_context() {
  connect(&model_, &SolveModel::state_changed, this, &SolveWorkspace::show_state);
  connect(&model_, &SolveModel::solve_changed, this, [this] {
    show_figure();
    show_curves();
    show_state();
    play_first_demo();
  });
  connect(&context_.document(), &TakeDocument::changed, this, [this](bool other) {
    if (other) {
      // What was just opened or recorded is what one wants to see.
      wish_.reset();
      framed_take_ = false;
      follow_live();
    }
  });
  connect(&model_, &SolveModel::evaluation_changed, this, &SolveWorkspace::show_state);
  connect(&model_, &SolveModel::skeleton_changed, this, &SolveWorkspace::show_skeleton);
  connect(retry_, &QPushButton::clicked, &model_, &SolveModel::start);
  connect(calibrate_, &QPushButton::clicked, this, [this] { context_.reveal(QStringLiteral("calibrate")); });
  connect(&model_, &SolveModel::pose_changed, this, &SolveWorkspace::show_pose);
  connect(&context_.time(), &TimeModel::playhead_changed, this, &SolveWorkspace::show_pose);
  connect(&context_.time(), &TimeModel::playing_changed, this, [this](bool playing) {
    if (!playing) {
      end_demo_hint();
    }
  });
  connect(&context_.selection(), &Selection::changed, this, &SolveWorkspace::show_selection);
  const auto choose = [this](int segment) {
    if (segment < 0) {
      context_.selection().clear();
    } else {
      context_.selection().select(SelectionKind::kSegment, segment);
    }
  };
  connect(viewer_, &ViewerWidget::segment_clicked, this, choose);
  connect(curves_, &CurvesPanel::segment_clicked, this, choose);
  connect(&context_.live(), &LiveModel::state_changed, this, &SolveWorkspace::follow_live);
  connect(&context_.live(), &LiveModel::recording_changed, this, &SolveWorkspace::follow_recording);
  connect(&context_.live(), &LiveModel::figure_ready, this, &SolveWorkspace::show_live_figure);
  connect(&live_timer_, &QTimer::timeout, this, &SolveWorkspace::show_live_status);
  connect(viewer_, &ViewerWidget::frame_rendered, this, &SolveWorkspace::note_live_frame);
  viewer_->set_follows(true);
  connect(empty_button_, &QPushButton::clicked, this, [this] {
    if (model_.state() == SolveState::kFailed) {
      model_.start();
    } else {
      context_.reveal(QStringLiteral("capture"));
    }
  });
}

void SolveWorkspace::play_first_demo() {
  const QString setting = QStringLiteral("solve/demo_played");
  const bool demo = context_.document().name().startsWith(QLatin1String("demo-"));
  if (demo && model_.solve() && !context_.settings().value(setting).toBool()) {
    context_.settings().setValue(setting, true);
    context_.time().set_looping(true);
    context_.time().set_playing(true);
    demo_hint_ = context_.notifications().post(
        Severity::kInfo, tr("This is the demo, playing."),
        tr("Space stops it. Drag in the timeline to look at a moment, drag in the picture "
           "to look from elsewhere."));
  }
}

void SolveWorkspace::end_demo_hint() {
  if (demo_hint_ != 0) {
    context_.notifications().dismiss(std::exchange(demo_hint_, 0));
  }
}

void SolveWorkspace::activate() {
  active_ = true;
  model_.set_shows_live(live_);
  follow_live();
  show_live_figure();
  viewer_->setFocus();
}

void SolveWorkspace::deactivate() {
  end_demo_hint();
  active_ = false;
  live_timer_.stop();
  model_.set_shows_live(false);  // Other places speak of the take.
}

void SolveWorkspace::show_state() {
  const SolveState state = model_.state();
  const bool busy = state == SolveState::kSolving || state == SolveState::kLoading;
  const bool figure = live_ || (state != SolveState::kNoTake && (model_.solve() || busy));
  pages_->setCurrentWidget(figure ? main_page_ : empty_);
  curves_->setVisible(!live_ && model_.solve());
  ghost_->setVisible(model_.has_truth() && !live_);
  if (state == SolveState::kNoTake) {
    empty_->set_texts(tr("No take is open"), tr("Capture one, open one, or try a demo from the first page."));
    empty_button_->setText(tr("Capture a take"));
    empty_button_->setVisible(true);
  } else if (state == SolveState::kFailed) {
    const Error& error = model_.error();
    const QString what = as_sentence(core_text(error.message));
    const QString remedy = as_sentence(core_text(error.remedy));
    const QString place = QString::fromStdString(error.place);
    empty_->set_texts(
        tr("This take could not be solved"),
        QStringList{what, remedy, place}.filter(QRegularExpression(QStringLiteral("\\S"))).join(QStringLiteral("\n")));
    empty_button_->setText(tr("Try again"));
  }
  const bool failed_again = state == SolveState::kFailed && model_.solve() && !live_;
  failure_bar_->setVisible(failed_again);
  calibrate_->setVisible(model_.settings().calibration != "nominal");
  show_verdict();
  if (live_) {
    return;
  }
  if (failed_again) {
    // What is seen is the solve from before.
    const Error& error = model_.error();
    failure_->setText(tr("It could not be solved again; what you see is from before. %1 %2")
                          .arg(as_sentence(core_text(error.message)), as_sentence(core_text(error.remedy)))
                          .trimmed());
  }
  if (busy) {
    status_->set_text(state == SolveState::kLoading ? tr("Reading the solve…") : tr("Solving…"));
  } else if (model_.solve()) {
    const motion::Clip& clip = model_.solve()->clip;
    // As the timeline counts and an export writes them: from time 0 on, also before the first reading.
    const std::size_t frames = motion::frame_count(clip.duration(), clip.frame_rate_hz);
    QString facts = tr("%1 of motion, %2 frames at %3 Hz")
                        .arg(format_clock_tenths(clip.duration()), locale().toString(qulonglong(frames)),
                             locale().toString(clip.frame_rate_hz, 'f', 2));
    if (model_.by_inclination()) {
      facts = tr("%1, smoothing: %2").arg(facts, smoothing_name(model_.solve()->settings.smoothing).toLower());
    }
    // The truth, where it is known, tells more than anything else.
    const auto& evaluation = model_.evaluation();
    const QString headline =
        evaluation ? tr("Off the truth by %1.")
                         .arg(error_text(evaluation->all.inclination_mean_deg, evaluation->all.inclination_max_deg))
                   : overall_verdict(model_.solve()->report).text;
    status_->set_text(tr("%1   %2").arg(headline, facts));
  }
}

void SolveWorkspace::show_verdict() {
  const bool judged = !live_ && model_.solve() && model_.state() == SolveState::kSolved;
  verdict_->setVisible(judged);
  if (judged) {
    const auto& evaluation = model_.evaluation();
    const Verdict verdict = overall_verdict(model_.solve()->report, evaluation ? &*evaluation : nullptr);
    verdict_->setPixmap(
        icon_pixmap(tone_icon(verdict.tone), tone_color(palette(), verdict.tone), kVerdictIcon, devicePixelRatioF()));
    verdict_->setToolTip(QStringLiteral("%1 %2").arg(verdict.text, verdict.remedy).trimmed());
    verdict_->setAccessibleName(verdict.text);
  }
  failure_icon_->setPixmap(
      icon_pixmap(tone_icon(Tone::kWarning), tone_color(palette(), Tone::kWarning), kVerdictIcon, devicePixelRatioF()));
}

void SolveWorkspace::changeEvent(QEvent* event) {
  Workspace::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && failure_icon_ != nullptr) {
    show_verdict();
  }
}

void SolveWorkspace::show_skeleton() {
  const solve::LiveSettings& live = context_.live().settings();
  const body::Skeleton& skeleton = live_ ? live.skeleton : model_.skeleton();
  viewer_->set_skeleton(skeleton);
  if (live_) {
    viewer_->set_ghost({});
    viewer_->set_sensors(viewer_sensors(live.rig, skeleton));
  } else if (const auto& take = context_.document().take()) {
    viewer_->set_sensors(viewer_sensors(take->info.rig, skeleton));
  }
  show_selection();
  show_pose();
}

void SolveWorkspace::show_figure() {
  const bool take = !live_ && model_.solve();
  if (live_) {
    viewer_->set_extent(reach_extent(context_.live().settings().skeleton));
  } else {
    // Of a long way only the beginning is framed; the figure is followed from there.
    std::vector<Eigen::Vector3d> extent;
    if (take) {
      extent = motion_extent(model_.solve()->clip, kExtentInstants);
      Eigen::AlignedBox3d box;
      std::for_each(extent.begin(), extent.end(), [&box](const Eigen::Vector3d& point) { box.extend(point); });
      extent = !box.isEmpty() && box.diagonal().norm() > kLongestWay_m ? std::vector<Eigen::Vector3d>() : extent;
    }
    viewer_->set_extent(std::move(extent));
  }
  show_skeleton();
  // The camera is placed once for each capture and each take; then it is the user's.
  bool& framed = live_ ? framed_live_ : framed_take_;
  if ((live_ || take) && !framed) {
    framed = viewer_->isVisible();
    viewer_->frame_all();
  }
}

void SolveWorkspace::show_curves() {
  if (model_.solve()) {
    const motion::Clip& clip = model_.solve()->clip;
    curves_->set_curves(model_.curves(),
                        clip.joints.empty() ? std::vector<double>() : clip.joints.front().rotation.times);
  } else {
    curves_->set_curves(nullptr, {});
  }
}

void SolveWorkspace::show_pose() {
  if (live_) {
    return;
  }
  const double now = context_.time().playhead_s();
  model_.pose_at(now, poses_);
  if (!poses_.empty()) {
    viewer_->set_pose(poses_);
    viewer_->set_ghost(model_.truth_at(now));
  }
}

void SolveWorkspace::show_selection() {
  const int segment = segment_of_selection(context_.selection().item(), model_);
  viewer_->select(segment);
  curves_->select_segment(segment);
}

void SolveWorkspace::reveal(const QString& topic) {
  if (topic == QLatin1String("latency")) {
    wish_ = true;
    follow_live();
  } else if (topic.startsWith(QLatin1String("sensor:"))) {
    context_.selection().select(SelectionKind::kSensor, topic.mid(7).toInt());
  }
}

void SolveWorkspace::keyPressEvent(QKeyEvent* event) {
  // F and the views work wherever in the workspace the focus is.
  if (!viewer_->handle_key(event->key(), event->modifiers())) {
    Workspace::keyPressEvent(event);
  }
}

}  // namespace limbwave::ui
