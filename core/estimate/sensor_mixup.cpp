#include "estimate/sensor_mixup.h"

#include <algorithm>
#include <cmath>

namespace limbwave::estimate {
namespace {

constexpr double kStrangeShare = 0.02;  // of readings beyond the gate; where all is right next to none are
constexpr double kStrangeNis = 4.0;     // mean per scalar of a board that is where it should be: about 1
constexpr std::size_t kSuspects = 4;
constexpr double kTurning = 10.0;  // rad that suspects turn within the stretch
constexpr double kLongest = 20.0;  // seconds
constexpr double kShortest = 3.0;
constexpr double kLeastGain = 100.0;     // of log likelihood, and
constexpr double kLeastGainRate = 0.02;  // per scalar of the suspects

double mean_nis(const ReadingCount& count) {
  return count.nis_sum / static_cast<double>(std::max<std::int64_t>(1, count.used + count.gated));
}

double gated_share(const ReadingCount& count) {
  return static_cast<double>(count.gated) / static_cast<double>(std::max<std::int64_t>(1, count.used + count.gated));
}

// The first part of a recording, up to a time.
BodyReadings head(const BodyReadings& readings, double end_s) {
  BodyReadings part;
  const auto copy = [&](const auto& from, auto& to) {
    std::copy_if(from.begin(), from.end(), std::back_inserter(to), [&](const auto& r) { return r.time_s <= end_s; });
  };
  copy(readings.inertial, part.inertial);
  copy(readings.ranges, part.ranges);
  part.root = readings.root;
  return part;
}

double stretch_end(const BodyReadings& readings, const std::vector<int>& suspects) {
  const double begin = readings.inertial.front().time_s;
  std::vector<double> turned(suspects.size(), 0.0);
  std::vector<double> last(suspects.size(), begin);
  for (const InertialReading& reading : readings.inertial) {
    const auto at = std::find(suspects.begin(), suspects.end(), reading.board);
    if (at == suspects.end() || !reading.w_S.allFinite()) {
      continue;
    }
    const auto i = static_cast<std::size_t>(at - suspects.begin());
    turned[i] += reading.w_S.norm() * std::min(0.1, reading.time_s - last[i]);
    last[i] = reading.time_s;
    const double since = reading.time_s - begin;
    if (since > kLongest || (since > kShortest && *std::max_element(turned.begin(), turned.end()) > kTurning)) {
      return reading.time_s;
    }
  }
  return readings.inertial.back().time_s;
}

bool inertial(const BodyBoard& board) {
  return board.gyroscope || board.accelerometer;
}

// Boards along the limb, to both sides, and those on brothers of the segment: what a hand may confuse.
std::vector<int> neighbours(const BodyModel& model, int board) {
  const std::vector<body::Segment>& segments = model.skeleton.segments;
  const auto board_on = [&](int segment) {
    for (std::size_t b = 0; b < model.boards.size(); ++b) {
      if (model.boards[b].segment == segment && inertial(model.boards[b]) && static_cast<int>(b) != board) {
        return static_cast<int>(b);
      }
    }
    return -1;
  };
  // The next board upward of a segment.
  const auto above = [&](int segment) {
    int s = segments[static_cast<std::size_t>(segment)].parent;
    while (s >= 0 && board_on(s) < 0) {
      s = segments[static_cast<std::size_t>(s)].parent;
    }
    return s;
  };
  const int own = model.boards[static_cast<std::size_t>(board)].segment;
  const int parent = above(own);
  std::vector<int> found;
  for (std::size_t b = 0; b < model.boards.size(); ++b) {
    const int segment = model.boards[b].segment;
    if (static_cast<int>(b) == board || !inertial(model.boards[b])) {
      continue;
    }
    // Mirror images differ in the sign of their place only.
    const Vector3d& p = segments[static_cast<std::size_t>(own)].p_PL;
    const Vector3d& q = segments[static_cast<std::size_t>(segment)].p_PL;
    const bool same_length = std::abs(segments[static_cast<std::size_t>(own)].length -
                                      segments[static_cast<std::size_t>(segment)].length) < 1e-6;
    const bool mirrored = same_length && (p.cwiseAbs() - q.cwiseAbs()).norm() < 1e-6 && own != segment;
    if (segment == parent || above(segment) == own || segment == own || mirrored) {
      found.push_back(static_cast<int>(b));
    }
  }
  return found;
}

}  // namespace

std::vector<int> suspicious_boards(const BodyModel& model, const BodyRun& run, const BodyWatch& watch) {
  std::vector<std::pair<double, int>> ranked;
  for (std::size_t b = 0; b < model.boards.size(); ++b) {
    double strange = std::max(mean_nis(run.gyroscopes[b]), mean_nis(run.accelerometers[b]));
    strange = watch.turned()[b] != 0 ? 1e9 : strange;
    const double share = std::max(gated_share(run.gyroscopes[b]), gated_share(run.accelerometers[b]));
    if (strange > kStrangeNis || share > kStrangeShare) {
      ranked.emplace_back(-strange, static_cast<int>(b));
    }
  }
  std::sort(ranked.begin(), ranked.end());
  std::vector<int> boards;
  boards.reserve(ranked.size());
  for (const auto& [strange, board] : ranked) {
    boards.push_back(board);
  }
  return boards;
}

void undo_mixup(const Mixup& mixup, BodyReadings& readings) {
  const auto other = [&](int board) {
    return board == mixup.board ? mixup.other : (board == mixup.other ? mixup.board : board);
  };
  for (InertialReading& reading : readings.inertial) {
    if (mixup.other >= 0) {
      reading.board = other(reading.board);
    } else if (reading.board == mixup.board) {
      reading.w_S = mixup.turn * reading.w_S;
      reading.f_S = mixup.turn * reading.f_S;
    }
  }
  for (RangeReading& reading : readings.ranges) {
    reading.board = mixup.other >= 0 ? other(reading.board) : reading.board;
  }
}

Result<std::optional<Mixup>> find_mixup(const BodyModel& model, const BodyFilterParameters& parameters,
                                        const BodyWatchParameters& watch_parameters, const BodyReadings& readings,
                                        const std::vector<int>& suspects, const Progress& progress) {
  if (suspects.empty() || readings.inertial.empty()) {
    return std::optional<Mixup>{};
  }
  const std::vector<int> worst(suspects.begin(),
                               suspects.begin() + static_cast<std::ptrdiff_t>(std::min(suspects.size(), kSuspects)));
  const BodyReadings stretch = head(readings, stretch_end(readings, worst));
  std::vector<Mixup> hypotheses(1);  // first: nothing is wrong
  for (const int board : worst) {
    for (const int other : neighbours(model, board)) {
      const bool known = std::any_of(hypotheses.begin(), hypotheses.end(), [&](const Mixup& m) {
        return m.board == std::max(board, other) && m.other == std::min(board, other);
      });
      if (!known) {
        hypotheses.push_back({std::max(board, other), std::min(board, other)});
      }
    }
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d about = Vector3d::Unit(axis);
      hypotheses.push_back({board, -1, Quaterniond(Eigen::AngleAxisd(EIGEN_PI, about)), axis});
    }
  }
  std::optional<Mixup> best;
  double likelihood = 0.0;
  std::int64_t scalars = 0;
  for (const InertialReading& reading : stretch.inertial) {
    scalars += std::find(worst.begin(), worst.end(), reading.board) != worst.end() ? 6 : 0;
  }
  // A turned board is left out by the watch; here everybody takes part, for all hypotheses to explain the same.
  BodyWatchParameters everybody = watch_parameters;
  everybody.rest.turned = 10.0;
  for (std::size_t i = 0; i < hypotheses.size(); ++i) {
    if (!progress.report(static_cast<double>(i) / static_cast<double>(hypotheses.size()),
                         "looking for mixed up sensors")) {
      return cancelled();
    }
    BodyReadings explained = stretch;
    if (i > 0) {
      undo_mixup(hypotheses[i], explained);
    }
    BodyWatch watch(model, everybody);
    Result<BodyRun> run = filter_body(model, parameters, explained, 1.0, {}, &watch);
    if (!run) {
      return run.error();
    }
    if (i == 0) {
      likelihood = run->log_likelihood;
      continue;
    }
    hypotheses[i].gain = run->log_likelihood - likelihood;
    if (!best || hypotheses[i].gain > best->gain) {
      best = hypotheses[i];
    }
  }
  const double least = std::max(kLeastGain, kLeastGainRate * static_cast<double>(scalars));
  return best && best->gain > least ? best : std::optional<Mixup>{};
}

Diagnostic tell(const Mixup& mixup, const BodyModel& model) {
  const std::string& name = model.boards[static_cast<std::size_t>(mixup.board)].name;
  if (mixup.other >= 0) {
    const std::string& other = model.boards[static_cast<std::size_t>(mixup.other)].name;
    return {Severity::kWarning, "body.boards-swapped",
            "\"" + other + "\" and \"" + name + "\" are exchanged: solved as if each were in the other's place",
            "exchange them, or their wires, before the next recording", name};
  }
  return {Severity::kWarning, "body.board-upside-down",
          "\"" + name + "\" is mounted the wrong way round: solved as if turned by 180° about its " +
              std::string(1, static_cast<char>('x' + mixup.axis)) + " axis",
          "turn it round, or say so in the rig", name};
}

}  // namespace limbwave::estimate
