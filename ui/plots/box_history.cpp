#include "plots/box_history.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>
#include <utility>

#include "acquire/sample_format.h"
#include "common/format.h"
#include "common/shown_names.h"
#include "take/take_reader.h"

namespace limbwave::ui {
namespace {

/// lupdate knows this as the context "BoxHistoryWords".
struct BoxHistoryWords {
  Q_DECLARE_TR_FUNCTIONS(BoxHistoryWords)
};

constexpr std::size_t kMostRead = 1500;  // stretches of a take
constexpr float kFullScale = 0.9995F;
constexpr double kAfterGap_s = 1.0;  // until words of a gap of the line have been counted

WireCondition condition_of(const solve::BoxWire& wire, bool lost) {
  if (!wire.plugged) {
    return WireCondition::kPulled;
  }
  if (lost) {
    return WireCondition::kLost;
  }
  if (wire.clipped) {
    return WireCondition::kClips;
  }
  if (!wire.locked || wire.state != estimate::BoardState::kWell) {
    return WireCondition::kSilent;
  }
  return wire.ranges_hz > 0.0 ? WireCondition::kWell : WireCondition::kUnseen;
}

void merge(WireCell& into, const WireCell& with) {
  into.condition = std::max(into.condition, with.condition);
  into.level = std::max(into.level, with.level);
  into.ranges_hz = into.condition == WireCondition::kUnknown || into.ranges_hz < 0.0F
                       ? with.ranges_hz
                       : 0.5F * (into.ranges_hz + with.ranges_hz);
  into.lost_words += with.lost_words;
}

}  // namespace

QString condition_words(WireCondition condition) {
  switch (condition) {
    case WireCondition::kWell:
      return BoxHistoryWords::tr("well");
    case WireCondition::kUnseen:
      return BoxHistoryWords::tr("no source in sight");
    case WireCondition::kSilent:
      return BoxHistoryWords::tr("no words");
    case WireCondition::kPulled:
      return BoxHistoryWords::tr("pulled out");
    case WireCondition::kClips:
      return BoxHistoryWords::tr("clips");
    case WireCondition::kLost:
      return BoxHistoryWords::tr("something was lost");
    case WireCondition::kUnknown:
      break;
  }
  return BoxHistoryWords::tr("nothing is known");
}

void BoxHistory::begin(std::vector<QString> names) {
  *this = BoxHistory();
  names_ = std::move(names);
}

// Two columns become one.
void BoxHistory::halve() {
  const std::size_t wires = names_.size();
  const std::size_t half = (columns_ + 1) / 2;
  for (std::size_t c = 0; c < half; ++c) {
    for (std::size_t w = 0; w < wires; ++w) {
      WireCell cell = cells_[2 * c * wires + w];
      if (2 * c + 1 < columns_) {
        merge(cell, cells_[(2 * c + 1) * wires + w]);
      }
      cells_[c * wires + w] = cell;
    }
  }
  columns_ = half;
  cells_.resize(columns_ * wires);
  column_s_ *= 2.0;
}

WireCell& BoxHistory::at(std::size_t wire, std::size_t column) {
  columns_ = std::max(columns_, column + 1);
  cells_.resize(columns_ * names_.size());
  return cells_[column * names_.size() + wire];
}

void BoxHistory::add(double at_s, std::span<const solve::BoxWire> wires, double lost_s) {
  if (wires.empty() || !(at_s >= 0.0)) {
    return;
  }
  if (names_.size() != wires.size()) {
    std::vector<QString> names;
    for (const solve::BoxWire& wire : wires) {
      names.push_back(shown_name(wire.board));
    }
    begin(std::move(names));
    lost_before_s_ = lost_s;
    for (const solve::BoxWire& wire : wires) {
      lost_before_.push_back(wire.lost_frames);
    }
  }
  while (at_s / column_s_ >= static_cast<double>(kMost)) {
    halve();
  }
  const auto column = static_cast<std::size_t>(at_s / column_s_);
  const double gap_s = lost_s - std::exchange(lost_before_s_, lost_s);
  const bool gap = gap_s > 0.0;
  if (gap) {
    gap_s_ += gap_s;
    gap_at_s_ = at_s;
    // Nothing was heard of it meanwhile.
    for (auto c = static_cast<std::size_t>(std::max(last_s_, at_s - gap_s) / column_s_); c < column; ++c) {
      for (std::size_t w = 0; w < names_.size(); ++w) {
        at(w, c).condition = WireCondition::kLost;
      }
    }
  }
  last_s_ = at_s;
  for (std::size_t w = 0; w < wires.size(); ++w) {
    const solve::BoxWire& wire = wires[w];
    // A board that was locked anew counts from its start.
    const std::int64_t lost = wire.lost_frames - std::exchange(lost_before_[w], wire.lost_frames);
    WireCell now;
    // Words that were in a gap of the line are its loss, not the wire's.
    const bool counts = wire.plugged && at_s - gap_at_s_ > kAfterGap_s;
    now.lost_words = counts ? static_cast<int>(std::max<std::int64_t>(0, lost)) : 0;
    now.condition = condition_of(wire, gap || now.lost_words > 0);
    now.level = static_cast<float>(wire.level);
    now.ranges_hz = static_cast<float>(wire.ranges_hz);
    WireCell& cell = at(w, column);
    const float ranges_hz = now.ranges_hz;
    merge(cell, now);
    cell.ranges_hz = ranges_hz;
  }
}

QStringList BoxHistory::troubles() const {
  struct Sum {
    std::size_t wire = 0;
    WireCondition worst = WireCondition::kUnknown;
    int lost_words = 0;
    std::size_t columns = 0;  // as bad as that
  };
  std::vector<Sum> sums;
  for (std::size_t w = 0; w < wires(); ++w) {
    Sum sum{w};
    for (std::size_t c = 0; c < columns_; ++c) {
      const WireCell& one = cell(w, c);
      sum.lost_words += one.lost_words;
      if (one.condition == WireCondition::kLost && one.lost_words == 0) {
        continue;  // by the line
      }
      if (one.condition > sum.worst) {
        sum.worst = one.condition;
        sum.columns = 0;
      }
      sum.columns += one.condition == sum.worst ? 1U : 0U;
    }
    if (sum.worst > WireCondition::kUnseen) {
      sums.push_back(sum);
    }
  }
  std::ranges::stable_sort(
      sums, [](const Sum& a, const Sum& b) { return std::pair(a.worst, a.columns) > std::pair(b.worst, b.columns); });
  QStringList texts;
  if (gap_s_ > 0.0) {
    texts << BoxHistoryWords::tr("%1 s lost on the line").arg(QLocale().toString(gap_s_, 'f', gap_s_ < 0.1 ? 3 : 1));
  }
  for (const Sum& sum : sums) {
    const QString what = sum.worst == WireCondition::kLost && sum.lost_words > 0
                             ? BoxHistoryWords::tr("%n word(s) lost", nullptr, sum.lost_words)
                             : BoxHistoryWords::tr("%1 for %2 s")
                                   .arg(condition_words(sum.worst),
                                        QLocale().toString(static_cast<double>(sum.columns) * column_s_, 'f', 1));
    texts << BoxHistoryWords::tr("%1: %2").arg(names_[sum.wire], what);
  }
  return texts;
}

QString BoxHistory::words(std::size_t wire, double at_s) const {
  const auto column = static_cast<std::size_t>(std::max(0.0, at_s) / column_s_);
  if (wire >= wires() || column >= columns_) {
    return {};
  }
  const WireCell& one = cell(wire, column);
  QStringList facts{condition_words(one.condition)};
  if (one.level > 0.0F) {
    facts << format_level(static_cast<double>(one.level));
  }
  if (one.ranges_hz >= 0.0F && one.condition != WireCondition::kUnknown) {
    facts << BoxHistoryWords::tr("%1 ranges a second").arg(std::lround(one.ranges_hz));
  }
  if (one.lost_words > 0) {
    facts << BoxHistoryWords::tr("%n word(s) lost", nullptr, one.lost_words);
  }
  return BoxHistoryWords::tr("%1 at %2: %3")
      .arg(names_[wire], format_clock_tenths(at_s), facts.join(QStringLiteral(", ")));
}

Result<BoxHistory> BoxHistory::of_take(const take::Take& take, const Progress& progress) {
  Result<take::TakeReader> reader = take::TakeReader::open(take);
  if (!reader) {
    return reader.error();
  }
  BoxHistory history;
  std::vector<QString> names;
  for (const body::Microphone& microphone : take.info.rig.microphones) {
    names.push_back(shown_name(microphone.name));
  }
  const auto channels = static_cast<std::size_t>(reader->format().channels);
  names.resize(channels);
  history.begin(std::move(names));
  const double rate = reader->format().rate.hz;
  const double seconds = static_cast<double>(reader->frames()) / rate;
  while (seconds / history.column_s_ > static_cast<double>(kMostRead)) {
    history.column_s_ *= 2.0;
  }
  const auto columns = static_cast<std::size_t>(std::ceil(seconds / history.column_s_));
  // A round of the sources holds a pulse of each.
  const auto& box = take.info.rig.driver_box;
  const double round =
      box ? static_cast<double>(box->slot_samples) * static_cast<double>(take.info.rig.sources.size()) : 0.064 * rate;
  std::vector<float> samples(static_cast<std::size_t>(std::max(round, 64.0)) * channels);
  for (std::size_t c = 0; c < columns; ++c) {
    const auto first = static_cast<std::int64_t>(static_cast<double>(c) * history.column_s_ * rate);
    const Result<std::size_t> frames = reader->read(SampleIndex{first}, samples);
    if (!frames) {
      return frames.error();
    }
    for (std::size_t w = 0; w < channels; ++w) {
      WireCell& cell = history.at(w, c);
      for (std::size_t i = 0; i < *frames; ++i) {
        cell.level = std::max(cell.level, std::abs(samples[i * channels + w]));
      }
      cell.condition = cell.level >= kFullScale ? WireCondition::kClips
                       : cell.level > 0.0F      ? WireCondition::kWell
                                                : WireCondition::kSilent;
      cell.ranges_hz = -1.0F;  // decoding tells them
    }
    if (!progress.report(static_cast<double>(c) / static_cast<double>(columns))) {
      return cancelled();
    }
  }
  const auto mark = [&](std::int64_t begin, std::int64_t end, std::size_t from, std::size_t to, WireCondition what) {
    const auto last = static_cast<std::size_t>(std::max(0.0, static_cast<double>(end) / rate / history.column_s_));
    auto c = static_cast<std::size_t>(std::max(0.0, static_cast<double>(begin) / rate / history.column_s_));
    for (; c <= last && c < columns; ++c) {
      for (std::size_t w = from; w < to && w < channels; ++w) {
        history.at(w, c).condition = what;
      }
    }
  };
  std::vector<std::int64_t> pulled(channels, -1);
  const auto wire_of = [&](const take::TakeEvent& event) {
    return event.count >= 0 && event.count < static_cast<std::int64_t>(channels) ? static_cast<std::size_t>(event.count)
                                                                                 : channels;
  };
  for (const take::TakeEvent& event : take.events) {
    if (event.kind == "dropped") {
      history.gap_s_ += static_cast<double>(event.count) / rate;
      mark(event.sample.value, event.sample.value + event.count, 0, channels, WireCondition::kLost);
    } else if (event.kind == "wire-pulled" && wire_of(event) < channels) {
      pulled[wire_of(event)] = event.sample.value;
    } else if (event.kind == "wire-back" && wire_of(event) < channels && pulled[wire_of(event)] >= 0) {
      mark(std::exchange(pulled[wire_of(event)], -1), event.sample.value, wire_of(event), wire_of(event) + 1,
           WireCondition::kPulled);
    }
  }
  for (std::size_t w = 0; w < channels; ++w) {
    if (pulled[w] >= 0) {
      mark(pulled[w], reader->frames(), w, w + 1, WireCondition::kPulled);
    }
  }
  return history;
}

}  // namespace limbwave::ui
