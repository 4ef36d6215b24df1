/// Verdicts, numbers and directions of calibrations in words. Pure functions.
#pragma once

#include <Eigen/Core>
#include <QString>

#include "calibrate/calibration.h"
#include "calibrate/limb_calibration.h"
#include "calibrate/range_calibration.h"
#include "common/widgets.h"

namespace limbwave::ui {

/// A finding about one calibration: a state, a word, the number that it rests on.
struct CalibrationState {
  Tone tone = Tone::kUnknown;
  QString word;    ///< "Good", "Usable", "Repeat", "Not calibrated"
  QString number;  ///< "3.2 mg", "88.6°"
  QString detail;  ///< "ellipsoid, 22 Nov 2026 13:05"
};

Tone verdict_tone(calibrate::Verdict verdict);
QString verdict_word(calibrate::Verdict verdict);

/// Verdicts from stored numbers, with the limits of the procedures.
calibrate::Verdict range_verdict(const calibrate::SensorCalibration& calibration);
calibrate::Verdict mount_verdict(const calibrate::MountCalibration& mount);
CalibrationState range_state(const calibrate::SensorCalibration& calibration);
CalibrationState mount_state(const calibrate::MountCalibration& mount);

/// What a take will carry, in one line: "Range of all sensors, 3 Mar 2026. Mounting of Anna, 4 Mar 2026."
struct CalibrationLine {
  QString text;  ///< Escaped for rich text.
  bool whole = false;
};
CalibrationLine calibration_line(const calibrate::RigCalibration& calibration, const QString& wearer);

/// "3.2 mg": thousandths of standard gravity, two digits that are true.
QString format_mg(double g);
/// "88.6°", "+1.4°"
QString format_degrees(double degrees, bool sign = false);
/// ISO 8601 UTC as local date and time, "22 Nov 2026 13:05"; empty stays empty.
QString format_date(const std::string& iso);
/// Now, ISO 8601 UTC with seconds.
std::string now_iso();

/// Which of the sensor's axes points up: "+z up", "+x and −y up".
QString up_words(const Eigen::Vector3d& up_S);
/// "1 sensor", "5 sensors"
QString counted_sensors(int count);
/// "1 calibration", "5 calibrations"
QString counted_calibrations(int count);
QString method_words(const std::string& method);

}  // namespace limbwave::ui
