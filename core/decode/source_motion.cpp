#include "decode/source_motion.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "geometry/so3.h"

namespace limbwave::decode {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kLevel = 2.0;           // seconds in which gravity corrects a segment's inclination
constexpr double kReturn = 20.0;         // seconds in which a heading that nothing tells goes back to rest
constexpr double kHeadingMemory = 20.0;  // seconds, of what forces at joints tell about headings
constexpr double kForceNoise = 0.8;  // m/s² √s: of forces at a joint as two boards tell them, with skin and levers
constexpr double kHeadingUnknown = 0.8;  // radians, where joints have told nothing
constexpr double kHeadingSd = 0.05;      // radians, at best
constexpr double kPlaceSd = 0.015;       // metres, of a board whose ways are well known

}  // namespace

SourceMotion::SourceMotion(const RangingFormat& format, BoxGeometry geometry)
    : sources_(format.sources), geometry_(std::move(geometry)) {
  if (geometry_.reference >= 0) {
    boards_.resize(geometry_.R_CS_rest.size());
    joints_.resize(boards_.size());
    for (std::size_t w = 0; w < boards_.size() && w < geometry_.boards.size(); ++w) {
      const std::vector<BoxGeometry::Link>& way = geometry_.boards[w];
      const auto own = std::find_if(way.begin(), way.end(),
                                    [&](const BoxGeometry::Link& link) { return link.wire == static_cast<int>(w); });
      if (own != way.end()) {
        joints_[w] = {own == way.begin() ? geometry_.reference : std::prev(own)->wire, own->from, true};
        joints_[w].known = joints_[w].before >= 0;
      }
    }
  }
}

// Orientation of one board in C: rates of turn, inclination from the gravity that both feel on average.
void SourceMotion::turn(std::size_t wire, const SourceStep& step, const FeltMotion& felt) {
  Board& board = boards_[wire];
  board.turning = 0.0;
  if (!step.known || !felt.known) {
    board.felt = board.felt_before = false;
    return;
  }
  const Quaterniond& R = geometry_.R_CS_rest[wire];
  const Vector3d w = R * felt.w_S;
  const Vector3d f = R * felt.f_S;
  board.w_dot = (w - board.w) / step.dt;
  board.w = w;
  board.f = f;
  board.felt_before = board.felt;
  board.felt = !felt.saturated;
  if (!board.started) {
    board.turned = geometry::shortest_arc(f, step.f_C);
    board.f_mean = board.f_mean_C = step.f_C;
    board.started = true;
    return;
  }
  const Quaterniond back = geometry::exp_so3(-step.dt * step.w_C);
  board.turned = (back * board.turned * geometry::exp_so3(step.dt * w)).normalized();
  board.turning = (board.turned * w - step.w_C).norm();
  const double share = std::min(1.0, step.dt / kLevel);
  board.f_mean = back * board.f_mean + share * (board.turned * f - board.f_mean);
  board.f_mean_C = back * board.f_mean_C + share * (step.f_C - board.f_mean_C);
  const Vector3d up = board.f_mean_C.normalized();
  const Vector3d level = board.f_mean.normalized().cross(up);
  const double untold = 1.0 / (1.0 + board.information);
  const Vector3d heading = -up * up.dot(geometry::log_so3(board.turned)) * (untold * step.dt / kReturn);
  board.turned = (geometry::exp_so3(share * level + heading) * board.turned).normalized();
  board.f_mean += (share * level).cross(board.f_mean);
}

// Both boards beside a joint feel what the joint does; gravity says nothing about headings, but every level force does.
void SourceMotion::head(std::size_t wire, const SourceStep& step) {
  const Joint& joint = joints_[wire];
  Board& board = boards_[wire];
  if (!joint.known || !board.started) {
    return;
  }
  const Board& before = boards_[static_cast<std::size_t>(joint.before)];
  const double keep = std::exp(-step.dt / kHeadingMemory);
  board.cross *= keep;
  board.dot *= keep;
  board.information *= keep;
  if (!before.started || !board.felt_before || !before.felt_before || !board.felt || !before.felt) {
    return;
  }
  const auto at_joint = [&](const Board& b, const Vector3d& from) {
    const Vector3d r = joint.place - from;
    return Vector3d(b.turned * (b.f + b.w_dot.cross(r) + b.w.cross(b.w.cross(r))));
  };
  const Vector3d up = board.f_mean_C.normalized();
  const auto level = [&](const Vector3d& v) { return Vector3d(v - up.dot(v) * up); };
  const Vector3d own = level(at_joint(board, geometry_.board_places[wire]));
  const Vector3d other = level(at_joint(before, geometry_.board_places[static_cast<std::size_t>(joint.before)]));
  board.cross += step.dt * up.dot(own.cross(other));
  board.dot += step.dt * own.dot(other);
  board.information += step.dt * own.norm() * other.norm() / (kForceNoise * kForceNoise);
  const double off = std::atan2(board.cross, board.dot);
  const double sure = board.information / (board.information + 1.0);
  const double turn = std::min(1.0, step.dt / 0.5) * sure * off;
  board.turned = (geometry::exp_so3(turn * up) * board.turned).normalized();
  board.f_mean = geometry::exp_so3(turn * up) * board.f_mean;
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  const double cross = c * board.cross - s * board.dot;
  board.dot = c * board.dot + s * board.cross;
  board.cross = cross;
}

