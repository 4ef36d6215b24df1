/// The axes of a multiplexed board are read one after another; this stage interpolates them to one instant per cycle.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "decode/line_in.h"

namespace limbwave::decode {

/// All accelerometers at one instant.
struct AccelerationFrame {
  double time_s = 0.0;                               ///< Since the start of the take.
  std::array<Eigen::Vector3d, kMaxSensors> volts{};  ///< Per sensor, relative to the reference slot.
  std::uint32_t usable = 0;                          ///< Bit per sensor: neither clipped nor out of sync.
  bool gap_before = false;                           ///< Frames are missing between the previous one and this one.
};

/// One frame per cycle, at the middle of the cycle, except for the first and the last cycle of an unbroken run, half of
/// whose axes could only be extrapolated. Every axis is interpolated by AlignmentKernel; near gaps, invalid cycles and
/// clipped values by the polynomial through what is good in the three cycles before, this one and the two after. Never
/// across gaps. A sensor is usable where its own readings are good and each axis has good ones on both sides of the
/// instant, four in all: an extrapolated one is off by tenths of g in fast motion. A frame of an unusable sensor
/// carries what could be made of its neighbours, for drawing. Streaming; looks ahead by at most two cycles.
class SlotAligner {
 public:
  SlotAligner(int sensors, SampleRate rate) : sensors_(sensors), rate_(rate) {}
  void push(const LineInCycle& cycle);
  void finish();
  std::vector<AccelerationFrame> take_frames();

 private:
  void emit(std::size_t index);
  struct Value {
    double volts = 0.0;
    bool supported = false;  // interpolated, not extrapolated
  };
  [[nodiscard]] Value interpolate(std::size_t index, std::size_t slot, double instant) const;
  int sensors_;
  SampleRate rate_;
  std::deque<LineInCycle> window_;  // contiguous cycles
  static constexpr std::size_t kFirst = 1;
  std::size_t next_ = kFirst;  // the first one not given out yet
  bool gap_ = false;           // before the next frame
  std::vector<AccelerationFrame> frames_;
};

}  // namespace limbwave::decode
