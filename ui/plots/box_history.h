/// How the wires of a driver box were while a take was recorded: a cell per wire and stretch of time, for the overview.
/// Without widgets.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <span>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "solve/box_wires.h"
#include "take/take.h"

namespace limbwave::ui {

/// The worst that happened to a wire in a stretch, from good to bad.
enum class WireCondition : std::uint8_t {
  kUnknown,  ///< Nothing is known.
  kWell,
  kUnseen,  ///< Words, but not one range: no source in sight.
  kSilent,  ///< No words are understood.
  kPulled,  ///< The wire is out of the box.
  kClips,   ///< At full scale.
  kLost,    ///< Words or samples were lost.
};

struct WireCell {
  WireCondition condition = WireCondition::kUnknown;
  float level = 0.0F;      ///< Greatest, of full scale; 0: not known.
  float ranges_hz = 0.0F;  ///< Accepted, a second; below 0: not known.
  int lost_words = 0;
};

class BoxHistory {
 public:
  static constexpr double kColumn_s = 0.5;  ///< At first; twice as long whenever there are more than kMost.
  static constexpr std::size_t kMost = 2400;

  [[nodiscard]] bool empty() const { return columns_ == 0; }
  [[nodiscard]] std::size_t wires() const { return names_.size(); }
  [[nodiscard]] std::size_t columns() const { return columns_; }
  [[nodiscard]] double column_s() const { return column_s_; }
  [[nodiscard]] const QString& name(std::size_t wire) const { return names_[wire]; }
  [[nodiscard]] const WireCell& cell(std::size_t wire, std::size_t column) const {
    return cells_[column * names_.size() + wire];
  }

  /// What the box says `at_s` seconds into the recording; at times that never go back. `lost_s`: what the line has lost
  /// since the box was opened, of all wires.
  void add(double at_s, std::span<const solve::BoxWire> wires, double lost_s);
  /// What was wrong, worst first: what the line lost, then by wire, "Left hand: 3 words lost". Empty: all was well, or
  /// nothing is known.
  [[nodiscard]] QStringList troubles() const;
  /// "Left hand at 0:12: well, −12 dB, 35 ranges a second".
  [[nodiscard]] QString words(std::size_t wire, double at_s) const;

  /// Of a finished take: levels of all wires, gaps and pulled wires from its events. Short stretches all over the take
  /// are read, so that an hour takes no longer than some minutes do. Runs in a job.
  static Result<BoxHistory> of_take(const take::Take& take, const Progress& progress);

 private:
  void begin(std::vector<QString> names);
  WireCell& at(std::size_t wire, std::size_t column);
  void halve();
  std::vector<QString> names_;
  std::vector<WireCell> cells_;
  std::size_t columns_ = 0;
  double column_s_ = kColumn_s;
  std::vector<std::int64_t> lost_before_;
  double lost_before_s_ = 0.0, gap_s_ = 0.0;  // until the last call; by gaps in all
  double last_s_ = 0.0, gap_at_s_ = -1e9;     // of the last call, of the last gap
};

/// "well", "no source in sight", "pulled out"
QString condition_words(WireCondition condition);

}  // namespace limbwave::ui
