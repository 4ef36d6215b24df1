#include "calibration/cue_sounds.h"

#include <QCoreApplication>
#include <QPointer>
#include <utility>

namespace limbwave::ui {
namespace {

constexpr auto kMutedKey = "calibrate/muted";
/// Told apart by pitch and rhythm, not by pitch alone.
std::vector<acquire::Tone> tones_of(CueSounds::Cue cue) {
  const auto tone = [](double hz, double seconds) { return acquire::Tone{hz, seconds}; };
  const acquire::Tone gap{0.0, 0.07};
  switch (cue) {
    case CueSounds::Cue::kTick:
      return {tone(880.0, 0.09)};
    case CueSounds::Cue::kGo:
      return {tone(1320.0, 0.45)};
    case CueSounds::Cue::kDone:
      return {tone(880.0, 0.12), tone(1108.7, 0.12), tone(1318.5, 0.25)};
    case CueSounds::Cue::kLost:
      return {tone(330.0, 0.18), gap, tone(330.0, 0.18), gap, tone(247.0, 0.5)};
  }
  return {};
}

}  // namespace

CueSounds::CueSounds(QSettings& settings, QObject* parent)
    : QObject(parent), settings_(settings), muted_(settings.value(QLatin1String(kMutedKey), false).toBool()) {}

void CueSounds::set_muted(bool muted) {
  if (muted != muted_) {
    muted_ = muted;
    settings_.setValue(QLatin1String(kMutedKey), muted);
    Q_EMIT muted_changed(muted);
  }
}

void CueSounds::play(Cue cue) {
  if (!muted_) {
    player_.play(tones_of(cue));
    Q_EMIT played(cue);
  }
}

void CueSounds::test() {
  std::vector<acquire::Tone> tones;
  for (const Cue cue : {Cue::kTick, Cue::kTick, Cue::kGo}) {
    const std::vector<acquire::Tone> more = tones_of(cue);
    tones.insert(tones.end(), more.begin(), more.end());
    tones.push_back({0.0, 0.35});
  }
  player_.play(std::move(tones), [self = QPointer<CueSounds>(this)](const Status& status) {
    // Only copies of the pointer are touched on the player's thread.
    QMetaObject::invokeMethod(qApp, [self, status] {
      if (self) {
        Q_EMIT self->tested(status);
      }
    });
  });
}

}  // namespace limbwave::ui
