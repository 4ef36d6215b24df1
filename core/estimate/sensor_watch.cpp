#include "estimate/sensor_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"

namespace limbwave::estimate {
namespace {

std::string seconds(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f s", value);
  return text;
}

bool same(const Vector3d& a, const Vector3d& b) {
  for (int i = 0; i < 3; ++i) {
    if (!(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))) {
      return false;
    }
  }
  return true;
}

}  // namespace

SensorWatch::SensorWatch(const BodyModel& model, const SensorWatchParameters& parameters)
    : model_(model), parameters_(parameters), boards_(model.boards.size()) {}

void SensorWatch::begin(Board& board, BoardState state, double since) {
  if (board.state == state) {
    return;
  }
  finish(board, since);
  board.state = state;
  board.since = since;
  board.outages.push_back({state, since, since - 1.0});
}

void SensorWatch::finish(Board& board, double now) {
  if (board.state != BoardState::kWell) {
    board.outages.back().end = std::max(now, board.outages.back().begin);
    board.state = BoardState::kWell;
  }
}

// In simulations without noise everybody is still to the last digit; no real chip is.
bool SensorWatch::others_tremble(std::size_t b) const {
  int trembling = 0;
  int still = 0;
  for (std::size_t i = 0; i < boards_.size(); ++i) {
    if (i != b && boards_[i].words > 3) {
      const bool unchanged = boards_[i].has_frozen || boards_[i].same >= 4;
      ++(unchanged && boards_[i].state != BoardState::kFrozen ? still : trembling);
    }
  }
  return trembling > 2 * still;
}

void SensorWatch::push(const BodyInstant& instant) {
  const SensorWatchParameters& p = parameters_;
  const double now = instant.time_s;
  blackout_ = 0.0;
  if (!started_) {
    started_ = true;
    first_ = now;
  } else if (now - last_ > p.blackout_s) {
    blackout_ = now - last_;
    blackouts_.push_back({BoardState::kSilent, last_, now});
    // Nobody in particular was silent meanwhile.
    for (Board& board : boards_) {
      if (board.state == BoardState::kWell) {
        board.last += blackout_;
        board.same_since += blackout_;
      }
    }
  }
  last_ = now;
  for (std::size_t i = 0; i < instant.inertials; ++i) {
    const InertialReading& word = instant.inertial[i];
    const auto b = static_cast<std::size_t>(word.board);
    Board& board = boards_[b];
    if (word.w_S.array().isNaN().all() && word.f_S.array().isNaN().all()) {
      continue;
    }
    if (board.state == BoardState::kSilent) {
      finish(board, now);
    }
    if (board.heard && now > board.last) {
      const double dt = now - board.last;
      board.interval = board.interval == 0.0 ? dt : board.interval + 0.1 * (std::min(dt, p.silence_s) - board.interval);
    }
    if (!board.heard || !same(word.w_S, board.w) || !same(word.f_S, board.f)) {
      board.same_since = now;
      board.same = 0;
      if (board.state == BoardState::kFrozen) {
        finish(board, now);
      }
    } else {
      ++board.same;
    }
    board.heard = true;
    board.last = now;
    board.w = word.w_S;
    board.f = word.f_S;
    ++board.words;
    const bool unchanged = board.same >= 8 && now - board.same_since > p.frozen_s;
    const bool dead_force = unchanged && word.f_S.allFinite() && word.f_S.norm() < p.least_force;
    board.has_frozen = board.has_frozen || unchanged;
    if (unchanged && board.state == BoardState::kWell && (dead_force || (boards_.size() > 2 && others_tremble(b)))) {
      begin(board, BoardState::kFrozen, board.same_since);
    }
  }
  // Who has not been heard for long, while others were.
  if (instant.inertials > 0) {
    for (Board& board : boards_) {
      const bool measures = model_.boards[static_cast<std::size_t>(&board - boards_.data())].gyroscope ||
                            model_.boards[static_cast<std::size_t>(&board - boards_.data())].accelerometer;
      const double heard = board.heard ? board.last : first_;
      if (measures && board.state != BoardState::kSilent && now - heard > std::max(p.silence_s, 5.0 * board.interval)) {
        begin(board, BoardState::kSilent, heard);
      }
    }
  }
}

