#include "decode/source_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/so3.h"

namespace limbwave::decode {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kLevel = 2.0;    // seconds in which gravity corrects a segment's inclination
constexpr double kReturn = 20.0;  // seconds in which a heading that nothing tells goes back to rest

}  // namespace

SourceMotion::SourceMotion(const RangingFormat& format, BoxGeometry geometry)
    : sources_(format.sources), geometry_(std::move(geometry)) {
  if (geometry_.reference >= 0) {
    boards_.resize(geometry_.R_CS_rest.size());
  }
}

// Orientation of one board in C: rates of turn, inclination from the gravity that both feel on average.
void SourceMotion::turn(std::size_t wire, const SourceStep& step, const FeltMotion& felt) {
  Board& board = boards_[wire];
  board.turning = 0.0;
  if (!step.known || !felt.known) {
    return;
  }
  const Quaterniond& R = geometry_.R_CS_rest[wire];
  const Vector3d w = R * felt.w_S;
  const Vector3d f = R * felt.f_S;
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
  const Vector3d heading = -up * up.dot(geometry::log_so3(board.turned)) * (step.dt / kReturn);
  board.turned = (geometry::exp_so3(share * level + heading) * board.turned).normalized();
  board.f_mean += (share * level).cross(board.f_mean);
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
      Board& board = boards_[w];
      boards[w].placed = step.known && board.started && board.placed;
      const Vector3d place = reached(geometry_.boards[w], geometry_.board_places[w]) - geometry_.reference_place;
      boards[w].R_CS = board.turned * geometry_.R_CS_rest[w];
      boards[w].place = place;
      boards[w].velocity = (place - board.place) / step.dt + step.w_C.cross(place);
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
