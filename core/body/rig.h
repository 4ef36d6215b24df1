/// A rig: what is worn where, and everything about the signal that is a choice of the hardware. Read from
/// resources/rigs/*.json or from a take's snapshot; the schema is in resources/rigs/README.md.
#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/skeleton.h"

namespace limbwave::body {

/// A tri-axial accelerometer on a segment.
struct Accelerometer {
  std::string name;                            ///< Unique within the rig: "forearm".
  std::string serial;                          ///< Of the physical sensor; keys the calibration library. May be empty.
  std::string segment;                         ///< Name of the segment it is worn on.
  Quaterniond R_LS = Quaterniond::Identity();  ///< Nominal mounting: v_L = R_LS * v_S.
  Vector3d p_LS = Vector3d::Zero();            ///< Nominal position on the segment, metres.
};

/// A tri-axial gyroscope on a segment.
struct Gyroscope {
  std::string name;
  std::string serial;
  std::string segment;
  Quaterniond R_LS = Quaterniond::Identity();
  Vector3d p_LS = Vector3d::Zero();
};

/// A microphone for ultrasound; it hears in every direction.
struct Microphone {
  std::string name;
  std::string serial;
  std::string segment;
  Vector3d p_LS = Vector3d::Zero();
};

/// An ultrasonic source.
struct Source {
  std::string name;
  std::string serial;
  std::string segment;
  Vector3d p_LS = Vector3d::Zero();
  Vector3d normal_L = Vector3d::UnitZ();  ///< Where it radiates to, unit length.
};

std::vector<double> default_radiation();  ///< Of a small open piezo transducer.

/// The driver box and its boards (signals.md §2). Wire w carries microphone w and, as words, gyroscope w and
/// accelerometer w; the sources fire in their order, one a slot.
struct DriverBoxSignal {
  double rate_hz = 140000.0;                 ///< Samples a second of every wire.
  int bits = 16;                             ///< Of a sample, 12 to 16; stored in the upper ones of an int16.
  int slot_samples = 1120;                   ///< From one pulse to the next.
  double pulse_hz = 40000.0;                 ///< Carrier.
  int pulse_cycles = 10;                     ///< Length of the burst that drives a source.
  double transducer_q = 20.0;                ///< Quality of a source's resonance at the carrier.
  double microphone_bandwidth_hz = 12000.0;  ///< Half-power half width of a microphone's response about the carrier.
  /// Amplitude that a source reaches on its axis, as a fraction of full scale times metres, before absorption.
  double source_level_m = 0.08;
  double absorption_db_m = 1.3;  ///< Of air at the carrier, dB per metre.
  /// Amplitude at 0, 10, ... 180 degrees off a source's normal, relative to the axis.
  std::vector<double> radiation = default_radiation();
  double word_amplitude = 0.03;                ///< Of the words, fraction of full scale.
  double word_rate_hz = 140.0;                 ///< Inertial readings a second.
  double word_clock_tolerance = 200e-6;        ///< How far a board's clock may be off.
  double gyroscope_range_rad_s = 5.235987756;  ///< Of a word's full scale (300 deg/s).
  double accelerometer_range_g = 3.0;          ///< Of a word's full scale.
};

/// The line-in multiplexer board (signals.md §1). Slot 3s+a carries axis a of accelerometer s, the last slot the
/// reference.
struct LineInSignal {
  double cycle_rate_hz = 60.0;         ///< Nominal cycles per second.
  double cycle_rate_tolerance = 0.10;  ///< Relative deviation of the RC clock that the decoder must accept.
  int slots = 16;                      ///< Per cycle, even; = 3 · sensors + 1.
  double supply_volts = 3.3;           ///< Swing of the counter's top bit on the right channel; low in the first half.
  double reference_volts = 0.33;  ///< Of the last slot. Outside the accelerometers' span, so that it is unmistakable.
  double zero_g_volts = 1.65;     ///< Nominal output at 0 g.
  double volts_per_g = 0.33;      ///< Nominal sensitivity per standard gravity.
  double range_g = 3.0;           ///< Saturation of the sensor.
};

/// Two poses that tie a sensor's axes to its limb (line-in paper §4): what gravity is in the limb frame in each.
struct LimbPose {
  std::string name;                         ///< "horizontal"
  std::string instruction;                  ///< What the wearer does: "Stretch the arm forward, level, palm down."
  Vector3d gravity_L = -Vector3d::UnitZ();  ///< Direction of gravity in the limb frame, unit length.
};

/// Sensors that are calibrated together by one pair of poses, the two gravity directions perpendicular.
struct CalibrationGroup {
  std::string name;          ///< "Right arm"
  std::vector<int> sensors;  ///< Indices into Rig::accelerometers.
  LimbPose first, second;
};

struct Rig {
  std::string name;         ///< "line-in-arm"
  std::string title;        ///< "Arm with five accelerometers on a sound card"
  std::string skeleton;     ///< Name of the skeleton it is worn by.
  bool has_line_in = true;  ///< False: nothing of it comes through a sound card, and `line_in` has no meaning.
  LineInSignal line_in;
  std::optional<DriverBoxSignal> driver_box;
  std::vector<Accelerometer> accelerometers;
  std::vector<Gyroscope> gyroscopes;
  std::vector<Microphone> microphones;
  std::vector<Source> sources;
  std::vector<CalibrationGroup> groups;
};

Result<Rig> rig_from_json(const nlohmann::json& json, const std::string& place);
nlohmann::json rig_to_json(const Rig& rig);

/// Everything that is worn, moved along when a body of another size wears it: positions on segments times `factor`.
Rig scaled(Rig rig, double factor);

/// A shipped rig by name ("line-in-arm") or a file by path. Also checks it against its skeleton.
Result<Rig> load_rig(const std::string& name_or_path);
std::vector<std::string> shipped_rigs();

}  // namespace limbwave::body
