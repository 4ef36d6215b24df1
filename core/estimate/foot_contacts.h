/// Where feet stand: found from the motion of their boards and from the estimate itself, and given to the filter as
/// measurements: a foot that stands has no velocity, and its sole is on the ground. What it says of a free root makes
/// place drift by steps instead of by seconds.
///
/// A foot with a board of its own stands while the board neither turns nor feels more than gravity (a generalised
/// likelihood ratio over a short window, as in Skog et al. 2010, "Zero-velocity detection"); one without stands while
/// its sole is estimated to be slow and low. Both with hysteresis; what is found is gated by χ² against the estimate.
#pragma once

#include <cstdint>
#include <deque>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/diagnostics.h"
#include "estimate/body_filter.h"
#include "estimate/soles.h"

namespace limbwave {
class JsonReader;
}

namespace limbwave::estimate {

struct ContactParameters {
  bool feet = true;                    ///< False: only the whole body's stillness is used.
  double period_s = 0.02;              ///< Between two looks.
  double window_s = 0.08;              ///< Over which boards are judged.
  double rate = 1.2;                   ///< rad/s: a standing foot turns less.
  double force = 2.5;                  ///< m/s²: its specific force is gravity within this, and the same.
  double leave = 6.0;                  ///< Hysteresis: the statistic (1 at the two above) of one word at which a foot
                                       ///< is lifted,
  double doubt = 2.0;                  ///< and that of the window.
  double slow = 0.35, lifted = 0.7;    ///< m/s: speeds at which a foot without a board stands and is lifted.
  double low = 0.05;                   ///< m above its ground within which it may stand.
  double velocity_noise = 0.05;        ///< m/s, of a standing foot; one look is as good as independent of the next.
  double height_noise = 0.015;         ///< m, of a sole on the ground.
  double patience_s = 0.16;            ///< So long the estimate may contradict a standing foot; then it gives way.
  double lost_s = 1.6;                 ///< So long a walker may seem to stand on nothing.
  double still_s = 0.3;                ///< So long all boards must be still for the body to be.
  double still_rate = 0.12;            ///< rad/s, and
  double still_force = 0.4;            ///< m/s²: a body that is still.
  double still_velocity_noise = 0.02;  ///< m/s, of its root.
  double gate_probability = 1e-4;
};

class FootContacts {
 public:
  FootContacts(const BodyModel& model, const ContactParameters& parameters);

  /// The readings of the next instant. `usable`: per board.
  void push(const BodyInstant& instant, const std::vector<char>& usable);
  /// Looks, if it is time, and updates a filter that has just been stepped to `time_s`. `number`: of the instant; one
  /// that comes again gets the same updates, if the filter is the same.
  void update(BodyFilter& filter, std::size_t number, std::vector<UpdateRecord>* records);

  [[nodiscard]] const std::vector<Sole>& soles() const { return soles_; }
  [[nodiscard]] bool standing(std::size_t sole) const { return feet_[sole].standing; }
  [[nodiscard]] int steps(std::size_t sole) const { return feet_[sole].steps; }
  [[nodiscard]] double standing_s(std::size_t sole) const { return feet_[sole].stood_s; }
  [[nodiscard]] Diagnostics findings() const;

  /// All that later instants depend on, and back; decisions about earlier ones are not among it.
  [[nodiscard]] nlohmann::json save() const;
  void load(const JsonReader& saved);

 private:
  struct Word {
    double time_s;
    Vector3d w, f;  // NaN: not measured
  };
  struct Foot {
    bool standing = false;
    bool levelled = false;  // ground is known
    double ground = 0.0;    // height of the sole where it stands, m
    double stood_s = 0.0, rejected_since = -1.0, last_contact = 0.0;
    int steps = 0;
  };
  // What was decided at an instant: numbers of standing feet with their grounds, and what had to give way.
  struct Use {
    int foot = 0;
    bool height = false;
    double ground = 0.0;
  };
  struct Decision {
    std::size_t number = 0;
    bool still = false, gives_way = false;
    std::vector<Use> uses;
  };
  [[nodiscard]] double statistic(int board, bool newest) const;
  [[nodiscard]] bool all_still() const;
  Decision decide(const BodyFilter& filter, std::size_t number);
  void apply(BodyFilter& filter, const Decision& decision, std::vector<UpdateRecord>* records, bool fresh);
  struct SoleMotion {
    body::TreeKinematics::PointMotion point;
    body::PointJacobians jacobians;  // up to those of the velocity
    const std::vector<int>& dofs;
  };
  [[nodiscard]] SoleMotion motion_of(const BodyFilter& filter, const Sole& sole) const;
  [[nodiscard]] MeasurementGroup velocity_group(const BodyFilter& filter, const Sole& sole) const;
  [[nodiscard]] MeasurementGroup height_group(const BodyFilter& filter, const Sole& sole, double ground) const;

  ContactParameters parameters_;
  std::vector<Sole> soles_;
  std::vector<Foot> feet_;
  std::vector<std::deque<Word>> words_;  // per board
  std::vector<char> usable_;
  std::vector<Decision> decisions_;
  double next_look_ = -1e300, still_since_ = -1.0, now_ = 0.0;
  std::size_t looked_ = 0;  // instants below have been decided
  double gates_[4] = {0, 0, 0, 0};
};

}  // namespace limbwave::estimate
