/// Sounds for people who wear the suit or turn a sensor and cannot look at the
/// screen. Can be muted; the setting stays.
#pragma once

#include <QObject>
#include <QSettings>

#include "acquire/tone_player.h"

namespace limbwave::ui {

class CueSounds : public QObject {
  Q_OBJECT
 public:
  enum class Cue {
    kTick,  ///< A second of the countdown.
    kGo,    ///< Hold still now.
    kDone,  ///< A pose is captured, a sensor has enough.
    kLost   ///< The device is gone.
  };
  Q_ENUM(Cue)

  explicit CueSounds(QSettings& settings, QObject* parent = nullptr);
  [[nodiscard]] bool muted() const { return muted_; }
  void set_muted(bool muted);
  /// Nothing is heard while muted, or where there is no output.
  void play(Cue cue);
  /// Plays a countdown, muted or not; ends in `tested`.
  void test();

 Q_SIGNALS:
  void muted_changed(bool muted);
  void played(limbwave::ui::CueSounds::Cue cue);
  void tested(const limbwave::Status& status);

 private:
  QSettings& settings_;
  bool muted_;
  acquire::TonePlayer player_;
};

}  // namespace limbwave::ui
