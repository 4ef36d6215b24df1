/// Numbers and times as people read them. Pure functions.
#pragma once

#include <QString>
#include <optional>

#include "decode/line_in.h"

namespace limbwave::ui {

/// "0:07", "12:34", "1:02:03"; negative is taken as zero.
QString format_clock(double seconds);
/// With tenths: "0:07.3". For running times.
QString format_clock_tenths(double seconds);
/// With hundredths: "0:07.32". For times that people edit.
QString format_clock_hundredths(double seconds);
/// Seconds from what people type as a time: "7.3", "0:07.3", "1:02:03"; decimal point or comma. Empty: it is none.
std::optional<double> parse_clock(const QString& text);
/// Roughly, for what is left: "40 s", "5 min", "23 h", "over 9 days".
QString format_left(double seconds);
/// "48 kHz", "44.1 kHz"
QString format_rate(double hz);
/// Fraction of full scale as "−12 dB"; "silent" below −90 dB.
QString format_level(double fraction);
/// The core's phrases as sentences: first letter large, a full stop at the end. Empty stays empty.
QString as_sentence(const QString& phrase);
/// A file name made of letters, digits, dots, dashes and underscores: "Zoë B." becomes "zoe-b". Empty stays empty.
QString file_name_part(const QString& text);
/// The first free "SUBJECT-YYYYMMDD-N" in a folder, N from 1; without a subject "take-YYYYMMDD-N".
QString suggest_take_name(const QString& folder, const QString& subject, const QString& yyyymmdd);
/// Why this cannot be a take's name; empty: it can.
QString take_name_problem(const QString& folder, const QString& name);

}  // namespace limbwave::ui
