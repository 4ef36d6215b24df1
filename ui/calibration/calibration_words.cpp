#include "calibration/calibration_words.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QStringList>
#include <cmath>

namespace limbwave::ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(CalibrationWords)
};

calibrate::Verdict judged(double value, double good, double usable) {
  return value <= good     ? calibrate::Verdict::kGood
         : value <= usable ? calibrate::Verdict::kUsable
                           : calibrate::Verdict::kRepeat;
}

QString joined(const QString& first, const QString& second) {
  return second.isEmpty() ? first : Words::tr("%1, %2").arg(first, second);
}

}  // namespace

Tone verdict_tone(calibrate::Verdict verdict) {
  switch (verdict) {
    case calibrate::Verdict::kGood:
      return Tone::kGood;
    case calibrate::Verdict::kUsable:
      return Tone::kWarning;
    case calibrate::Verdict::kRepeat:
      break;
  }
  return Tone::kDanger;
}

QString verdict_word(calibrate::Verdict verdict) {
  switch (verdict) {
    case calibrate::Verdict::kGood:
      return Words::tr("Good");
    case calibrate::Verdict::kUsable:
      return Words::tr("Usable");
    case calibrate::Verdict::kRepeat:
      break;
  }
  return Words::tr("Repeat");
}

calibrate::Verdict range_verdict(const calibrate::SensorCalibration& calibration) {
  const calibrate::RangeParameters limits;
  return judged(calibration.residual_g, limits.good_residual_g, limits.usable_residual_g);
}

calibrate::Verdict mount_verdict(const calibrate::MountCalibration& mount) {
  const calibrate::LimbParameters limits;
  return std::max(judged(std::abs(mount.pose_angle_deg - 90.0), limits.good_angle_deg, limits.usable_angle_deg),
                  judged(mount.stillness_g, limits.good_movement_g, limits.usable_movement_g));
}

CalibrationState range_state(const calibrate::SensorCalibration& calibration) {
  if (calibration.method.empty() || calibration.method == "nominal") {
    return {Tone::kUnknown, Words::tr("Not calibrated"), {}, Words::tr("data sheet values, up to 10 % off")};
  }
  const calibrate::Verdict verdict = range_verdict(calibration);
  return {verdict_tone(verdict), verdict_word(verdict), format_mg(calibration.residual_g),
          joined(method_words(calibration.method), format_date(calibration.date))};
}

CalibrationState mount_state(const calibrate::MountCalibration& mount) {
  if (mount.method.empty() || mount.method == "nominal") {
    return {Tone::kUnknown, Words::tr("Not calibrated"), {}, Words::tr("taken to sit as the rig shows it")};
  }
  const calibrate::Verdict verdict = mount_verdict(mount);
  return {verdict_tone(verdict), verdict_word(verdict), format_degrees(mount.pose_angle_deg),
          joined(method_words(mount.method), format_date(mount.date))};
}

CalibrationLine calibration_line(const calibrate::RigCalibration& calibration, const QString& wearer) {
  // How many were measured, and the day of the newest.
  const auto count = [](const auto& entries) {
    std::pair<int, std::string> found{0, {}};
    for (const auto& entry : entries) {
      if (!entry.method.empty() && entry.method != "nominal") {
        ++found.first;
        found.second = std::max(found.second, entry.date);
      }
    }
    return found;
  };
  const auto [ranges, range_date] = count(calibration.sensors);
  const auto [mounts, mount_date] = count(calibration.mounts);
  const int all = static_cast<int>(calibration.sensors.size());
  const auto day = [](const std::string& date) {
    return QLocale().toString(QDateTime::fromString(QString::fromStdString(date), Qt::ISODate).toLocalTime().date(),
                              QLocale::ShortFormat);
  };
  CalibrationLine line;
  line.whole = all > 0 && ranges == all && mounts == all;
  const QString who = (wearer.isEmpty() ? Words::tr("no named person") : wearer).toHtmlEscaped();
  const QString range = ranges == 0 ? Words::tr("Range never calibrated.")
                        : ranges == all
                            ? Words::tr("Range of all sensors, %1.").arg(day(range_date))
                            : Words::tr("Range of %1 of %2 sensors, %3.").arg(ranges).arg(all).arg(day(range_date));
  const QString mount =
      mounts == 0 ? Words::tr("Mounting on %1 not calibrated.").arg(who)
      : mounts == all
          ? Words::tr("Mounting on %1, %2.").arg(who, day(mount_date))
          : Words::tr("Mounting on %1: %2 of %3 sensors, %4.").arg(who).arg(mounts).arg(all).arg(day(mount_date));
  line.text = range + QLatin1Char(' ') + mount;
  return line;
}

QString format_mg(double g) {
  const double mg = 1e3 * g;
  if (!std::isfinite(mg)) {
    return QStringLiteral("–");
  }
  return Words::tr("%1 mg").arg(QLocale().toString(mg, 'f', mg < 9.95 ? 1 : 0));
}

QString format_degrees(double degrees, bool sign) {
  if (!std::isfinite(degrees)) {
    return QStringLiteral("–");
  }
  // A minus as long as the plus, as type is set.
  QString text = QLocale().toString(std::abs(degrees), 'f', 1) + QStringLiteral("°");
  if (degrees < -0.05) {
    text.prepend(QChar(0x2212));
  } else if (sign && degrees > 0.05) {
    text.prepend(QLatin1Char('+'));
  }
  return text;
}

QString format_date(const std::string& iso) {
  const QDateTime time = QDateTime::fromString(QString::fromStdString(iso), Qt::ISODate);
  return time.isValid() ? QLocale().toString(time.toLocalTime(), Words::tr("d MMM yyyy HH:mm")) : QString();
}

std::string now_iso() {
  return QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
}

QString up_words(const Eigen::Vector3d& up_S) {
  // An axis that carries less than 35 % of the direction only confuses whoever turns the sensor.
  QStringList names;
  const Eigen::Vector3d up = up_S.normalized();
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(up[axis]) > 0.35) {
      names << (up[axis] > 0.0 ? QStringLiteral("+") : QString(QChar(0x2212))) + QLatin1Char("xyz"[axis]);
    }
  }
  switch (names.size()) {
    case 1:
      return Words::tr("%1 up").arg(names[0]);
    case 2:
      return Words::tr("%1 and %2 up").arg(names[0], names[1]);
    default:
      return Words::tr("corner %1 up").arg(names.join(QLatin1Char(' ')));
  }
}

QString counted_sensors(int count) {
  return count == 1 ? Words::tr("1 sensor") : Words::tr("%1 sensors").arg(count);
}

QString counted_calibrations(int count) {
  return count == 1 ? Words::tr("1 calibration") : Words::tr("%1 calibrations").arg(count);
}

QString method_words(const std::string& method) {
  if (method == "extremes") {
    return Words::tr("extremes");
  }
  if (method == "ellipsoid") {
    return Words::tr("ellipsoid");
  }
  if (method == "two poses") {
    return Words::tr("two poses");
  }
  return QString::fromStdString(method);
}

}  // namespace limbwave::ui