// Every piece of the way is off by its length times what is not known of its board's heading.
double SourceMotion::place_sd(std::size_t wire) const {
  const std::vector<BoxGeometry::Link>& way = geometry_.boards[wire];
  double variance = kPlaceSd * kPlaceSd;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vector3d piece = (i + 1 < way.size() ? way[i + 1].from : geometry_.board_places[wire]) - way[i].from;
    const double known = way[i].wire >= 0 ? boards_[static_cast<std::size_t>(way[i].wire)].information : 0.0;
    const double sd = kHeadingSd + kHeadingUnknown / (1.0 + known);
    variance += piece.squaredNorm() * sd * sd;
  }
  return std::sqrt(variance);
}

const SourceMotion::Board* SourceMotion::carrier(const std::vector<BoxGeometry::Link>& way) const {
  return way.empty() || way.back().wire < 0 ? nullptr : &boards_[static_cast<std::size_t>(way.back().wire)];
}

Vector3d SourceMotion::reached(const std::vector<BoxGeometry::Link>& way, const Vector3d& end) const {
  if (way.empty()) {
    return end;
  }
  Vector3d place = way.front().from;
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vector3d piece = (i + 1 < way.size() ? way[i + 1].from : end) - way[i].from;
    place += way[i].wire >= 0 ? boards_[static_cast<std::size_t>(way[i].wire)].turned * piece : piece;
  }
  return place;
}

void SourceMotion::step(int source, double time_s, const std::vector<InertialTrace>& traces) {
  steps_.emplace_back();
  SourceStep& step = steps_.back().source;
  std::vector<BoardStep>& boards = steps_.back().boards;
  step.time_s = time_s;
  const bool again = last_s_ >= 0.0;
  step.dt = again ? time_s - last_s_ : 0.0;
  boards.resize(std::max(boards_.size(), traces.size()));
  if (!boards_.empty() && again) {
    const auto wire = static_cast<std::size_t>(geometry_.reference);
    const FeltMotion felt = traces[wire].over(last_s_, time_s);
    step.known = felt.known;
    step.w_C = geometry_.R_CS_rest[wire] * felt.w_S;
    step.f_C = geometry_.R_CS_rest[wire] * felt.f_S;
    for (std::size_t w = 0; w < boards_.size(); ++w) {
      boards[w].felt = traces[w].over(last_s_, time_s);
      turn(w, step, boards[w].felt);
    }
    for (std::size_t w = 0; w < boards_.size(); ++w) {
      head(w, step);
    }
    for (std::size_t w = 0; w < boards_.size(); ++w) {
      Board& board = boards_[w];
      boards[w].placed = step.known && board.started && board.placed;
      const Vector3d place = reached(geometry_.boards[w], geometry_.board_places[w]) - geometry_.reference_place;
      boards[w].R_CS = board.turned * geometry_.R_CS_rest[w];
      boards[w].place = place;
      boards[w].velocity = (place - board.place) / step.dt + step.w_C.cross(place);
      boards[w].place_sd = place_sd(w);
      board.place = place;
      board.placed = board.started;
    }
  }
  last_s_ = time_s;
  const auto s = static_cast<std::size_t>(source);
  step.place = sources_[s].position;
  step.normal = sources_[s].normal;
  if (!boards_.empty() && s < geometry_.sources.size()) {
    step.place = reached(geometry_.sources[s], sources_[s].position);
    if (const Board* board = carrier(geometry_.sources[s])) {
      step.normal = board->turned * sources_[s].normal;
    }
    for (std::size_t i = 0; i < std::min(SourceStep::kSources, geometry_.sources.size()); ++i) {
      const Board* board = carrier(geometry_.sources[i]);
      step.turning[i] = board != nullptr ? board->turning : 0.0;
    }
  }
  step.place -= geometry_.reference_place;
}

void SourceMotion::forget(std::int64_t before) {
  while (first_ < before && !steps_.empty()) {
    steps_.pop_front();
    ++first_;
  }
}

}  // namespace limbwave::decode
