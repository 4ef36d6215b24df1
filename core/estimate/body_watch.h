/// Everything around the body filter that a whole recording needs: the start from rest, boards that fail, silence of
/// all sensors, stillness and standing feet. The same live and offline: it depends on readings and their order alone.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimate/body_step_hook.h"
#include "estimate/foot_contacts.h"
#include "estimate/rest_start.h"
#include "estimate/sensor_watch.h"

namespace limbwave::estimate {

struct BodyWatchParameters {
  RestParameters rest;
  SensorWatchParameters sensors;
  ContactParameters contacts;
  bool stillness = true;  ///< A free root stands while all boards are still: gravity and no velocity.
  // A joint whose own board is not heard, or that no board tells of: what is known of how people move, ten times a
  // second.
  double idle_rate = 1.5, idle_acceleration = 15.0;  ///< rad/s, rad/s².
  double idle_pose = 6.0;                            ///< rad at every look: 1 rad about the rest pose in the long run.
};

/// A filter's mind and the watch's: what a recording is resumed from.
struct BodyMind {
  BodyFilter::Snapshot filter;
  std::vector<double> above;  ///< P above its diagonal, row by row: rounding may have made it another than below.
  std::string watch_text;     ///< JSON.
  int states = 0, boards = 0;
};

class BodyWatch : public BodyStepHook {
 public:
  BodyWatch(const BodyModel& model, const BodyWatchParameters& parameters);

  Result<Diagnostics> start(BodyFilter& filter, const BodyReadings& readings) override;
  BodyInstant before(BodyFilter& filter, const BodyInstant& instant, std::size_t number, StepRecord* record) override;
  void after(BodyFilter& filter, const BodyInstant& instant, std::size_t number, StepRecord* record) override;
  [[nodiscard]] const FootContacts* feet() const override {
    return looks_at_feet_ && contacts_.hold_root() ? &contacts_ : nullptr;
  }
  void finished(const BodyFilter& filter) override;

  [[nodiscard]] const SensorWatch& sensors() const { return sensors_; }
  [[nodiscard]] const FootContacts& contacts() const { return contacts_; }
  /// Per board: what it felt at rest showed that it is mounted another way; it is left out.
  [[nodiscard]] const std::vector<char>& turned() const { return turned_; }
  /// What happened since the start, in the user's words.
  [[nodiscard]] Diagnostics findings() const;

  /// The next `start` resumes from this mind instead. Fails when it is of another rig, skeleton or settings.
  Status resume_from(const BodyMind& mind, const BodyFilter& filter);
  void resume_from(BodyMind mind) { mind_ = std::move(mind); }
  /// The next starts are near this state, which was found from what follows (moving_start.h).
  void start_near(BodyState state) { near_ = std::move(state); }
  /// The mind behind the last step; `finished` keeps it.
  [[nodiscard]] BodyMind mind(const BodyFilter& filter) const;
  [[nodiscard]] const std::optional<BodyMind>& last_mind() const { return last_mind_; }

 private:
  struct Gap {
    std::size_t number;
    double seconds;
  };
  struct Usable {
    std::size_t from;  // number of the first instant
    std::vector<char> boards;
  };
  void begin_near(BodyFilter& filter, bool root_given) const;
  [[nodiscard]] std::vector<char> usable_boards() const;
  [[nodiscard]] bool any_idle(const std::vector<char>& usable) const;
  [[nodiscard]] std::vector<char> idle_segments(const std::vector<char>& usable) const;
  [[nodiscard]] const std::vector<char>& usable_at(std::size_t number) const;
  void bridge(BodyFilter& filter, double time_s, double seconds) const;
  void rest_idle_joints(BodyFilter& filter, const std::vector<char>& usable, StepRecord* record) const;
  void look(const BodyInstant& instant, std::size_t number);

  BodyWatchParameters parameters_;
  BodyModel model_;
  SensorWatch sensors_;
  FootContacts contacts_;
  std::size_t seen_ = 0;  // instants below have been looked at
  std::vector<Gap> gaps_;
  std::vector<Usable> usable_;
  std::vector<std::size_t> idle_looks_;
  double next_idle_look_ = -1e300, now_ = 0.0;
  bool looks_at_feet_ = false;
  bool idles_ = false;                         // some joints are told of by no board
  std::vector<char> turned_;                   // boards that are mounted another way than the rig says
  std::vector<int> board_rank_, source_rank_;  // by segment and name
  std::vector<InertialReading> kept_;
  std::vector<RangeReading> kept_ranges_;
  std::optional<BodyMind> mind_, last_mind_;
  std::optional<BodyState> near_;
};

/// A mind as text (JSON) and back. Fails for what is none, naming the key.
std::string mind_to_text(const BodyMind& mind);
Result<BodyMind> mind_from_text(const std::string& text, const std::string& place);

}  // namespace limbwave::estimate
