#include "evaluate/range_breakdown.h"

#include <gtest/gtest.h>

#include <cmath>

#include "body/rig.h"
#include "solve/driver_box.h"

namespace limbwave::evaluate {
namespace {

constexpr double kRate = 140000.0;
constexpr int kSlot = 1120;

// The shipped rig, whose segments stand still; readings are written by hand.
class RangeBreakdownTest : public ::testing::Test {
 protected:
  RangeBreakdownTest() {
    info_.rig = body::load_rig("driver-box-body").value();
    info_.format.rate = SampleRate{kRate};
    truth_.snr_db = 25.0;
    truth_.speed_of_sound = solve::ranging_calibration(info_).speed_of_sound;
    wavelength_ = truth_.speed_of_sound / info_.rig.driver_box->pulse_hz;
    const auto stand = [&](const std::string& name) {
      for (const Truth::SegmentTruth& segment : poses_.segments) {
        if (segment.name == name) {
          return;
        }
      }
      Truth::SegmentTruth segment;
      segment.name = name;
      for (int i = 0; i <= 400; ++i) {
        segment.times.push_back(0.01 * i);
        segment.R_WL.push_back(Eigen::Quaterniond::Identity());
        segment.p_WL.push_back(Eigen::Vector3d::Zero());
      }
      poses_.segments.push_back(segment);
    };
    for (const body::Microphone& microphone : info_.rig.microphones) {
      stand(microphone.segment);
    }
    for (const body::Source& source : info_.rig.sources) {
      stand(source.segment);
    }
    const auto wires = info_.rig.microphones.size();
    for (int slot = 0; slot < 400; ++slot) {
      DriverBoxTruth::Pulse pulse;
      pulse.emission = static_cast<std::int64_t>(slot) * kSlot;
      pulse.source = slot % static_cast<int>(info_.rig.sources.size());
      pulse.pairs.assign(wires, {0.5F, 0.0F, 0.0F, 10.0F});
      truth_.pulses.push_back(pulse);
    }
    truth_.words.resize(wires);
  }

  // Of a slot at wire 7, off by so much.
  decode::RangeReading reading(int slot, decode::RangeVerdict verdict, double error, double failure) const {
    decode::RangeReading r;
    r.receiver = kWire;
    r.source = slot % 8;
    r.emission = SampleIndex{static_cast<std::int64_t>(slot) * kSlot};
    r.emission_time = Seconds{slot * kSlot / kRate};
    r.range = r.carrier_range = 0.5 + error;
    r.variance = 1e-8;
    r.failure = failure;
    r.verdict = verdict;
    return r;
  }
  DriverBoxTruth::Pair& pair(int slot) { return truth_.pulses[static_cast<std::size_t>(slot)].pairs[kWire]; }
  static const RangeGroup& group(const RangeBreakdown& breakdown, const std::string& kind, const std::string& name) {
    static const RangeGroup none;
    for (const auto& [k, classes] : breakdown.groups()) {
      if (k == kind && classes.count(name) > 0) {
        return classes.at(name);
      }
    }
    return none;
  }

