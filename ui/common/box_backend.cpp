#include "common/box_backend.h"

#include <QCoreApplication>
#include <algorithm>
#include <mutex>

#include "acquire/box_ports.h"
#include "solve/compose.h"
#include "solve/live_body_session.h"
#include "take/box_opening.h"

namespace limbwave::ui {
namespace {

constexpr double kPosesHz = 60.0;  // as screens show them

/// lupdate knows this as the context "BoxWords".
struct BoxWords {
  Q_DECLARE_TR_FUNCTIONS(BoxWords)
};

std::string words(const QString& text) {
  return text.toStdString();
}

solve::SensorHealth wire_health(const solve::BoxWire& wire, bool connected) {
  using solve::HealthState;
  if (!connected) {
    return {HealthState::kBad, "box-away", words(BoxWords::tr("the box is away"))};
  }
  if (!wire.plugged) {
    return {HealthState::kBad, "wire-pulled", words(BoxWords::tr("its wire is pulled out of the box"))};
  }
  if (wire.clipped) {
    return {HealthState::kWarning, "clipped", words(BoxWords::tr("its signal is at full scale"))};
  }
  if (!wire.locked) {
    return wire.frames == 0 && wire.level <= 0.0
               ? solve::SensorHealth{}
               : solve::SensorHealth{HealthState::kBad, "no-words",
                                     words(BoxWords::tr("its words are not understood; check the wire and the board"))};
  }
  if (wire.state == estimate::BoardState::kSilent) {
    return {HealthState::kBad, "silent", words(BoxWords::tr("it has fallen silent"))};
  }
  if (wire.state == estimate::BoardState::kFrozen) {
    return {HealthState::kBad, "frozen", words(BoxWords::tr("it says the same for ever; switch the board off and on"))};
  }
  return {HealthState::kGood, "good", "good"};
}

class BoxBackend : public LiveBackend {
 public:
  BoxBackend(std::unique_ptr<acquire::BoxSource> box, const solve::LiveBodySettings& settings)
      : skeleton_(settings.skeleton),
        sensed_(settings.skeleton.segments.size(), false),
        session_(std::move(box), settings) {
    for (const int segment : solve::sensor_segments(settings.rig, skeleton_)) {
      if (segment >= 0) {
        sensed_[static_cast<std::size_t>(segment)] = true;
      }
    }
  }
  Status start() override { return session_.start(); }
  void stop() override { (void)session_.stop(); }
  Status start_recording(const std::filesystem::path& folder, const std::string& subject) override {
    return session_.start_recording(folder, subject);
  }
  Result<take::Take> stop_recording() override { return session_.stop_recording(); }
  std::optional<take::TakeEvent> mark(const std::string& text) override { return session_.mark(text); }
  bool write_event(const take::TakeEvent& event) override { return session_.write_event(event); }
  // Boards come calibrated; the body filter estimates what is left.
  void set_calibration(const calibrate::RigCalibration& /*calibration*/) override {}
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) override;
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override;
  [[nodiscard]] std::shared_ptr<const solve::LiveFigure> figure() const override;
  void on_figure(std::function<void()> told) override { session_.on_figure(std::move(told)); }

 private:
  void turn(std::vector<body::SegmentPose>& pose) const;

