/// Where a free root is, told by the feet that stand, and by all boards where none of them moves.
///
/// A body that is still has no velocity: that is told to the filter. What standing feet tell is kept apart from it
/// (foot_root.h): after every step of the filter its legs are looked at, and the root's way is estimated from them; a
/// smoother's legs are looked at once more, from both sides.
#pragma once

#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/diagnostics.h"
#include "estimate/body_filter.h"
#include "estimate/foot_root.h"
#include "estimate/soles.h"

namespace limbwave {
class JsonReader;
}

namespace limbwave::estimate {

struct ContactParameters {
  bool feet = true;  ///< False: only the whole body's stillness is used.
  FootRootParameters root;
  double look_s = 0.005;               ///< Between two looks at the feet, at least.
  double period_s = 0.02;              ///< Between two looks at stillness.
  double still_s = 0.3;                ///< So long all boards must be still for the body to be.
  double still_rate = 0.12;            ///< rad/s, and
  double still_force = 0.4;            ///< m/s²: a body that is still.
  double still_velocity_noise = 0.02;  ///< m/s, of its root.
};

class FootContacts {
 public:
  FootContacts(const BodyModel& model, const ContactParameters& parameters);

  /// The readings of the next instant. `usable`: per board.
  void push(const BodyInstant& instant, const std::vector<char>& usable);
  /// Looks, if it is time: a filter that has just been stepped is updated where the body is still. `number`: of the
  /// instant; one that comes again gets the same updates, if the filter is the same, and is not looked at again.
  void update(BodyFilter& filter, std::size_t number, std::vector<UpdateRecord>* records);

  /// Whether the feet hold the root: there are feet, and somebody looked at them.
  [[nodiscard]] bool hold_root() const { return parameters_.feet && !soles_.empty(); }
  /// The root by its feet, behind the last look (a few seconds back at most, where a fixed lag asks for it). Only where
  /// `hold_root`, after the first instant.
  [[nodiscard]] RootPlace place(double time_s) const;
  /// A body in a state; `covariance`: rows of the joints' degrees of freedom, for the heading.
  [[nodiscard]] FootLook look_at(const BodyFilter& filter, const BodyState& state, const double* covariance,
                                 long stride) const;
  /// The root's way by looks at a smoothed body, in order of time.
  [[nodiscard]] std::vector<RootPlace> smooth(std::vector<FootLook> looks) const;

  [[nodiscard]] const std::vector<Sole>& soles() const { return soles_; }
  [[nodiscard]] bool standing(std::size_t sole) const { return root_.standing(sole) > 0.5; }
  [[nodiscard]] int steps(std::size_t sole) const { return root_.steps(sole); }
  [[nodiscard]] double standing_s(std::size_t sole) const { return root_.stood_s(sole); }
  [[nodiscard]] Diagnostics findings() const;

  /// All that later instants depend on, and back; decisions about earlier ones are not among it.
  [[nodiscard]] nlohmann::json save() const;
  void load(const JsonReader& saved);

 private:
  struct Word {
    double time_s;
    Vector3d w, f;  // NaN: not measured
  };
  [[nodiscard]] bool all_still() const;
  [[nodiscard]] bool still_at(double time_s) const;
  void rest(BodyFilter& filter, std::vector<UpdateRecord>* records) const;
  void look(const BodyFilter& filter);

  ContactParameters parameters_;
  std::vector<Sole> soles_;
  FootRoot root_;
  std::deque<std::pair<double, RootPlace>> places_;  // of the last looks
  std::vector<std::deque<Word>> words_;              // per board
  std::vector<char> usable_;
  std::vector<std::size_t> still_;   // numbers of instants at which the filter was told so
  std::vector<double> still_times_;  // the same, s
  double next_look_ = -1e300, next_feet_ = -1e300, still_since_ = -1.0, now_ = 0.0, start_speed_ = 0.3;
  std::size_t looked_ = 0;  // instants below have been decided
};

}  // namespace limbwave::estimate
