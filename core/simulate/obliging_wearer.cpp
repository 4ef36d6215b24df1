#include "simulate/obliging_wearer.h"

#include <algorithm>
#include <cmath>

#include "simulate/range_turns.h"

namespace limbwave::simulate {
namespace {

constexpr double kReaction = 0.3;  // s from the word to the movement
constexpr double kMove = 1.5;      // s from what was done to what is asked
constexpr double kEdge = 0.2;      // s at both ends of a hold that still belong to moving

// Between two specific forces: over the sphere, so that its length stays that of what is felt.
Vector3d between(const Vector3d& a, const Vector3d& b, double s) {
  const double lengths = a.norm() * b.norm();
  if (lengths < 1e-9) {
    return (1.0 - s) * a + s * b;
  }
  const double angle = std::acos(std::clamp(a.dot(b) / lengths, -1.0, 1.0));
  if (angle < 1e-6) {
    return (1.0 - s) * a + s * b;
  }
  Vector3d across = b / b.norm() - std::cos(angle) * (a / a.norm());
  // Opposite directions: any way round.
  across = across.norm() > 1e-6 ? across.normalized() : a.unitOrthogonal();
  const double length = (1.0 - s) * a.norm() + s * b.norm();
  return length * (std::cos(s * angle) * (a / a.norm()) + std::sin(s * angle) * across);
}

}  // namespace

ObligingWearer::ObligingWearer(std::shared_ptr<const Wearer> present, std::shared_ptr<const Wearer> poses,
                               std::shared_ptr<const Wearer> range)
    : present_(std::move(present)),
      poses_(std::move(poses)),
      range_(std::move(range)),
      now_{present_},
      before_{present_} {}

// A hold lasts as long as it is asked for: its middle again and again.
Vector3d ObligingWearer::Doing::force(int sensor, double time_s) const {
  const double passed = std::max(0.0, time_s - begin_s);
  return wearer->specific_force(sensor, story_s + (length_s > 0.0 ? std::fmod(passed, length_s) : passed));
}

void ObligingWearer::ask(const std::string& what, double time_s) {
  if (what == asked_) {
    return;
  }
  asked_ = what;
  Doing next{present_, 0.0, 0.0, 0.0};
  const auto& own = what == "range" ? range_ : poses_;
  for (const ScriptSegment& segment : own->segments()) {
    if (segment.name == what) {
      next = {own, time_s + kReaction, segment.start_s, 0.0};
      if (what != "range") {
        next.story_s += kEdge;
        next.length_s = segment.end_s - segment.start_s - 2.0 * kEdge;
      }
    }
  }
  // Asked while still moving, it is from where the last one was to lead.
  before_ = now_;
  now_ = next;
  change_s_ = time_s + kReaction;
}

Vector3d ObligingWearer::specific_force(int sensor, double time_s) const {
  if (time_s >= change_s_ + kMove) {
    return now_.force(sensor, time_s);
  }
  if (time_s <= change_s_) {
    return before_.force(sensor, time_s);
  }
  const double s = smooth_step(time_s, change_s_, kMove).v;
  return between(before_.force(sensor, time_s), now_.force(sensor, time_s), s);
}

}  // namespace limbwave::simulate
