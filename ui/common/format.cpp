#include "common/format.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

namespace limbwave::ui {
namespace {

QString translated(const char* text) {
  return QCoreApplication::translate("Format", text);
}

}  // namespace

QString format_clock(double seconds) {
  const auto total = static_cast<std::int64_t>(std::isfinite(seconds) ? std::max(0.0, seconds) : 0.0);
  const auto two = [](std::int64_t value) { return QStringLiteral("%1").arg(value, 2, 10, QLatin1Char('0')); };
  if (total >= 3600) {
    return QStringLiteral("%1:%2:%3").arg(total / 3600).arg(two(total / 60 % 60), two(total % 60));
  }
  return QStringLiteral("%1:%2").arg(total / 60).arg(two(total % 60));
}

QString format_clock_tenths(double seconds) {
  const double safe = std::isfinite(seconds) ? std::max(0.0, seconds) : 0.0;
  const auto tenth = static_cast<std::int64_t>(safe * 10.0) % 10;
  return QStringLiteral("%1%2%3").arg(format_clock(safe), QLocale().decimalPoint()).arg(tenth);
}

QString format_clock_hundredths(double seconds) {
  const double safe = std::isfinite(seconds) ? std::max(0.0, seconds) : 0.0;
  const auto total = std::llround(safe * 100.0);
  const auto whole = total / 100;
  return QStringLiteral("%1%2%3")
      .arg(format_clock(static_cast<double>(whole)), QLocale().decimalPoint())
      .arg(total % 100, 2, 10, QLatin1Char('0'));
}

std::optional<double> parse_clock(const QString& text) {
  const QStringList parts = text.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).split(QLatin1Char(':'));
  double seconds = 0.0;
  for (qsizetype i = 0; i < parts.size(); ++i) {
    bool ok = false;
    const bool last = i + 1 == parts.size();
    const double value = last ? QLocale::c().toDouble(parts[i], &ok) : parts[i].toUInt(&ok);
    if (!ok || !std::isfinite(value) || value < 0.0 || (i > 0 && value >= 60.0)) {
      return std::nullopt;
    }
    seconds = 60.0 * seconds + value;
  }
  return parts.size() <= 3 ? std::optional(seconds) : std::nullopt;
}

QString format_left(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0.0) {
    return {};
  }
  if (seconds < 90.0) {
    return translated(QT_TRANSLATE_NOOP("Format", "%1 s")).arg(std::lround(seconds));
  }
  if (seconds < 90.0 * 60.0) {
    return translated(QT_TRANSLATE_NOOP("Format", "%1 min")).arg(std::lround(seconds / 60.0));
  }
  if (seconds < 48.0 * 3600.0) {
    return translated(QT_TRANSLATE_NOOP("Format", "%1 h")).arg(std::lround(seconds / 3600.0));
  }
  const auto days = std::lround(seconds / 86400.0);
  return days > 9 ? translated(QT_TRANSLATE_NOOP("Format", "over 9 days"))
                  : translated(QT_TRANSLATE_NOOP("Format", "%1 days")).arg(days);
}

QString format_rate(double hz) {
  const double khz = hz / 1000.0;
  const bool whole = std::abs(khz - std::round(khz)) < 0.005;
  return translated(QT_TRANSLATE_NOOP("Format", "%1 kHz")).arg(QLocale().toString(khz, 'f', whole ? 0 : 1));
}

QString format_level(double fraction) {
  if (!(fraction > 3.2e-5)) {
    return translated(QT_TRANSLATE_NOOP("Format", "silent"));
  }
  const auto db = std::lround(20.0 * std::log10(fraction));
  // A real minus sign is as wide as a figure.
  return translated(QT_TRANSLATE_NOOP("Format", "%1 dB"))
      .arg(db < 0 ? QStringLiteral("\u2212%1").arg(-db) : QString::number(db));
}

QString as_sentence(const QString& phrase) {
  QString text = phrase.trimmed();
  if (text.isEmpty()) {
    return text;
  }
  // The name of a file or of a take is left as it is.
  static const QRegularExpression name(QStringLiteral("^[^\\s]*[./_\\d]"));
  if (!name.match(text).hasMatch()) {
    text.replace(0, 1, text.left(1).toUpper());
  }
  if (!text.endsWith(QLatin1Char('.')) && !text.endsWith(QLatin1Char('!')) && !text.endsWith(QLatin1Char('?'))) {
    text += QLatin1Char('.');
  }
  return text;
}

QString file_name_part(const QString& text) {
  QString result;
  for (const QChar c : text.normalized(QString::NormalizationForm_D).toLower()) {
    const bool ascii = c.unicode() < 128;
    if (ascii && (c.isLetterOrNumber() || c == QLatin1Char('_'))) {
      result.append(c);
    } else if (c.category() != QChar::Mark_NonSpacing && !result.isEmpty() && !result.endsWith(QLatin1Char('-'))) {
      result.append(QLatin1Char('-'));
    }
  }
  while (result.endsWith(QLatin1Char('-'))) {
    result.chop(1);
  }
  return result.left(64);
}

QString suggest_take_name(const QString& folder, const QString& subject, const QString& yyyymmdd) {
  const QString part = file_name_part(subject);
  const QString stem =
      (part.isEmpty() ? QStringLiteral("take") : part) + QLatin1Char('-') + yyyymmdd + QLatin1Char('-');
  for (int n = 1;; ++n) {
    QString name = stem + QString::number(n);
    if (!QFileInfo::exists(QDir(folder).filePath(name + QStringLiteral(".take")))) {
      return name;
    }
  }
}

QString take_name_problem(const QString& folder, const QString& name) {
  if (name.trimmed().isEmpty()) {
    return translated(QT_TRANSLATE_NOOP("Format", "The take needs a name."));
  }
  if (name.contains(QLatin1Char('/')) || name.startsWith(QLatin1Char('.')) || name.contains(QChar(0))) {
    return translated(QT_TRANSLATE_NOOP("Format", "A take's name has no slash and does not start with a dot."));
  }
  if (name.toUtf8().size() > 200) {
    return translated(QT_TRANSLATE_NOOP("Format", "This name is too long for the disk."));
  }
  if (QFileInfo::exists(QDir(folder).filePath(name + QStringLiteral(".take")))) {
    return translated(QT_TRANSLATE_NOOP("Format", "There is a take of this name already. Choose another one."));
  }
  return {};
}

}  // namespace limbwave::ui
