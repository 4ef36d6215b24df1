/// The samples of all wires of a driver box, made slot by slot, with what was really so.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "body/rig.h"
#include "calibrate/ranging_calibration.h"
#include "simulate/board_chip.h"
#include "simulate/crew.h"
#include "simulate/driver_box_actor.h"
#include "simulate/driver_box_errors.h"
#include "simulate/random.h"
#include "simulate/sound_path.h"
#include "simulate/sound_pulse.h"
#include "simulate/word_line.h"

namespace limbwave::simulate {

/// One source and one microphone at one pulse.
struct PairTruth {
  double range = 0.0;     ///< From the source at emission to the microphone at arrival, metres.
  double rate = 0.0;      ///< Its derivative by the time of emission, m/s.
  double loss_db = 0.0;   ///< What limbs in the way take.
  double off_axis = 0.0;  ///< Off the source's normal, radians.
};

struct PulseTruth {
  std::int64_t emission = 0;  ///< Sample of the slot's start. The range is that of a pulse that starts there.
  int source = 0;
  std::vector<PairTruth> pairs;  ///< One per wire.
};

/// What a calibration of the sources would have found.
struct SourceTruth {
  double delay_s = 0.0;               ///< Later than the slot's start.
  double phase = 0.0, phase_2 = 0.0;  ///< Phase off the normal: phase · u² + phase_2 · u³, u = angle / 60°, radians.
  double level = 1.0;
};

/// Same rig, actor, errors and seed: the same samples, on however many threads.
class DriverBoxStream {
 public:
  /// `rig` has a driver box. The first source fires at sample 0.
  DriverBoxStream(const body::Rig& rig, std::shared_ptr<const DriverBoxActor> actor, const DriverBoxErrors& errors,
                  double temperature_c, std::uint64_t seed);
  ~DriverBoxStream();

  void set_threads(int threads);  ///< That make the wires; 1 at first.
  /// Which source fires in which slot, again and again; what is no source is silence. Before the first slot.
  void set_schedule(const std::vector<std::uint8_t>& schedule);

  [[nodiscard]] int wires() const { return static_cast<int>(wires_.size()); }
  [[nodiscard]] int slot_samples() const { return box_.slot_samples; }
  /// The next slot, interleaved: slot_samples · wires values.
  void next_slot(std::span<std::int16_t> out);
  [[nodiscard]] std::int64_t position() const { return slot_ * box_.slot_samples; }

  [[nodiscard]] double speed_of_sound() const { return speed_; }            ///< As it is.
  [[nodiscard]] double entered_speed_of_sound() const { return entered_; }  ///< As the operator entered it.
  [[nodiscard]] const std::vector<SourceTruth>& sources() const { return sources_; }
  /// Pulses and frames of wire w since the last call.
  std::vector<PulseTruth> take_pulses();
  std::vector<WordLine::SentFrame> take_frames(int wire) {
    return wires_[static_cast<std::size_t>(wire)]->words.take_sent();
  }

 private:
  struct Way;
  struct Wire {
    std::unique_ptr<BoardChip> chip;
    WordLine words;
    Random noise;
    std::vector<float> sound;  // what is still to come; the present slot begins at `head`
    std::size_t head = 0;
    double ear = 1.0;  // how much of disturbances it hears
    std::vector<float> line;
  };
  // The pulse of the present slot.
  struct Emission {
    std::size_t number = 0;  // of the source; beyond the sources: none
    FrameJet from;
    Vector3d normal;
  };
  void emit();
  void receive(std::size_t wire);
  void sample(std::size_t wire, std::span<std::int16_t> out);
  [[nodiscard]] Way way(const Vector3d& start, const Vector3d& velocity, const FrameJet& to) const;
  void hear(std::size_t wire, const Way& along, const Vector3d& leaves, double gain);
  void disturb();
  void advance(Wire& wire) const;
  [[nodiscard]] std::size_t room(const Wire& wire) const { return wire.sound.size() - wire.head; }
  void add_pulse(Wire& wire, double arrival_s, double rate_of_time, double amplitude, double phase);

  body::DriverBoxSignal box_;
  DriverBoxErrors errors_;
  std::shared_ptr<const DriverBoxActor> actor_;
  std::unique_ptr<Crew> crew_;
  SoundPulse pulse_;
  double speed_, entered_, wavelength_;
  double noise_ = 0.0;      // RMS of a sample
  std::size_t memory_ = 0;  // samples ahead that a wire keeps
  std::vector<SourceTruth> sources_;
  std::vector<std::uint8_t> schedule_;
  Emission emission_;
  std::vector<std::unique_ptr<Wire>> wires_;
  std::vector<Mirror> mirrors_;
  std::vector<PulseTruth> pulses_;
  std::vector<FrameJet> frames_;
  std::vector<WorldCapsule> capsules_;
  Random keys_, brakes_;
  double next_key_s_, next_brake_s_;
  std::int64_t slot_ = 0;
};

/// What calibrating the sources would have left in the take: exact but for the phase.
calibrate::RangingCalibration simulated_calibration(const body::Rig& rig, const DriverBoxStream& stream,
                                                    const DriverBoxErrors& errors, std::uint64_t seed);

/// Speed of sound in air, m/s (signals.md §3, with the humidity term of Cramer 1993 to first order).
double air_speed_of_sound(double temperature_c, double relative_humidity);

}  // namespace limbwave::simulate
