#include "decode/line_in.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "decode/counter_edges.h"
#include "decode/cycle_decoder.h"
#include "decode/finding_log.h"
#include "decode/line_judge.h"
#include "decode/stereo_history.h"

namespace limbwave::decode {
namespace {

constexpr double kJudged_s = 1.0;      // heard before the line is judged
constexpr double kJudgeAgain_s = 0.5;  // step of further tries
constexpr double kLost_s = 0.5;        // without a cycle the line is judged anew
constexpr double kCouplingMemory_s = 60.0;
constexpr double kEdgeThreshold = 0.25;  // of the counter's swing
constexpr double kOnTime = 0.02;         // of half a cycle: an edge that close to its time is an expected one
constexpr double kSkipped = 0.75;        // of half a cycle after it holds no other edge
constexpr int kToldEach = 5;             // findings of a kind before they are only counted
constexpr std::size_t kChunk = 4096;     // frames handled at once: stays in the cache

}  // namespace

struct LineInDecoder::Impl {
  Impl(const LineInFormat& board, SampleRate sample_rate, const LineInParameters& user)
      : format(board),
        rate(sample_rate),
        parameters(user),
        scales(board, sample_rate),
        history(sample_rate),
        memory_cycles(kCouplingMemory_s * board.cycle_rate_hz),
        scanner(scales, 0),
        tracker(board, sample_rate),
        log(kToldEach),
        decoder(board, sample_rate, user, memory_cycles, log) {}

  // Samples come in contiguous stretches.
  void push(std::span<const float> interleaved);
  void push_with_holes(std::span<const float> interleaved);
  void end_stretch();
  void start_stretch(std::int64_t position);
  void end_hole();
  void drop_old();
  [[nodiscard]] ChannelView data_view() const { return status.swapped ? history.right() : history.left(); }
  [[nodiscard]] ChannelView counter_view() const { return status.swapped ? history.left() : history.right(); }

  // Decoding. `end`: no more samples follow in this stretch.
  void process(bool end);
  bool judge(bool end);
  bool scan(bool end);
  void lose_line(double at);
  void decode_cycle(const CycleBounds& bounds);
  void report_lost(double from, double to, bool found);
  [[nodiscard]] std::int64_t samples(double seconds) const { return std::llround(seconds * rate.hz); }

  LineInFormat format;
  SampleRate rate;
  LineInParameters parameters;
  EdgeScales scales;
  StereoHistory history;
  double memory_cycles;
  std::int64_t hole_from = -1, hole_length = 0;  // a run of non-finite samples

  bool judged = false;
  std::int64_t judge_from = 0;  // start of the stretch to judge
  std::string told_failure;     // why the line cannot be used, as told last
  Diagnostics standing;         // what the last judgement told
  StepScanner scanner;
  std::optional<StepScanner::Step> step;  // found, but its surroundings are not all there yet
  CycleTracker tracker;
  double jitter = 0.0;
  double deadline = 0.0;  // no cycle until then: the line is lost
  bool any_cycle = false, told_lost = false;
  bool interrupted = false;  // samples are known to be missing since the last cycle
  double last_end = 0.0, last_period = 0.0, last_edge = -1e9;
  std::int64_t last_number = -1;

