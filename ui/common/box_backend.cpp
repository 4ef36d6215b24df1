#include "common/box_backend.h"

#include <QCoreApplication>
#include <algorithm>
#include <mutex>

#include "acquire/box_ports.h"
#include "acquire/driver_box.h"
#include "acquire/driver_box_card.h"
#include "solve/live_body_session.h"
#include "take/driver_box_recording.h"

namespace limbwave::ui {
namespace {

constexpr double kCardRate = 192000.0;
constexpr double kPosesHz = 60.0;  // as screens show them
constexpr const char* kClient = "limbwave";

/// lupdate knows this as the context "BoxWords".
struct BoxWords {
  Q_DECLARE_TR_FUNCTIONS(BoxWords)
};

std::string words(const QString& text) {
  return text.toStdString();
}

solve::SensorHealth wire_health(const solve::BoxWire& wire) {
  using solve::HealthState;
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
  BoxBackend(std::unique_ptr<acquire::BoxSource> box, solve::LiveBodySettings settings)
      : session_(std::move(box), std::move(settings)) {}
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
  void set_headings(const std::vector<std::vector<solve::HeadingKey>>& /*headings*/) override {}
  [[nodiscard]] std::shared_ptr<const solve::LiveSnapshot> snapshot() const override;
  [[nodiscard]] std::shared_ptr<const solve::LiveFigure> figure() const override { return session_.figure(); }
  void on_figure(std::function<void()> told) override { session_.on_figure(std::move(told)); }

 private:
  solve::LiveBodySession session_;
  mutable std::mutex mutex_;
  mutable std::shared_ptr<const solve::LiveSnapshot> last_;
};

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
    next->health.push_back(wire_health(wire));
  }
  next->pose = now->pose;
  next->pose_time_s = now->pose_time_s;
  next->diagnostics = now->diagnostics;
  next->counters.overflows = now->counters.gaps;
  next->counters.dropped_frames = now->counters.lost_frames;
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

Result<std::unique_ptr<acquire::BoxSource>> open_source(const std::string& port, const DeviceSetup& setup,
                                                        body::Rig& rig) {
  if (!acquire::is_card_port(port)) {
    auto box = acquire::DriverBox::open(port);
    if (!box) {
      return box.error();
    }
    return std::unique_ptr<acquire::BoxSource>(std::move(box).value());
  }
  rig = take::rig_at_rate(std::move(rig), setup.rate_hz > 0.0 ? setup.rate_hz : kCardRate);
  acquire::CardBoxSettings card;
  card.rate_hz = rig.driver_box->rate_hz;
  card.wires = static_cast<int>(rig.microphones.size());
  card.sources = static_cast<int>(rig.sources.size());
  card.slot_samples = rig.driver_box->slot_samples;
  card.pulse_hz = rig.driver_box->pulse_hz;
  card.pulse_cycles = rig.driver_box->pulse_cycles;
  card.client = kClient;
  return acquire::open_card_box(port, card);
}

}  // namespace

Result<std::unique_ptr<LiveBackend>> open_box_backend(const std::string& id, const DeviceSetup& setup,
                                                      solve::LiveSettings& settings) {
  if (!settings.rig.driver_box) {
    return Error{"has no driver box", "rig \"" + settings.rig.name + "\"",
                 "use driver-box-body or another with a driver box"};
  }
  if (setup.height_m > 0.0 && settings.skeleton.height > 0.0) {
    settings.rig = body::scaled(std::move(settings.rig), setup.height_m / settings.skeleton.height);
    settings.skeleton = body::scaled_to_height(settings.skeleton, setup.height_m);
  }
  const std::string port = acquire::box_port(id);
  auto box = open_source(port, setup, settings.rig);
  if (!box) {
    Error error = box.error();
    error.place = error.place == port ? id : error.place;
    return error;
  }
  solve::LiveBodySettings body;
  body.rig = settings.rig;
  body.skeleton = settings.skeleton;
  body.ranging.method = "nominal";
  body.ranging.speed_of_sound = calibrate::speed_of_sound(setup.temperature_c, setup.humidity / 100.0);
  body.solve.root = "contacts";
  body.solve.rate_hz = kPosesHz;
  return std::unique_ptr<LiveBackend>(std::make_unique<BoxBackend>(std::move(box).value(), std::move(body)));
}

}  // namespace limbwave::ui
