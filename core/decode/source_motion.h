/// How sources and boards move among each other: the frame that ranging works in, and about where everything is in it,
/// from the inertial words and the skeleton.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "decode/inertial_trace.h"
#include "decode/ranging_format.h"

namespace limbwave::decode {

/// How boards and sources hang together. Frame C is that of one segment with sources; places are in C, at
/// rest, metres.
struct BoxGeometry {
  /// One piece of the way from C to a point: from `from` on, the way turns with the board of `wire`.
  struct Link {
    int wire = -1;  ///< -1: with C itself.
    Eigen::Vector3d from = Eigen::Vector3d::Zero();
  };
  int reference = -1;                                         ///< Wire of a board on C's segment; -1: none.
  Eigen::Vector3d reference_place = Eigen::Vector3d::Zero();  ///< Of that board.
  std::vector<Eigen::Quaterniond> R_CS_rest;                  ///< By wire: board's axes to C.
  std::vector<std::vector<Link>> boards, sources;             ///< By wire, by source: joint after joint.
  std::vector<bool> complete;                                 ///< By source: every joint's segment has a board.
  std::vector<Eigen::Vector3d> board_places;                  ///< By wire.
};

/// What a board did over a slot, and where the skeleton puts it.
struct BoardStep {
  FeltMotion felt;
  bool placed = false;
  Eigen::Quaterniond R_CS = Eigen::Quaterniond::Identity();  ///< Its axes to C, good to a few degrees, heading less.
  /// From the reference board, in C, and its change in axes that do not turn; m, m/s: good to a tenth of a limb.
  Eigen::Vector3d place = Eigen::Vector3d::Zero(), velocity = Eigen::Vector3d::Zero();
  double place_sd = 0.0;  ///< Of `place`, metres: by what the headings on the way are known.
};

/// One slot: what the frame did since the slot before, and the source that fires.
struct SourceStep {
  double time_s = 0.0, dt = 0.0;                    ///< Of the pulse's middle; since the slot before.
  Eigen::Vector3d w_C = Eigen::Vector3d::Zero();    ///< Angular velocity of C, mean over dt.
  Eigen::Vector3d f_C = Eigen::Vector3d::Zero();    ///< Specific force at the reference board, likewise.
  bool known = false;                               ///< Both of them.
  Eigen::Vector3d place = Eigen::Vector3d::Zero();  ///< Of the source, from the reference board, in C, metres.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  static constexpr std::size_t kSources = 8;
  std::array<double, kSources> turning{};  ///< How fast the segment of each source turns against C, rad/s.
};

class SourceMotion {
 public:
  SourceMotion(const RangingFormat& format, BoxGeometry geometry);

  [[nodiscard]] const BoxGeometry& geometry() const { return geometry_; }
  /// The next slot, whose pulse of `source` has its middle at `time_s`; `traces` by wire.
  void step(int source, double time_s, const std::vector<InertialTrace>& traces);
  /// Slots that there are: [first(), end()).
  [[nodiscard]] std::int64_t first() const { return first_; }
  [[nodiscard]] std::int64_t end() const { return first_ + static_cast<std::int64_t>(steps_.size()); }
  [[nodiscard]] const SourceStep& at(std::int64_t slot) const {
    return steps_[static_cast<std::size_t>(slot - first_)].source;
  }
  [[nodiscard]] const BoardStep& board(std::int64_t slot, int wire) const {
    return steps_[static_cast<std::size_t>(slot - first_)].boards[static_cast<std::size_t>(wire)];
  }
  void forget(std::int64_t before);

 private:
  struct Board {
    Eigen::Quaterniond turned = Eigen::Quaterniond::Identity();  // in C, away from rest
    Eigen::Vector3d f_mean = Eigen::Vector3d::Zero(), f_mean_C = Eigen::Vector3d::Zero();
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double turning = 0.0;
    bool started = false, placed = false;
    // In its own axes as they are C's at rest: means over the last slot, and angular acceleration.
    Eigen::Vector3d w = Eigen::Vector3d::Zero(), f = Eigen::Vector3d::Zero(), w_dot = Eigen::Vector3d::Zero();
    bool felt = false, felt_before = false;
    // Level forces at the joint as the next board feels them and as this one does: Σ cross, Σ dot, Σ squares.
    double cross = 0.0, dot = 0.0, information = 0.0;
  };
  /// The joint between a board and the one before it on the way from C (-1: C's own).
  struct Joint {
    int before = -1;
    Eigen::Vector3d place = Eigen::Vector3d::Zero();  // at rest, in C
    bool known = false;
  };
  struct Step {
    SourceStep source;
    std::vector<BoardStep> boards;
  };
  void turn(std::size_t wire, const SourceStep& step, const FeltMotion& felt);
  void head(std::size_t wire, const SourceStep& step);
  [[nodiscard]] double place_sd(std::size_t wire) const;
  [[nodiscard]] Eigen::Vector3d reached(const std::vector<BoxGeometry::Link>& way, const Eigen::Vector3d& end) const;
  [[nodiscard]] const Board* carrier(const std::vector<BoxGeometry::Link>& way) const;

  std::vector<RangingSource> sources_;
  BoxGeometry geometry_;
  std::vector<Board> boards_;
  std::vector<Joint> joints_;  // by wire
  std::deque<Step> steps_;
  std::int64_t first_ = 0;
  double last_s_ = -1.0;
};

}  // namespace limbwave::decode
