/// Which boards can be believed at an instant: one that has fallen silent, or that says the same for ever, is named and
/// left out, and taken back when it comes to life. Looks at readings alone; causal.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/diagnostics.h"
#include "estimate/body_model.h"

namespace limbwave {
class JsonReader;
}

namespace limbwave::estimate {

struct SensorWatchParameters {
  double silence_s = 0.1;    ///< No word for so long (or five of its intervals): the board is silent.
  double frozen_s = 0.15;    ///< The same six numbers for so long, where others tremble: it is frozen.
  double told_s = 0.5;       ///< Shorter outages are not reported one by one.
  double blackout_s = 0.25;  ///< No reading of any sensor for so long.
  double least_force = 1.0;  ///< m/s²: a mean specific force below is no accelerometer at work (nobody falls so long).
};

enum class BoardState : std::uint8_t { kWell, kSilent, kFrozen };

class SensorWatch {
 public:
  SensorWatch(const BodyModel& model, const SensorWatchParameters& parameters);

  /// Takes in the readings of the next instant, in order of time.
  void push(const BodyInstant& instant);
  [[nodiscard]] BoardState board(std::size_t b) const { return boards_[b].state; }
  [[nodiscard]] double since(std::size_t b) const { return boards_[b].since; }
  /// Silence of all sensors that ended with the newest instant, seconds; 0: there was none.
  [[nodiscard]] double blackout() const { return blackout_; }
  /// What happened, in the user's words, up to `end_s`.
  [[nodiscard]] Diagnostics findings(double end_s) const;

  /// All that later instants depend on, and back.
  [[nodiscard]] nlohmann::json save() const;
  void load(const JsonReader& saved);

 private:
  struct Outage {
    BoardState kind = BoardState::kSilent;
    double begin = 0.0, end = -1.0;  ///< End before begin: not over.
  };
  struct Board {
    BoardState state = BoardState::kWell;
    double since = 0.0;
    double last = 0.0, interval = 0.0;  ///< Time of the newest word; usual time between two.
    bool heard = false;
    Vector3d w = Vector3d::Zero(), f = Vector3d::Zero();
    double same_since = 0.0;  ///< Since when the words are all the same.
    int words = 0, same = 0;
    bool has_frozen = false;  ///< It once said the same for a while, as nothing that trembles does.
    Vector3d mean_force = Vector3d::Zero();
    std::vector<Outage> outages;
  };
  void begin(Board& board, BoardState state, double since);
  void finish(Board& board, double now);
  [[nodiscard]] bool others_tremble(std::size_t b) const;

  const BodyModel& model_;
  SensorWatchParameters parameters_;
  std::vector<Board> boards_;
  std::vector<Outage> blackouts_;
  double first_ = 0.0, last_ = 0.0, blackout_ = 0.0;
  bool started_ = false;
};

}  // namespace limbwave::estimate
