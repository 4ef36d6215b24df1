/// From what is heard in each slot to ranges: which arrival is the straight one, how far it is to be believed, and how
/// many whole cycles of the carrier lie on its way.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "decode/cycle_tracker.h"
#include "decode/pulse_listener.h"
#include "decode/range_reading.h"
#include "decode/range_tracker.h"

namespace limbwave::decode {

/// A frame that ranging works in: that of a segment with sources.
struct RangingFrame {
  RangingFormat format;  ///< Of one wire, in this frame.
  BoxGeometry geometry;
};

/// One wire's. Slots go through a tracker forward as they come; behind it, stretches of slots go through a copy of it
/// backward, so that a pulse is judged by what came before and by what came after it. Memory: the look-ahead.
class RangeResolver {
 public:
  using Predict = std::function<std::optional<RangePrediction>(int source, Seconds emission)>;

  /// `centroid_s`: from a pulse's start to the middle of its energy.
  RangeResolver(SampleRate rate, int receiver, const std::vector<RangingFrame>& frames,
                const RangingParameters& parameters, double centroid_s);

  void set_prediction(Predict predict) { predict_ = std::move(predict); }
  /// The next slot, as every frame sees it.
  void add(const HeardSlot& heard, std::vector<TrackerStep> steps);
  /// No more slots.
  void finish();
  /// One reading per slot since the last call, in order; at most three times `look_ahead_s` late.
  std::vector<RangeReading> take();

 private:
  static constexpr double kSystematic = 0.4e-3;  // metres, of the envelope beside its noise
  static constexpr double kSurprise = 5.0;       // standard deviations
  static constexpr double kNowhere = 0.6;        // radians, of a direction that is not known
  static constexpr double kFarthest = 3.5;       // standard deviations of the envelope
  /// The likeliest range by the carrier, accepted or not.
  struct Guess {
    double range = 0.0;
    double failure = 1.0;   // probability of other whole cycles
    double variance = 0.0;  // of the phase, m²
  };
  struct Kept {
    HeardSlot heard;
    std::vector<TrackerStep> steps;  // by frame
    RangeReading reading;
    Guess guess;
  };
  struct Direction {
    double angle = 0.0, sd = 0.0;  // off a source's normal, radians
  };
  /// A tracker with its pairs' cycles.
  struct Followed {
    RangeTracker tracker;
    struct Pair {
      CycleTracker cycles;
      Eigen::Vector3d place = Eigen::Vector3d::Zero();        // of the source, in the tracker's frame
      double time_s = 0.0, jerk_sum = 0.0, wander_sum = 0.0;  // at its last pulse
      bool counted = false;                                   // cycles are followed since some pulse,
      bool fixed = false;                                     // and their number is known
      std::int64_t count = 0;                                 // that is counted on
    };
    std::vector<Pair> pairs;
    void pass_on();  ///< Corrections of the tracker to the pairs.
  };
  [[nodiscard]] RangeReading blank(const HeardSlot& heard) const;
  using Frames = std::vector<Followed>;
  [[nodiscard]] RangeReading judge(const HeardSlot& heard, const std::vector<TrackerStep>& steps, Frames& frames,
                                   bool forward, Guess& guess);
  void tell_others(const RangeReading& reading, const std::vector<TrackerStep>& steps, Frames& frames,
                   std::size_t own) const;
  void by_paper(const HeardSlot& heard, const TrackerStep& step, RangeTracker& tracker, RangeReading& reading) const;
  void by_envelope(const HeardSlot& heard, const TrackerStep& step, Followed& followed, bool forward,
                   RangeReading& reading, Guess& guess);
  [[nodiscard]] double misfit_of(const Arrival& arrival,
                                 const std::optional<RangeTracker::Expectation>& expected) const;
  [[nodiscard]] const Arrival& straight(const HeardSlot& heard,
                                        const std::optional<RangeTracker::Expectation>& expected) const;
  void weigh(const RangingSource& source, double range, double amplitude, double noise, const Direction& towards,
             const std::optional<Direction>& worn, RangeReading& reading) const;
  [[nodiscard]] CycleResult resolve(double phase_variance, const TrackerStep& step,
                                    const RangeTracker::Expectation& expected,
                                    const std::optional<RangePrediction>& told, const RangeReading& reading,
                                    Followed& followed) const;
  void follow(const CycleResult& result, double phase_variance, const SourceStep& step, const RangeReading& reading,
              Followed& followed) const;
  void watch(const RangeReading& reading);
  void settle(std::size_t count);
  [[nodiscard]] RangeReading better(const Kept& kept, const RangeReading& backward, const Guess& guess) const;
  [[nodiscard]] std::optional<RangeReading> by_both(const Kept& kept, const RangeReading& backward,
                                                    const Guess& guess) const;
  [[nodiscard]] static std::optional<Direction> by_skeleton(const TrackerStep& step);

  RangingFormat format_;
  SampleRate rate_;
  int receiver_;
  RangingParameters parameters_;
  double centroid_s_, wavelength_;
  Frames frames_;
  std::vector<std::size_t> frame_of_;  // by source: where it does not move
  Predict predict_;
  std::size_t stretch_;  // slots
  std::deque<Kept> kept_;
  struct Slip {
    double mean = 0.0, weight = 0.0;
  };
  Slip slip_;
  std::vector<RangeReading> readings_;
};

}  // namespace limbwave::decode
