#include "calibration/cue_sounds.h"

#include <QApplication>
#include <QTimer>

namespace limbwave::ui {
namespace {

constexpr auto kMutedKey = "calibrate/muted";
constexpr int kGap_ms = 180;  // between the sounds of one cue; closer ones run into each other

/// The system's bell has one voice, so that cues differ in number.
int bells(CueSounds::Cue cue) {
  switch (cue) {
    case CueSounds::Cue::kTick:
      return 1;
    case CueSounds::Cue::kGo:
    case CueSounds::Cue::kDone:
      return 2;
    case CueSounds::Cue::kLost:
      return 4;
  }
  return 1;
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
  if (muted_) {
    return;
  }
  QApplication::beep();
  for (int i = 1; i < bells(cue); ++i) {
    QTimer::singleShot(i * kGap_ms, this, [this] {
      if (!muted_) {
        QApplication::beep();
      }
    });
  }
  Q_EMIT played(cue);
}

}  // namespace limbwave::ui
