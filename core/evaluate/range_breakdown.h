/// Why clear pairs of a simulated take are not accepted, and whether the failures that ranging computes are true.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "decode/range_reading.h"
#include "evaluate/driver_box_evaluation.h"
#include "evaluate/evaluate.h"
#include "take/take.h"

namespace limbwave::evaluate {

/// One pair and what was so about it by the truth.
struct PairCircumstances {
  double snr_db = 0.0;   ///< In-band peak of the straight sound over the noise: source level, pattern, 1/r, air, limbs.
  double speed = 0.0;    ///< Of the microphone against the source, m/s.
  double range = 0.0;    ///< Metres.
  int sources = 0;       ///< That this microphone saw clearly within the round before, this one with them.
  bool clipped = false;  ///< Its board's chips, or those of the board between the sources, were at an end of their
                         ///< range within the last 0.3 s.
  double in_sight_s = 0.0;  ///< Since when the pair has been clear without a break.
  double into_take_s = 0.0;
};

/// Clear pairs of one kind.
struct RangeGroup {
  std::int64_t clear = 0;
  std::array<std::int64_t, 7> by_verdict{};  ///< Index: decode::RangeVerdict.
  std::int64_t slips = 0;                    ///< Of the accepted ones: off by more than half a wavelength.
  double claimed = 0.0;                      ///< Sum of the failures that were computed for the accepted ones.
  [[nodiscard]] std::int64_t accepted() const {
    return by_verdict[static_cast<std::size_t>(decode::RangeVerdict::kAccepted)];
  }
};

/// Takes readings by pulse and wire, as they come from a decoder. Clear is what DriverBoxComparison calls clear.
class RangeBreakdown {
 public:
  /// `poses`: where segments were; of the same take.
  RangeBreakdown(const DriverBoxTruth& truth, const Truth& poses, const take::TakeInfo& info);
  void add(const decode::RangeReading& reading);

  /// Pairs that the bar of carrier phase speaks of: at least 25 dB in band, microphone and source at most at 3 m/s.
  [[nodiscard]] const RangeGroup& at_bar() const { return at_bar_; }
  [[nodiscard]] const RangeGroup& all() const { return all_; }
  /// By kind of circumstance ("SNR", "speed", ...), then by its value, in order.
  [[nodiscard]] const std::vector<std::pair<std::string, std::map<std::string, RangeGroup>>>& groups() const {
    return groups_;
  }
  /// Likeliest numbers of cycles, of clear pairs or not, by the decade of the failure that was computed: index i holds
  /// those from 10^-(i+1) to 10^-i, the last one all below.
  struct Claim {
    std::int64_t count = 0, wrong = 0;
    double claimed = 0.0;  ///< Sum of the failures.
  };
  [[nodiscard]] const std::array<Claim, 7>& claims() const { return claims_; }

 private:
  struct Wire {
    std::vector<double> clear_since;  // by source, s; < 0: not clear
    std::vector<double> last_clear;
    std::vector<std::pair<double, double>> clipped;  // stretches of time
    const Truth::SegmentTruth* segment = nullptr;
    Eigen::Vector3d p_LS;
  };
  [[nodiscard]] PairCircumstances circumstances(const DriverBoxTruth::Pulse& pulse, int receiver, double time_s) const;
  static Eigen::Vector3d velocity(const Truth::SegmentTruth& segment, const Eigen::Vector3d& p_LS, double time_s);

  const DriverBoxTruth& truth_;
  body::DriverBoxSignal box_;
  std::vector<double> levels_;  // by source
  double rate_hz_, wavelength_, scale_;
  std::vector<Wire> wires_;
  std::vector<std::pair<const Truth::SegmentTruth*, Eigen::Vector3d>> sources_;
  std::vector<std::string> names_;
  int reference_ = -1;
  RangeGroup all_, at_bar_;
  std::vector<std::pair<std::string, std::map<std::string, RangeGroup>>> groups_;
  std::array<Claim, 7> claims_{};
};

}  // namespace limbwave::evaluate
