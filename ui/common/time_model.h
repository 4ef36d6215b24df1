/// The one playhead and the one visible range that plots, timeline, curves and viewer share, and playing.
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

namespace limbwave::ui {

class TimeModel : public QObject {
  Q_OBJECT
 public:
  /// `now_ns`: a clock that never goes back, nanoseconds; tests bring their own.
  explicit TimeModel(QObject* parent = nullptr, std::function<qint64()> now_ns = {});

  [[nodiscard]] double duration_s() const { return duration_s_; }
  [[nodiscard]] double frame_s() const { return frame_s_; }  ///< Length of a frame of the clip, seconds.
  /// How many frames lie on the clip, from time 0 on, both ends included: what can be stepped over and what an export
  /// at this rate writes (motion::frame_count). 0 without a clip.
  [[nodiscard]] qint64 frames() const;
  /// The frame under the playhead, from 0: it stands until the next.
  [[nodiscard]] qint64 frame() const;
  [[nodiscard]] double playhead_s() const { return playhead_s_; }
  [[nodiscard]] double visible_begin_s() const { return begin_s_; }
  [[nodiscard]] double visible_end_s() const { return end_s_; }
  [[nodiscard]] bool playing() const { return playing_; }
  [[nodiscard]] bool looping() const { return looping_; }
  [[nodiscard]] double speed() const { return speed_; }

  /// A new clip: all of it becomes visible, the playhead goes to its start, playing stops.
  void set_extent(double duration_s, double frame_s);
  /// The same clip, a little longer or shorter than it was thought to be: playhead and visible range stay.
  void correct_duration(double duration_s);
  /// Kept within 0 .. duration.
  void set_playhead(double time_s);
  /// Kept within 0 .. duration and at least four frames wide.
  void set_visible(double begin_s, double end_s);
  /// Enlarges (`factor` > 1) about a time that stays where it is on screen.
  void zoom(double factor, double about_s);
  void show_all() { set_visible(0.0, duration_s_); }
  /// Moves by whole frames and rests on one; stops playing.
  void step(int frames);
  void set_looping(bool looping);
  /// −8 .. 8, not 0; negative plays backwards.
  void set_speed(double speed);
  /// At the end it starts again from the beginning.
  void set_playing(bool playing);
  void toggle_playing() { set_playing(!playing_); }
  /// Lets `elapsed_s` pass while playing.
  void advance(double elapsed_s);
  /// Moves the playhead to where the clock has got to; the timer calls it.
  void catch_up();

 Q_SIGNALS:
  void extent_changed();
  void playhead_changed(double time_s);
  void visible_changed(double begin_s, double end_s);
  void playing_changed(bool playing);
  void options_changed();  ///< Speed or looping.

 private:
  double duration_s_ = 0.0, frame_s_ = 1.0 / 60.0, playhead_s_ = 0.0, begin_s_ = 0.0, end_s_ = 0.0, speed_ = 1.0;
  bool playing_ = false, looping_ = true;
  QTimer timer_;
  std::function<qint64()> now_ns_;
  qint64 last_ns_ = 0;  ///< The clock's reading that the playhead stands for.
};

}  // namespace limbwave::ui
