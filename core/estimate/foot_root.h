/// Where a walker's root goes, told by the feet that stand.
///
/// The body filter knows limbs and their inclination from gyroscopes, gravity and ranges; none of these tells where the
/// body as a whole goes. Feet tell that and little else, and what they tell is rough: soles roll, slide and sink, by 5
/// to 12 cm/s while they "stand" on recorded motions, and the same way through a whole step. Taken as measurements of
/// the whole body they bend legs and tilt the trunk, because that is how a filter without a better explanation makes
/// them come true (README.md, "Feet"). So they are taken in two steps: the body first, with a free root; then the
/// root's way alone, from the body's legs. The first is never worse for what the second believes.
///
/// States, per axis of the world: place p and velocity v of the root, an error b of its acceleration as the body has it
/// (gravity that leaks in by a tilt), and a slip u of every foot that lasts through its step. A standing sole's
/// material point at the ground has the velocity u: with ṙ its velocity about the root, v + ṙ − u = 0. That a foot
/// stands is a probability (a hidden Markov chain, on how fast and how low the sole is and how it turns), which weighs
/// what it says; one that stands is where the ground is.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <vector>

namespace limbwave {
class JsonReader;
}

namespace limbwave::estimate {

using Eigen::Vector3d;

/// Standard deviations, SI.
struct FootRootParameters {
  double slip = 0.05, slip_time = 0.3;  ///< m/s, of a standing sole, and for how long it stays the same, s.
  double jitter = 0.03;                 ///< m/s, of a sole's speed as the body has it, in one of 100 looks a second.
  double roll = 0.04;                   ///< m: how far the point that stands may lie from where it is thought to.
  double swing = 0.9;                   ///< m/s, of a foot that does not stand.
  double turn = 3.0;                    ///< rad/s: of a standing foot.
  double low = 0.03;                    ///< m above the lower sole.
  double carries = 1.5;                 ///< Log odds that the lower sole stands, nothing else known.
  double leak = 0.4, leak_time = 2.0;   ///< m/s²: error of the root's acceleration, and for how long, s.
  double walk = 0.3;                    ///< m/s per √s, of the root's velocity beside it.
  double height = 0.02;                 ///< m, of a sole on the ground.
  double step = 0.06;                   ///< m: another height is another ground (a stair).
  double still = 0.02;                  ///< m/s, of a body whose boards are all still.
  double stance_time = 0.5, swing_time = 0.4;  ///< s, of the Markov chain.
  double evidence_time = 0.015;                ///< s: looks nearer to each other say the same.
  double doubt = 0.3;                          ///< So much of (speed / its own σ)² is nothing strange.
  double patience = 0.6;                       ///< s: so long nobody stands before the estimate gives way.
  double lengths = 0.03;                       ///< Of a leg: what a way is wrong in proportion to itself.
};

/// A body at an instant, as it is known without its feet.
struct FootLook {
  double time_s = 0.0;
  Vector3d root_p = Vector3d::Zero();  ///< The free root's place; of the first look it is where the way begins.
  Vector3d root_a = Vector3d::Zero();  ///< Its acceleration since the look before, m/s².
  struct Sole {
    Vector3d heel = Vector3d::Zero(), toe = Vector3d::Zero();  ///< From the root's place, in the world's directions.
    Vector3d heel_v = Vector3d::Zero(), toe_v = Vector3d::Zero();  ///< Their velocities about it.
  };
  std::vector<Sole> soles;
  double heading = 0.0;  ///< Standard deviation of where ahead is, rad.
  bool still = false;    ///< No board moves.
};

/// Where the root is by its feet.
struct RootPlace {
  Vector3d p = Vector3d::Zero(), sigma = Vector3d::Zero();  ///< m
};

class FootRoot {
 public:
  FootRoot(std::size_t feet, const FootRootParameters& parameters);

  /// `speed`: standard deviation of the root's velocity at the first look, m/s.
  void start(double speed) { start_speed_ = speed; }
  /// The next look; returns what is known from those up to it.
  RootPlace push(const FootLook& look);
  [[nodiscard]] const Vector3d& begin() const { return begin_; }  ///< Where the first look had it.
  [[nodiscard]] bool started() const { return started_; }
  /// Where it is a little after the last look.
  [[nodiscard]] RootPlace place(double time_s) const;
  /// Probability that a foot stands.
  [[nodiscard]] double standing(std::size_t foot) const { return feet_[foot].standing; }
  [[nodiscard]] double stood_s(std::size_t foot) const { return feet_[foot].stood_s; }  ///< Seconds, weighed by it.
  [[nodiscard]] int steps(std::size_t foot) const { return feet_[foot].steps; }
  [[nodiscard]] double looked_s() const { return looked_s_; }    ///< Since the first look.
  [[nodiscard]] double carried_s() const { return carried_s_; }  ///< Of these, with a foot that held the root.

  [[nodiscard]] nlohmann::json save() const;
  void load(const JsonReader& saved);

  /// The same from both sides: all looks of a take, in order of time. Accelerations and velocities are taken from
  /// places, which a smoother has without jumps.
  static std::vector<RootPlace> smooth(std::vector<FootLook> looks, const FootRootParameters& parameters, double speed);

 private:
  struct Foot {
    double standing = 0.5, stood_s = 0.0;
    double ground = 0.0;
    bool levelled = false, down = false;
    int steps = 0;
  };
  // Along the ground both axes have the same covariance.
  struct Kept {
    Eigen::MatrixXd x_before, x, P_before, P, Pz_before, Pz, F;
    double ground_variance = 0.0;
  };
  struct Contact {
    Vector3d velocity = Vector3d::Zero();  // of the material point at the ground about the root
    double variance = 0.0, height = 0.0, turn = 0.0;
  };
  [[nodiscard]] Contact contact(const FootLook::Sole& sole, double dt) const;
  void predict(const FootLook& look, double dt, Kept* kept);
  void observe_velocity(std::size_t foot, const Vector3d& innovation, double variance);
  void observe_height(double innovation, double variance);
  [[nodiscard]] double log_odds(const Contact& c, double lowest, const Vector3d& v, double variance,
                                double variance_z) const;
  [[nodiscard]] RootPlace place_of(const Eigen::MatrixXd& x, double variance, double variance_z, double heading) const;
  RootPlace advance(const FootLook& look, const std::vector<double>* standing, Kept* kept);

  FootRootParameters p_;
  std::vector<Foot> feet_;
  Eigen::MatrixXd x_;  // states × 3 axes
  Eigen::MatrixXd P_, Pz_;
  Vector3d begin_ = Vector3d::Zero();
  bool started_ = false;
  double time_s_ = 0.0, heading_ = 0.0, start_speed_ = 0.3;
  double alone_s_ = 0.0;          // since a foot stood
  double ground_variance_ = 0.0;  // of the ground's height, m²: another ground is as high as it seems
  double carried_s_ = 0.0, looked_s_ = 0.0;
};

}  // namespace limbwave::estimate