  static constexpr int kWire = 7;
  take::TakeInfo info_;
  DriverBoxTruth truth_;
  Truth poses_;
  double wavelength_ = 0.0;
};

TEST_F(RangeBreakdownTest, CountsVerdictsSlipsAndClaimsOfClearPairs) {
  pair(2).loss_db = 5.0F;        // neither clear nor occluded
  pair(3).off_axis_deg = 70.0F;  // off the axis
  RangeBreakdown breakdown(truth_, poses_, info_);
  using decode::RangeVerdict;
  breakdown.add(reading(0, RangeVerdict::kAccepted, 0.0, 1e-4));
  breakdown.add(reading(1, RangeVerdict::kAccepted, wavelength_, 2e-4));        // a slip
  breakdown.add(reading(2, RangeVerdict::kAccepted, 0.0, 1e-4));                // not clear
  breakdown.add(reading(3, RangeVerdict::kAccepted, 0.0, 1e-4));                // not clear
  breakdown.add(reading(4, RangeVerdict::kAmbiguous, 2.0 * wavelength_, 0.3));  // wrong, but does not say otherwise
  breakdown.add(reading(5, RangeVerdict::kInterrupted, 0.0, 1.0));              // not counted at all
  EXPECT_EQ(breakdown.all().clear, 3);
  EXPECT_EQ(breakdown.all().accepted(), 2);
  EXPECT_EQ(breakdown.all().slips, 1);
  EXPECT_NEAR(breakdown.all().claimed, 3e-4, 1e-12);
  EXPECT_EQ(breakdown.all().by_verdict[static_cast<std::size_t>(RangeVerdict::kAmbiguous)], 1);
  // By the decade that was claimed, clear or not.
  EXPECT_EQ(breakdown.claims()[0].count, 1);
  EXPECT_EQ(breakdown.claims()[0].wrong, 1);
  const auto fine = breakdown.claims()[3].count + breakdown.claims()[4].count;
  EXPECT_EQ(fine, 4);
  EXPECT_EQ(breakdown.claims()[3].wrong + breakdown.claims()[4].wrong, 1);
  // Each clear pair is in one class of every kind.
  for (const auto& [kind, classes] : breakdown.groups()) {
    std::int64_t sum = 0;
    for (const auto& [name, in] : classes) {
      sum += in.clear;
    }
    EXPECT_EQ(sum, 3) << kind;
  }
  EXPECT_EQ(group(breakdown, "receiver", info_.rig.microphones[kWire].name).clear, 3);
}

// 25 dB on the axis at 0.6 m: nearer is louder, and farther or off the axis weaker than the bar speaks of.
TEST_F(RangeBreakdownTest, TheBarSpeaksOfWhatIsLoudEnough) {
  pair(0).range = 0.55F;
  pair(1).range = 0.9F;
  pair(2).off_axis_deg = 55.0F;
  pair(2).range = 0.6F;
  RangeBreakdown breakdown(truth_, poses_, info_);
  for (const int slot : {0, 1, 2}) {
    breakdown.add(reading(slot, decode::RangeVerdict::kAccepted, 0.0, 1e-5));
  }
  EXPECT_EQ(breakdown.all().clear, 3);
  EXPECT_EQ(breakdown.at_bar().clear, 1);
  EXPECT_EQ(group(breakdown, "in-band SNR", "f: 25 to 30 dB").clear, 1);
}

TEST_F(RangeBreakdownTest, TheBarSpeaksOfWhatIsSlowEnough) {
  // The microphone's segment runs away from all sources at 4 m/s after a second.
  for (Truth::SegmentTruth& segment : poses_.segments) {
    if (segment.name == info_.rig.microphones[kWire].segment) {
      for (std::size_t i = 0; i < segment.times.size(); ++i) {
        segment.p_WL[i].x() = 4.0 * std::max(0.0, segment.times[i] - 1.0);
      }
    }
  }
  RangeBreakdown breakdown(truth_, poses_, info_);
  breakdown.add(reading(50, decode::RangeVerdict::kAccepted, 0.0, 1e-5));   // 0.4 s
  breakdown.add(reading(250, decode::RangeVerdict::kAccepted, 0.0, 1e-5));  // 2 s
  EXPECT_EQ(breakdown.all().clear, 2);
  EXPECT_EQ(breakdown.at_bar().clear, 1);
  EXPECT_EQ(group(breakdown, "speed against the source", "a: below 0.5 m/s").clear, 1);
  EXPECT_EQ(group(breakdown, "speed against the source", "e: 3 to 5 m/s").clear, 1);
}

// A pair is in sight since it became clear, and anew after it was not.
TEST_F(RangeBreakdownTest, TimeInSightBeginsAnew) {
  pair(80).loss_db = 20.0F;
  RangeBreakdown breakdown(truth_, poses_, info_);
  for (int slot = 0; slot < 160; slot += 8) {
    breakdown.add(reading(slot, decode::RangeVerdict::kAccepted, 0.0, 1e-5));
  }
  // 64 ms from one to the next: two of each stretch are below 0.1 s.
  EXPECT_EQ(group(breakdown, "in sight for", "a: below 0.1 s").clear, 4);
  EXPECT_EQ(breakdown.all().clear, 19);
}

TEST_F(RangeBreakdownTest, ChipsAtTheirEndsAreToldApart) {
  DriverBoxTruth::Frame frame;
  frame.start_s = 1.0;
  frame.held[4] = 2047;
  truth_.words[kWire].push_back(frame);
  RangeBreakdown breakdown(truth_, poses_, info_);
  for (const int slot : {100, 130, 200}) {  // 0.8, 1.04, 1.6 s
    breakdown.add(reading(slot, decode::RangeVerdict::kAccepted, 0.0, 1e-5));
  }
  EXPECT_EQ(group(breakdown, "chips", "at an end of their range").clear, 1);
  EXPECT_EQ(group(breakdown, "chips", "within their range").clear, 2);
}

}  // namespace
}  // namespace limbwave::evaluate