  FindingLog log;
  CycleDecoder decoder;
  LineInStatus status;
  std::vector<LineInCycle> cycles;
};

void LineInDecoder::Impl::push(std::span<const float> interleaved) {
  for (std::size_t at = 0; at < interleaved.size(); at += 2 * kChunk) {
    const auto chunk = interleaved.subspan(at, std::min(2 * kChunk, interleaved.size() - at));
    if (hole_from < 0 && history.append(chunk)) {
      process(false);
    } else {
      push_with_holes(chunk);
    }
  }
  status.left_peak = history.left_peak();
  status.right_peak = history.right_peak();
}

void LineInDecoder::Impl::push_with_holes(std::span<const float> interleaved) {
  const std::size_t frames = interleaved.size() / 2;
  const auto finite = [&](std::size_t frame) {
    return std::isfinite(interleaved[2 * frame]) && std::isfinite(interleaved[2 * frame + 1]);
  };
  std::size_t at = 0;
  while (at < frames) {
    const bool good = finite(at);
    std::size_t to = at + 1;
    while (to < frames && finite(to) == good) {
      ++to;
    }
    if (good) {
      end_hole();
      history.append(interleaved.subspan(2 * at, 2 * (to - at)));
      process(false);
    } else {
      if (hole_from < 0) {
        hole_from = history.position();
        end_stretch();
      }
      hole_length += static_cast<std::int64_t>(to - at);
    }
    at = to;
  }
}

void LineInDecoder::Impl::end_hole() {
  if (hole_from >= 0) {
    log.add({Severity::kError, "line-in.not-finite", fmt::format("{} samples are not numbers", hole_length),
             "The file or device delivers broken data: record again or convert the file anew", "",
             static_cast<double>(hole_from) / rate.hz});
    start_stretch(hole_from + hole_length);
    hole_from = -1;
    hole_length = 0;
  }
}

void LineInDecoder::Impl::end_stretch() {
  process(true);
  step.reset();
  decoder.unlink();
  tracker.restart(tracker.half());
  interrupted = true;
}

void LineInDecoder::Impl::start_stretch(std::int64_t position) {
  history.restart(position);
  judge_from = position;
  scanner = StepScanner(scales, position);
  deadline = static_cast<double>(position) + kLost_s * rate.hz;
}

void LineInDecoder::Impl::process(bool end) {
  while (judged ? scan(end) : judge(end)) {
  }
  drop_old();
}

bool LineInDecoder::Impl::judge(bool end) {
  const std::int64_t until = std::min(history.position(), judge_from + samples(kJudged_s));
  if (until <= judge_from || (until - judge_from < samples(kJudged_s) && !end)) {
    return false;
  }
  const auto part = [&](const ChannelView& channel) { return ChannelView{channel.at(judge_from), judge_from, until}; };
  LineJudgement judgement =
      judge_line(part(history.left()), part(history.right()), format, rate, parameters, memory_cycles);
  status.decided = true;
  if (!judgement.usable) {
    // A failure is told once, not every half second that it lasts.
    for (Diagnostic& finding : judgement.findings) {
      const bool only_short = finding.code == "line-in.too-short" && (any_cycle || !told_failure.empty());
      if (finding.severity == Severity::kError && finding.code != told_failure && !only_short) {
        told_failure = finding.code;
        standing = {finding};
        log.add(std::move(finding));
      }
    }
    judge_from = std::min(history.position(), judge_from + samples(kJudgeAgain_s));
    return true;
  }
  told_failure.clear();
  standing = judgement.findings;
  for (Diagnostic& finding : judgement.findings) {
    log.add(std::move(finding));
  }
  judged = true;
  status.swapped = judgement.swapped;
  status.left_inverted = judgement.left_inverted;
  status.right_inverted = judgement.right_inverted;
  decoder.start(judgement, until);
  tracker.restart(judgement.half_samples);
  scanner = StepScanner(scales, judge_from);
  step.reset();
  deadline = static_cast<double>(until) + kLost_s * rate.hz;
  return true;
}

bool LineInDecoder::Impl::scan(bool end) {
  const ChannelView counter = counter_view();
  const double threshold = kEdgeThreshold * decoder.swing();
  if (!step) {
    step = scanner.next(counter, threshold, end);
  }
  // Decisions go by positions alone: a step after the deadline is not looked at, however early it was pushed.
  const double reached = step ? static_cast<double>(step->near) : static_cast<double>(scanner.position());
  if (reached > deadline) {
    lose_line(deadline);
    return true;
  }
  if (!step || (!end && step->near + scales.reach() > counter.last)) {
    return false;
  }
  auto edge = time_edge(counter, step->near, decoder.counter_kappa(), scales);
  step.reset();
  if (edge) {
    edge->rising = edge->rising != status.right_inverted;
    if (const auto bounds = tracker.push(*edge)) {
      decode_cycle(*bounds);
    }
    // The edge came when it was due: the next one is not due before most of a half cycle has passed.
    if (std::fabs(edge->position - last_edge - tracker.half()) < kOnTime * tracker.half()) {
      scanner.skip_to(static_cast<std::int64_t>(edge->position + kSkipped * tracker.half()));
    }
    last_edge = edge->position;
  }
  return true;
}

void LineInDecoder::Impl::lose_line(double at) {
  judged = false;
  status.locked = false;
  if (any_cycle && !told_lost && !interrupted) {
    report_lost(last_end, at, false);
    told_lost = true;
  }
  judge_from = std::clamp(static_cast<std::int64_t>(at - kLost_s * rate.hz), history.first(), history.position());
  step.reset();
}

void LineInDecoder::Impl::report_lost(double from, double to, bool found) {
  log.add({Severity::kWarning, "line-in.sync-lost",
           found ? fmt::format("the counter was lost for {:.0f} ms ({:.0f} cycles)", 1e3 * (to - from) / rate.hz,
                               (to - from) / last_period)
                 : fmt::format("the counter is gone (nothing for {:.0f} ms)", 1e3 * (to - from) / rate.hz),
           "Check the plug and the cable; if samples were dropped, close other programs or take a larger buffer", "",
           from / rate.hz});
}

void LineInDecoder::Impl::decode_cycle(const CycleBounds& bounds) {
  const double period = bounds.end - bounds.start;
  LineInCycle out;
  out.start_sample = bounds.start;
  out.period_samples = period;
  const bool follows = any_cycle && std::fabs(bounds.start - last_end) < 1e-9;
  out.number = last_number + 1;
  if (any_cycle && !follows) {
    const auto lost = std::max<std::int64_t>(0, std::llround((bounds.start - last_end) / period));
    out.number += lost;
    out.gap_before = true;
    status.lost_cycles += lost;
    if (!interrupted && !told_lost) {
      report_lost(last_end, bounds.start, true);
    }
  }
  decoder.decode(bounds, data_view(), counter_view(), out);

  if (follows) {
    const double change = (period - last_period) / period;
    jitter += (change * change - jitter) / 30.0;
  }
  any_cycle = true;
  told_lost = interrupted = false;
  last_end = bounds.end;
  last_period = period;
  last_number = out.number;
  deadline = bounds.end + kLost_s * rate.hz;

  status.locked = true;
  status.cycle_rate_hz = rate.hz / period;
  status.clock_jitter = std::sqrt(jitter);
  ++status.cycles;
  decoder.tell(status);
  cycles.push_back(out);
}

void LineInDecoder::Impl::drop_old() {
  std::int64_t keep = judge_from;
  if (judged) {
    // The cycle that is under way, and what a judgement would start from if the line were lost now.
    keep = std::min(
               {scanner.needs_from(), decoder.needs_from(), static_cast<std::int64_t>(deadline - kLost_s * rate.hz)}) -
           4 * scales.reach();
  }
  history.drop_before(keep);
}

LineInDecoder::LineInDecoder(const LineInFormat& format, SampleRate rate, const LineInParameters& parameters)
    : impl_(std::make_unique<Impl>(format, rate, parameters)) {
  assert(format.slots >= 4 && format.slots <= kMaxSlots && format.slots % 2 == 0);
  assert(rate.hz > 0.0 && format.cycle_rate_hz > 0.0);
}
LineInDecoder::~LineInDecoder() = default;
LineInDecoder::LineInDecoder(LineInDecoder&&) noexcept = default;
LineInDecoder& LineInDecoder::operator=(LineInDecoder&&) noexcept = default;

void LineInDecoder::push(std::span<const float> interleaved) {
  impl_->push(interleaved);
}

void LineInDecoder::finish() {
  impl_->end_hole();
  impl_->end_stretch();
  impl_->start_stretch(impl_->history.position());
  sum_up_findings();
}

void LineInDecoder::restart_findings() {
  impl_->log.restart();
  impl_->decoder.restart_findings();
  for (const Diagnostic& finding : impl_->standing) {
    impl_->log.add(finding);
  }
}

void LineInDecoder::sum_up_findings() {
  impl_->decoder.sum_up_findings();
  impl_->log.summarise();
}

std::vector<LineInCycle> LineInDecoder::take_cycles() {
  return std::exchange(impl_->cycles, {});
}

Diagnostics LineInDecoder::take_diagnostics() {
  return impl_->log.take();
}

const LineInStatus& LineInDecoder::status() const {
  return impl_->status;
}

}  // namespace limbwave::decode
