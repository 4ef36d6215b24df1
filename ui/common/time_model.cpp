#include "common/time_model.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "motion/clip.h"

namespace limbwave::ui {

TimeModel::TimeModel(QObject* parent, std::function<qint64()> now_ns) : QObject(parent), now_ns_(std::move(now_ns)) {
  if (!now_ns_) {
    now_ns_ = [] { return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count(); };
  }
  timer_.setInterval(16);
  timer_.setTimerType(Qt::PreciseTimer);
  connect(&timer_, &QTimer::timeout, this, &TimeModel::catch_up);
}

void TimeModel::catch_up() {
  // One reading for both, so that no time is lost between them.
  const qint64 now = now_ns_();
  const double passed_s = static_cast<double>(now - last_ns_) * 1e-9;
  last_ns_ = now;
  advance(passed_s);
}

void TimeModel::set_extent(double duration_s, double frame_s) {
  set_playing(false);
  duration_s_ = std::isfinite(duration_s) ? std::max(0.0, duration_s) : 0.0;
  frame_s_ = std::isfinite(frame_s) && frame_s > 0.0 ? frame_s : 1.0 / 60.0;
  playhead_s_ = 0.0;
  begin_s_ = 0.0;
  end_s_ = duration_s_;
  Q_EMIT extent_changed();
  Q_EMIT visible_changed(begin_s_, end_s_);
  Q_EMIT playhead_changed(playhead_s_);
}

void TimeModel::correct_duration(double duration_s) {
  if (!std::isfinite(duration_s) || duration_s < 0.0 || duration_s == duration_s_) {
    return;
  }
  const bool all = begin_s_ == 0.0 && end_s_ == duration_s_;
  duration_s_ = duration_s;
  playhead_s_ = std::min(playhead_s_, duration_s_);
  Q_EMIT extent_changed();
  set_visible(begin_s_, all ? duration_s_ : std::min(end_s_, duration_s_));
  Q_EMIT playhead_changed(playhead_s_);
}

qint64 TimeModel::frames() const {
  return duration_s_ > 0.0 ? static_cast<qint64>(motion::frame_count(duration_s_, 1.0 / frame_s_)) : 0;
}

qint64 TimeModel::frame() const {
  constexpr double kOnFrame = 1e-3;  // A playhead that was stepped onto a frame is on it.
  return std::clamp<qint64>(static_cast<qint64>(std::floor(playhead_s_ / frame_s_ + kOnFrame)), 0,
                            std::max<qint64>(1, frames()) - 1);
}

void TimeModel::set_playhead(double time_s) {
  if (!std::isfinite(time_s)) {
    return;
  }
  const double clamped = std::clamp(time_s, 0.0, duration_s_);
  if (clamped != playhead_s_) {
    playhead_s_ = clamped;
    Q_EMIT playhead_changed(playhead_s_);
  }
}

void TimeModel::set_visible(double begin_s, double end_s) {
  if (!std::isfinite(begin_s) || !std::isfinite(end_s)) {
    return;
  }
  if (end_s < begin_s) {
    std::swap(begin_s, end_s);
  }
  const double width = std::clamp(end_s - begin_s, std::min(4.0 * frame_s_, duration_s_), duration_s_);
  const double middle = 0.5 * (begin_s + end_s);
  const double begin = std::clamp(middle - 0.5 * width, 0.0, duration_s_ - width);
  if (begin != begin_s_ || begin + width != end_s_) {
    begin_s_ = begin;
    end_s_ = begin + width;
    Q_EMIT visible_changed(begin_s_, end_s_);
  }
}

void TimeModel::zoom(double factor, double about_s) {
  if (!(factor > 0.0) || !std::isfinite(factor)) {
    return;
  }
  const double width = std::clamp((end_s_ - begin_s_) / factor, std::min(4.0 * frame_s_, duration_s_), duration_s_);
  const double at = end_s_ > begin_s_ ? (about_s - begin_s_) / (end_s_ - begin_s_) : 0.5;
  set_visible(about_s - at * width, about_s + (1.0 - at) * width);
}

void TimeModel::step(int frames) {
  set_playing(false);
  set_playhead((std::round(playhead_s_ / frame_s_) + frames) * frame_s_);
}

void TimeModel::set_looping(bool looping) {
  if (looping != looping_) {
    looping_ = looping;
    Q_EMIT options_changed();
  }
}

void TimeModel::set_speed(double speed) {
  if (speed != 0.0 && std::isfinite(speed) && speed != speed_) {
    speed_ = std::clamp(speed, -8.0, 8.0);
    Q_EMIT options_changed();
  }
}

void TimeModel::set_playing(bool playing) {
  if (playing == playing_ || (playing && duration_s_ <= 0.0)) {
    return;
  }
  playing_ = playing;
  if (playing_) {
    if (speed_ > 0.0 && playhead_s_ >= duration_s_) {
      set_playhead(0.0);
    } else if (speed_ < 0.0 && playhead_s_ <= 0.0) {
      set_playhead(duration_s_);
    }
    last_ns_ = now_ns_();
    timer_.start();
  } else {
    timer_.stop();
  }
  Q_EMIT playing_changed(playing_);
}

void TimeModel::advance(double elapsed_s) {
  if (!playing_ || duration_s_ <= 0.0) {
    return;
  }
  double next = playhead_s_ + speed_ * elapsed_s;
  if (next < 0.0 || next > duration_s_) {
    if (!looping_) {
      set_playhead(next);
      set_playing(false);
      return;
    }
    next = std::fmod(next, duration_s_);
    next = next < 0.0 ? next + duration_s_ : next;
  }
  set_playhead(next);
}

}  // namespace limbwave::ui
