/// Records a take from a driver box, through everything that its line may do.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "acquire/box_source.h"
#include "base/result.h"
#include "take/recorder.h"
#include "take/take.h"

namespace limbwave::take {

struct DriverBoxProgress {
  double seconds = 0.0;  ///< Recorded, gaps included.
  double disk_left_s = 0.0;
  bool connected = true;
  acquire::BoxCounters counters;
  acquire::BoxStatus status;
};

/// The same box at another rate, as a sound card runs it: slots last as long as before.
body::Rig rig_at_rate(body::Rig rig, double rate_hz);

/// Whether the box is what the rig says about it: wires, rate, samples of a slot, sources. Else an error that says what
/// it is.
Status box_fits(const body::Rig& rig, const acquire::BoxHello& hello);

/// One take that is being written from a box which somebody else pulls. Not thread-safe.
class BoxRecording {
 public:
  /// Makes the take's folder. The rig must have as many wires, sources and samples a slot as the box, and its rate.
  static Result<std::unique_ptr<BoxRecording>> create(const std::filesystem::path& folder,
                                                      const acquire::BoxSource& box, const body::Rig& rig,
                                                      const body::Skeleton& skeleton, const std::string& subject,
                                                      const calibrate::RangingCalibration& ranging);
  ~BoxRecording();  ///< Closes it properly when that was not done.
  BoxRecording(const BoxRecording&) = delete;
  BoxRecording& operator=(const BoxRecording&) = delete;

  /// The next part begins at this sample of the box, which was pulled for some time already; before the first
  /// `take_in`. The take begins with the next round of the sources, so that its sample 0 is the rig's first source.
  void begin_at(SampleIndex position);
  /// The sample of the box that is the take's sample 0.
  [[nodiscard]] SampleIndex first() const { return {first_}; }
  /// Writes what has been pulled. Lost samples become zeros, and every gap one event "dropped".
  Status take_in(const acquire::BoxPart& part);
  /// Tells once when the battery is low.
  void note(const acquire::BoxStatus& status);
  /// A line of the take's events.
  Status add_event(const TakeEvent& event);
  [[nodiscard]] std::int64_t frames() const;
  [[nodiscard]] double seconds() const;
  [[nodiscard]] double disk_left_s() const;
  Result<Take> close();
  void discard();  ///< Removes everything.

 private:
  BoxRecording();
  Status write_piece(const acquire::BoxPiece& piece);
  Status write_event(const acquire::BoxEvent& event);
  std::unique_ptr<Recorder> out_;
  std::size_t frame_bytes_ = 0;
  std::int64_t round_ = 1, first_ = 0, position_ = 0;  // of the box
  bool low_told_ = false;
};

/// Which source fires in which slot: the rig's order, as decoders take them.
std::vector<std::uint8_t> rig_schedule(const body::Rig& rig);

/// Starts the box, writes what comes until `go_on` answers false, and stops it. Lost samples are zeros, with one event
/// "dropped" for every gap that says how many; other events are those of acquire/box_source.h. The rig must have as
/// many wires and the same rate as the box. Sample 0 of the take is the box's sample 0, with which the rig's first
/// source fires. `ranging` is the take's calibration: at least the speed of sound.
Result<Take> record_driver_box(const std::filesystem::path& folder, acquire::BoxSource& box, const body::Rig& rig,
                               const body::Skeleton& skeleton, const std::string& subject,
                               const calibrate::RangingCalibration& ranging,
                               const std::function<bool(const DriverBoxProgress&)>& go_on);

}  // namespace limbwave::take