nlohmann::json SensorWatch::save() const {
  const auto outages = [](const std::vector<Outage>& list) {
    nlohmann::json json = nlohmann::json::array();
    for (const Outage& outage : list) {
      json.push_back({static_cast<int>(outage.kind), outage.begin, outage.end});
    }
    return json;
  };
  nlohmann::json boards = nlohmann::json::array();
  for (const Board& b : boards_) {
    // What is not a number becomes null.
    boards.push_back({{"state", static_cast<int>(b.state)},
                      {"times", {b.since, b.last, b.interval, b.same_since}},
                      {"heard", b.heard},
                      {"has_frozen", b.has_frozen},
                      {"words", b.words},
                      {"same", b.same},
                      {"reading", {b.w.x(), b.w.y(), b.w.z(), b.f.x(), b.f.y(), b.f.z()}},
                      {"outages", outages(b.outages)}});
  }
  return {{"boards", boards},
          {"blackouts", outages(blackouts_)},
          {"first_s", first_},
          {"last_s", last_},
          {"started", started_}};
}

void SensorWatch::load(const JsonReader& saved) {
  const auto read = [](const JsonReader& list, std::vector<Outage>& outages) {
    outages.clear();
    for (const JsonReader& item : list.items()) {
      const std::vector<double> v = item.numbers(3);
      outages.push_back({v[0] == 2.0 ? BoardState::kFrozen : BoardState::kSilent, v[1], v[2]});
    }
  };
  const std::vector<JsonReader> boards = saved.at("boards").items();
  if (boards.size() != boards_.size()) {
    saved.fail("is of another rig");
    return;
  }
  constexpr int kMany = 1 << 30;
  for (std::size_t i = 0; i < boards.size(); ++i) {
    const JsonReader& from = boards[i];
    Board& b = boards_[i];
    b.state = static_cast<BoardState>(from.at("state").integer(0, 2));
    const std::vector<double> times = from.at("times").numbers(4);
    b.since = times[0];
    b.last = times[1];
    b.interval = times[2];
    b.same_since = times[3];
    b.heard = from.at("heard").boolean();
    b.has_frozen = from.at("has_frozen").boolean();
    b.words = static_cast<int>(from.at("words").integer(0, kMany));
    b.same = static_cast<int>(from.at("same").integer(0, kMany));
    const std::vector<JsonReader> reading = from.at("reading").items();
    for (std::size_t k = 0; k < 6 && k < reading.size(); ++k) {
      const double value = reading[k].raw().is_null() ? kMissing : reading[k].number();
      (k < 3 ? b.w : b.f)[static_cast<Eigen::Index>(k % 3)] = value;
    }
    read(from.at("outages"), b.outages);
  }
  read(saved.at("blackouts"), blackouts_);
  first_ = saved.at("first_s").number();
  last_ = saved.at("last_s").number();
  started_ = saved.at("started").boolean();
}

Diagnostics SensorWatch::findings(double end_s) const {
  Diagnostics found;
  for (const Outage& outage : blackouts_) {
    found.push_back({Severity::kWarning, "body.blackout",
                     "no sensor was heard for " + seconds(outage.end - outage.begin) + " from " +
                         seconds(outage.begin) + " on: the pose was held there",
                     "check the box, its cable and its battery", "", outage.begin});
  }
  for (std::size_t b = 0; b < boards_.size(); ++b) {
    const Board& board = boards_[b];
    const std::string name = "\"" + model_.boards[b].name + "\"";
    if (!board.heard && board.state == BoardState::kSilent) {
      found.push_back({Severity::kWarning, "body.board-dead", name + " was never heard: the filter did without it",
                       "check its wire and its plug", model_.boards[b].name, first_});
      continue;
    }
    int brief = 0;
    for (const Outage& outage : board.outages) {
      const bool over = outage.end >= outage.begin;
      const double length = (over ? outage.end : end_s) - outage.begin;
      if (length < parameters_.told_s) {
        ++brief;
        continue;
      }
      const std::string from =
          outage.begin <= first_ + 1e-9 ? "from the start" : "from " + seconds(outage.begin) + " on";
      const std::string until = over ? " until " + seconds(outage.end) : "";
      if (outage.kind == BoardState::kSilent) {
        found.push_back({Severity::kWarning, over ? "body.board-silent" : "body.board-died",
                         fmt::format("{} was silent {}{}: the filter did without it", name, from, until),
                         "check its wire and its plug", model_.boards[b].name, outage.begin});
      } else {
        found.push_back({Severity::kWarning, "body.board-frozen",
                         fmt::format("{} gave the same reading {}{}: the filter did without it", name, from, until),
                         "its chip hangs or is broken: switch it off and on, or replace it", model_.boards[b].name,
                         outage.begin});
      }
    }
    if (brief > 3) {
      found.push_back({Severity::kInfo, "body.board-drops",
                       name + " was not heard " + std::to_string(brief) + " times for a moment", "check its plug",
                       model_.boards[b].name, board.outages.front().begin});
    }
  }
  return found;
}

}  // namespace limbwave::estimate
