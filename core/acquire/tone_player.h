/// Short tones through the default output, for people who cannot look at the screen.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "base/result.h"

namespace limbwave::acquire {

struct Tone {
  double hz = 440.0;       ///< 0: silence.
  double seconds = 0.1;    ///< Its ends are rounded off over 8 ms each, so that nothing clicks.
  double loudness = 0.35;  ///< Peak, fraction of full scale.
};

/// The tones one after the other as mono samples, fraction of full scale.
std::vector<float> render_tones(const std::vector<Tone>& tones, double rate_hz);

/// Plays on a thread of its own. The output is opened with the first tones and given back after a few quiet seconds, so
/// that other programs and other outputs have their turn.
class TonePlayer {
 public:
  TonePlayer();
  ~TonePlayer();  ///< What still waits is not heard any more.
  TonePlayer(const TonePlayer&) = delete;
  TonePlayer& operator=(const TonePlayer&) = delete;

  /// Returns at once; what is being played is heard to its end first. `played` is called on the player's thread: fails
  /// where there is no output, or when it does not take the tones.
  void play(std::vector<Tone> tones, std::function<void(const Status&)> played = {});

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace limbwave::acquire