  body::Skeleton skeleton_;
  std::vector<bool> sensed_;
  solve::LiveBodySession session_;
  mutable std::mutex mutex_;
  std::vector<double> turns_;            ///< By segment, radians, the user's; empty: none.
  mutable acquire::BoxCounters before_;  ///< The recording, or until now.
  mutable std::shared_ptr<const solve::LiveSnapshot> last_;
};

void BoxBackend::set_headings(const std::vector<std::vector<solve::HeadingKey>>& headings) {
  std::vector<double> turns(skeleton_.segments.size(), 0.0);
  for (std::size_t s = 0; s < std::min(turns.size(), headings.size()); ++s) {
    turns[s] = headings[s].empty() ? 0.0 : headings[s].back().heading;  // those of live figures hold from now on
  }
  if (std::all_of(turns.begin(), turns.end(), [](double turn) { return turn == 0.0; })) {
    turns.clear();
  }
  const std::scoped_lock lock(mutex_);
  turns_ = std::move(turns);
}

// As it is done to a solved take: the filter knows nothing of it.
void BoxBackend::turn(std::vector<body::SegmentPose>& pose) const {
  if (turns_.size() != pose.size() || pose.empty()) {
    return;
  }
  std::vector<Eigen::Quaterniond> R_WL;
  R_WL.reserve(pose.size());
  for (const body::SegmentPose& segment : pose) {
    R_WL.push_back(segment.R_WL);
  }
  solve::turn_segments(skeleton_, sensed_, turns_, R_WL);
  pose = body::poses_from_orientations(skeleton_, R_WL, pose.front().p_WL);
}

std::shared_ptr<const solve::LiveFigure> BoxBackend::figure() const {
  std::shared_ptr<const solve::LiveFigure> figure = session_.figure();
  const std::scoped_lock lock(mutex_);
  if (!figure || turns_.empty()) {
    return figure;
  }
  auto turned = std::make_shared<solve::LiveFigure>(*figure);
  turn(turned->pose);
  return turned;
}

std::shared_ptr<const solve::LiveSnapshot> BoxBackend::snapshot() const {
  const std::shared_ptr<const solve::LiveBodySnapshot> now = session_.snapshot();
  const std::scoped_lock lock(mutex_);
  if (last_ && last_->box == now) {
    return last_;
  }
  auto next = std::make_shared<solve::LiveSnapshot>();
  next->box = now;
  next->version = now->version;
  next->stream_time_s = now->stream_time_s;
  next->format = now->format;
  for (const solve::BoxWire& wire : now->wires) {
    next->health.push_back(wire_health(wire, now->connected));
  }
  next->pose = now->pose;
  turn(next->pose);
  next->pose_time_s = now->pose_time_s;
  next->diagnostics = now->diagnostics;
  // While it records, those of the recording.
  if (!now->recording) {
    before_ = now->counters;
  }
  next->counters.overflows = now->recording ? now->counters.gaps - before_.gaps : now->counters.gaps;
  next->counters.dropped_frames =
      now->recording ? now->counters.lost_frames - before_.lost_frames : now->counters.lost_frames;
  next->recording = now->recording;
  next->take_folder = now->take_folder;
  next->recorded_s = now->recorded_s;
  next->disk_left_s = now->disk_left_s;
  next->recording_error = now->recording_error;
  next->latency = now->latency;
  next->latency_mean_s = now->latency.of(solve::LatencyStage::kTotal).mean_s;
  next->latency_max_s = now->latency.of(solve::LatencyStage::kTotal).max_s;
  last_ = std::move(next);
  return last_;
}

}  // namespace

Result<std::unique_ptr<LiveBackend>> open_box_backend(const std::string& id, const DeviceSetup& setup,
                                                      solve::LiveSettings& settings) {
  if (setup.height_m > 0.0 && settings.skeleton.height > 0.0) {
    settings.rig = body::scaled(std::move(settings.rig), setup.height_m / settings.skeleton.height);
    settings.skeleton = body::scaled_to_height(settings.skeleton, setup.height_m);
  }
  const std::string port = acquire::box_port(id);
  calibrate::RangingCalibration ranging;
  ranging.method = "nominal";
  if (!setup.ranging_take.empty()) {
    auto measured = take::ranging_of(setup.ranging_take, settings.rig);
    if (!measured) {
      return measured.error();
    }
    ranging = std::move(measured).value();
  }
  // Delays belong to the sources, the speed of sound to the day.
  ranging.speed_of_sound = calibrate::speed_of_sound(setup.temperature_c, setup.humidity / 100.0);
  auto box = take::open_box(port, setup.rate_hz, settings.rig);
  if (!box) {
    Error error = box.error();
    error.place = error.place == port ? id : error.place;
    return error;
  }
  solve::LiveBodySettings body;
  body.rig = settings.rig;
  body.skeleton = settings.skeleton;
  body.ranging = std::move(ranging);
  body.solve.root = "contacts";
  body.solve.rate_hz = kPosesHz;
  return std::unique_ptr<LiveBackend>(std::make_unique<BoxBackend>(std::move(box).value(), body));
}

}  // namespace limbwave::ui
