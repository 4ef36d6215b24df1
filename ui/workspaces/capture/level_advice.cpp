#include "workspaces/capture/level_advice.h"

#include <QCoreApplication>
#include <algorithm>
#include <set>

#include "common/core_text.h"
#include "common/format.h"
#include "plots/level_meter.h"

namespace limbwave::ui {
namespace {

/// lupdate knows this as the context "LevelAdvice".
struct LevelAdvice {
  Q_DECLARE_TR_FUNCTIONS(LevelAdvice)
 public:
  static Advice from_levels(const decode::LineInStatus& line);
};

/// What can be said from levels alone, before or without the decoder's own findings.
Advice LevelAdvice::from_levels(const decode::LineInStatus& line) {
  const double data = line.swapped ? line.right_peak : line.left_peak;
  if (std::max(line.left_peak, line.right_peak) < 0.001) {
    return {Tone::kDanger, tr("Nothing comes in"),
            tr("Check the cable, that the board has power, and that this is the input it is plugged into.")};
  }
  if (!line.locked && line.decided) {
    return {Tone::kDanger, tr("This does not sound like the board"),
            tr("Choose the line input, not the microphone; use a stereo cable; switch off echo cancelling and noise "
               "suppression of the sound system.")};
  }
  if (!line.locked) {
    return {Tone::kUnknown, tr("Listening"), tr("The line is being judged; this takes about a second.")};
  }
  if (data > kLevelTooHigh) {
    return {Tone::kWarning, tr("Too high"),
            tr("Turn the recording volume down a little, or quick movements will clip.")};
  }
  if (data < kLevelTooLow) {
    return {Tone::kWarning, tr("Too low"),
            tr("Turn the recording volume up until the bar stands in the green zone; now it is at %1.")
                .arg(format_level(data))};
  }
  return {Tone::kGood, tr("Level is good"), {}};
}

}  // namespace

std::vector<Advice> level_advice(const solve::LiveSnapshot* snapshot) {
  std::vector<Advice> advice;
  if (snapshot == nullptr) {
    advice.push_back({Tone::kUnknown, LevelAdvice::tr("No device is open"), LevelAdvice::tr("Choose one above.")});
    return advice;
  }
  if (!snapshot->source_alive) {
    advice.push_back({snapshot->recording ? Tone::kDanger : Tone::kWarning,
                      LevelAdvice::tr("The device has stopped sending"),
                      LevelAdvice::tr("Plug it in again, look for devices again, and choose it once more.")});
    return advice;
  }
  // The decoder's findings of the last seconds, each once, the newest words of it.
  std::set<std::string> seen;
  for (auto finding = snapshot->diagnostics.rbegin(); finding != snapshot->diagnostics.rend(); ++finding) {
    const bool fresh = finding->time_s < 0.0 || snapshot->stream_time_s - finding->time_s <= kAdviceMemory_s;
    if (!fresh || finding->severity == Severity::kInfo || !seen.insert(finding->code).second) {
      continue;
    }
    QString title = as_sentence(core_text(finding->message));
    title.chop(1);
    const QString remedy = as_sentence(core_text(finding->remedy));
    advice.push_back({finding->severity == Severity::kError ? Tone::kDanger : Tone::kWarning, title, remedy});
  }
  const Advice levels = LevelAdvice::from_levels(snapshot->line);
  // Where the decoder has already said what is wrong, the guess from levels adds nothing.
  if (advice.empty() || levels.title == LevelAdvice::tr("Nothing comes in")) {
    advice.push_back(levels);
  }
  std::stable_sort(advice.begin(), advice.end(), [](const Advice& a, const Advice& b) { return a.tone > b.tone; });
  if (!snapshot->recording) {
    // Red is for losing data.
    for (Advice& one : advice) {
      one.tone = std::min(one.tone, Tone::kWarning);
    }
  }
  return advice;
}

}  // namespace limbwave::ui
