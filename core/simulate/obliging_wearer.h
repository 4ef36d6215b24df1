/// A wearer who does what is asked: leaves off what was being done, takes a pose of the calibration or turns the
/// sensors, and goes on afterwards. What a live simulator has instead of a person.
#pragma once

#include <memory>
#include <string>

#include "simulate/wearer.h"

namespace limbwave::simulate {

class ObligingWearer {
 public:
  /// `present` goes on as long as nothing is asked. The same settings with the motions "poses" and "range" are what the
  /// same person does when asked.
  ObligingWearer(std::shared_ptr<const Wearer> present, std::shared_ptr<const Wearer> poses,
                 std::shared_ptr<const Wearer> range);

  /// From `time_s` on, which never goes back: the hold of a pose ("pose:GROUP:first"), the turning ("range"), or, when
  /// empty or nothing of these, the own motion again. A person needs a moment to hear and a second and a half to get
  /// there.
  void ask(const std::string& what, double time_s);
  /// As Wearer::specific_force, at times that are not far before the newest ask.
  [[nodiscard]] Vector3d specific_force(int sensor, double time_s) const;
  [[nodiscard]] const std::vector<ActualSensor>& sensors() const { return present_->sensors(); }

 private:
  // Something that is done: a wearer's story, read from a place on.
  struct Doing {
    std::shared_ptr<const Wearer> wearer;
    double begin_s = 0.0;   // when
    double story_s = 0.0;   // where in the story
    double length_s = 0.0;  // of the stretch that is held; 0: the story goes on
    [[nodiscard]] Vector3d force(int sensor, double time_s) const;
  };
  std::shared_ptr<const Wearer> present_, poses_, range_;
  std::string asked_;
  Doing now_, before_;
  double change_s_ = -1e9;  // when `before_` begins to give way
};

}  // namespace limbwave::simulate
