#include "estimate/body_watch.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>
#include <tuple>

#include "base/json_reader.h"
#include "estimate/body_smoother.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

constexpr double kIdleLook = 0.1;    // seconds
constexpr double kStrayPose = 0.5;   // rad: what a joint may have turned at most while nothing was heard, 1 σ
constexpr double kStraySpeed = 1.0;  // m/s of the root meanwhile
constexpr double kJustBefore = 1e-4;

double square(double x) {
  return x * x;
}

// Ranks of what is worn, by segment and name.
template <typename Worn>
std::vector<int> ranks(const std::vector<Worn>& worn) {
  std::vector<std::size_t> order(worn.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(worn[a].segment, worn[a].name) < std::tie(worn[b].segment, worn[b].name);
  });
  std::vector<int> rank(worn.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    rank[order[i]] = static_cast<int>(i);
  }
  return rank;
}

}  // namespace

BodyWatch::BodyWatch(const BodyModel& model, const BodyWatchParameters& parameters)
    : parameters_(parameters),
      model_(model),
      sensors_(model_, parameters.sensors),
      contacts_(model_, parameters.contacts),
      turned_(model_.boards.size(), 0) {
  board_rank_ = ranks(model_.boards);
  source_rank_ = ranks(model_.sources);
  usable_.push_back({0, std::vector<char>(model_.boards.size(), 1)});
  idles_ = any_idle(usable_.back().boards);
}

bool BodyWatch::any_idle(const std::vector<char>& usable) const {
  const std::vector<char> idle = idle_segments(usable);
  return std::find(idle.begin(), idle.end(), 1) != idle.end();
}

Result<Diagnostics> BodyWatch::start(BodyFilter& filter, const BodyReadings& readings) {
  looks_at_feet_ = parameters_.stillness && filter.parameters().root == RootMode::kFree;
  if (mind_) {
    if (Status status = resume_from(*mind_, filter); !status) {
      return status.error();
    }
    filter.resume(mind_->filter);
    const double* above = mind_->above.data();
    for (int i = 0; i < mind_->states; ++i) {
      for (int k = i + 1; k < mind_->states; ++k) {
        filter.mutable_covariance().row(i)[k] = *above++;
      }
    }
    return Diagnostics{};
  }
  const bool given = filter.parameters().root == RootMode::kGiven && !readings.root.empty();
  if (model_.boards.size() < 2 && parameters_.rest.mode != StartMode::kRest) {
    return start_from_rest(filter, readings);
  }
  RootReading root;
  if (given) {
    root = root_at(readings.root, std::min(readings.inertial.empty() ? INFINITY : readings.inertial.front().time_s,
                                           readings.ranges.empty() ? INFINITY : readings.ranges.front().time_s));
  }
  Result<RestStart> started = start_at_rest(filter, readings, parameters_.rest, given ? &root : nullptr);
  if (!started) {
    return started.error();
  }
  for (std::size_t b = 0; b < turned_.size(); ++b) {
    turned_[b] = started->boards[b].turned ? 1 : 0;
  }
  usable_ = {{0, usable_boards()}};
  idles_ = any_idle(usable_.back().boards);
  if (near_) {
    begin_near(filter, given);
  }
  return std::move(started->diagnostics);
}

// The pose and motion that were found, with what is left of their doubt; constants are not learnt twice from the same
// readings. Where the root is stays the start's to say.
void BodyWatch::begin_near(BodyFilter& filter, bool root_given) const {
  BodyState state = filter.state();
  state.joints = near_->joints;
  const bool free = filter.tree().root_motion() == body::RootMotion::kFree;
  if (free && !root_given) {
    state.joints.q.head<3>() = filter.state().joints.q.head<3>();
  }
  filter.set_state(state);
  const int n = filter.layout().dofs;
  const RestParameters& rest = parameters_.rest;
  for (int i = 0; i < n; ++i) {
    const bool of_root = free && i < 6;
    if (!of_root) {
      filter.mutable_covariance().set_variance(i, square(rest.found_pose));
    }
    if (!of_root || !root_given) {
      filter.mutable_covariance().set_variance(n + i, square(rest.found_rate));
      filter.mutable_covariance().set_variance(2 * n + i, square(rest.found_acceleration));
    }
  }
}

std::vector<char> BodyWatch::usable_boards() const {
  std::vector<char> boards(model_.boards.size());
  for (std::size_t b = 0; b < boards.size(); ++b) {
    boards[b] = sensors_.board(b) == BoardState::kWell && turned_[b] == 0 ? 1 : 0;
  }
  return boards;
}

const std::vector<char>& BodyWatch::usable_at(std::size_t number) const {
  const auto behind = std::upper_bound(usable_.begin(), usable_.end(), number,
                                       [](std::size_t k, const Usable& usable) { return k < usable.from; });
  return std::prev(behind)->boards;
}

void BodyWatch::look(const BodyInstant& instant, std::size_t number) {
  seen_ = number + 1;
  now_ = instant.time_s;
  sensors_.push(instant);
  if (sensors_.blackout() > 0.0) {
    gaps_.push_back({number, sensors_.blackout()});
  }
  const std::vector<char> boards = usable_boards();
  if (boards != usable_.back().boards) {
    usable_.push_back({number, boards});
    idles_ = any_idle(boards);
    next_idle_look_ = now_;  // at once: what has just fallen silent flies on
  }
  if (idles_ && now_ >= next_idle_look_) {
    idle_looks_.push_back(number);
    next_idle_look_ = now_ + kIdleLook;
  }
  contacts_.push(instant, boards);
}

BodyInstant BodyWatch::before(BodyFilter& filter, const BodyInstant& instant, std::size_t number, StepRecord* record) {
  if (number >= seen_) {
    look(instant, number);
  }
  const auto gap =
      std::lower_bound(gaps_.begin(), gaps_.end(), number, [](const Gap& g, std::size_t k) { return g.number < k; });
  const bool bridges = gap != gaps_.end() && gap->number == number;
  if (record != nullptr) {
    record->forgets = bridges;
  }
  if (bridges) {
    bridge(filter, instant.time_s, gap->seconds);
  }
  const std::vector<char>& usable = usable_at(number);
  const auto lost = [&](const InertialReading& reading) {
    return usable[static_cast<std::size_t>(reading.board)] == 0;
  };
  const auto board_before = [&](const InertialReading& a, const InertialReading& b) {
    return board_rank_[static_cast<std::size_t>(a.board)] < board_rank_[static_cast<std::size_t>(b.board)];
  };
  const auto range_before = [&](const RangeReading& a, const RangeReading& b) {
    const int first = source_rank_[static_cast<std::size_t>(a.source)];
    const int second = source_rank_[static_cast<std::size_t>(b.source)];
    return first != second
               ? first < second
               : board_rank_[static_cast<std::size_t>(a.board)] < board_rank_[static_cast<std::size_t>(b.board)];
  };
  // Readings of one instant in an order of their own, so that the order of a rig or of a file's lines does not count:
  // how far one is believed depends on those before it.
  BodyInstant used = instant;
  const InertialReading* words_end = instant.inertial + instant.inertials;
  if (std::any_of(instant.inertial, words_end, lost) || !std::is_sorted(instant.inertial, words_end, board_before)) {
    kept_.clear();
    std::remove_copy_if(instant.inertial, words_end, std::back_inserter(kept_), lost);
    std::stable_sort(kept_.begin(), kept_.end(), board_before);
    used.inertial = kept_.data();
    used.inertials = kept_.size();
  }
  if (!std::is_sorted(instant.ranges, instant.ranges + instant.range_count, range_before)) {
    kept_ranges_.assign(instant.ranges, instant.ranges + instant.range_count);
    std::stable_sort(kept_ranges_.begin(), kept_ranges_.end(), range_before);
    used.ranges = kept_ranges_.data();
  }
  return used;
}

// Nobody knows what happened meanwhile: the pose is held, with what it may have become as its uncertainty; velocities
// and accelerations start anew. What was learnt of sensors and bones stays.
void BodyWatch::bridge(BodyFilter& filter, double time_s, double seconds) const {
  BodyState state = filter.state();
  const int n = filter.layout().dofs;
  state.joints.qd.setZero();
  state.joints.qdd.setZero();
  state.time_s = time_s - kJustBefore;
  filter.set_state(state);
  ErrorCovariance& P = filter.mutable_covariance();
  const bool free = filter.tree().root_motion() == body::RootMotion::kFree;
  for (int i = 0; i < n; ++i) {
    const bool translation = free && i < 3;
    P.add_variance(
        i, translation ? square(kStraySpeed * seconds) : square(kStrayPose * std::min(1.0, std::sqrt(seconds))));
    P.set_variance(n + i, square(parameters_.rest.moving_rate));
    P.set_variance(2 * n + i, square(parameters_.rest.moving_acceleration));
  }
}

// Segments whose joints no usable board tells of: those at and above a board that is not, up to the next that is; and
// those with none at or beyond them.
std::vector<char> BodyWatch::idle_segments(const std::vector<char>& usable) const {
  const std::vector<body::Segment>& segments = model_.skeleton.segments;
  std::vector<char> heard(segments.size(), 0);
  std::vector<char> told(segments.size(), 0);
  for (std::size_t b = 0; b < model_.boards.size(); ++b) {
    const BodyBoard& board = model_.boards[b];
    if (usable[b] != 0) {
      const auto s = static_cast<std::size_t>(board.segment);
      heard[s] = heard[s] != 0 || board.gyroscope || board.accelerometer ? 1 : 0;
      told[s] = 1;
    }
  }
  for (std::size_t s = segments.size(); s-- > 1;) {
    const auto parent = static_cast<std::size_t>(segments[s].parent);
    told[parent] = told[parent] != 0 || told[s] != 0 ? 1 : 0;
  }
  std::vector<char> idle(segments.size(), 0);
  for (std::size_t b = 0; b < model_.boards.size(); ++b) {
    for (int s = model_.boards[b].segment; usable[b] == 0 && s >= 0 && heard[static_cast<std::size_t>(s)] == 0;
         s = segments[static_cast<std::size_t>(s)].parent) {
      idle[static_cast<std::size_t>(s)] = 1;
    }
  }
  for (std::size_t s = 0; s < segments.size(); ++s) {
    idle[s] = idle[s] != 0 || told[s] == 0 ? 1 : 0;
  }
  return idle;
}

// Without its board a joint is known by its neighbours only, and mostly not at all. White jerk alone would let it fly
// off; people do not.
void BodyWatch::rest_idle_joints(BodyFilter& filter, const std::vector<char>& usable, StepRecord* record) const {
  const body::Tree& tree = filter.tree();
  const int n = tree.dofs();
  const std::vector<char> idle = idle_segments(usable);
  std::vector<MeasurementGroup> groups;
  const auto hold = [&](int index, double value, double sigma) {
    MeasurementGroup& g = groups.emplace_back();
    g.rows = 1;
    g.support = {index};
    g.H = {1.0};
    g.innovation[0] = -value;
    g.variance[0] = sigma * sigma;
  };
  const body::TreeState& joints = filter.state().joints;
  for (std::size_t l = 0; l < tree.links().size(); ++l) {
    const body::TreeLink& link = tree.links()[l];
    const bool root = link.segment == 0 && tree.root_motion() == body::RootMotion::kFree;
    if (root || idle[static_cast<std::size_t>(link.segment)] == 0) {
      continue;
    }
    const Vector3d phi = link.kind == body::LinkKind::kBall ? geometry::log_so3(joints.R_joint[l]) : Vector3d::Zero();
    for (int i = 0; i < link.count; ++i) {
      const int dof = link.first + i;
      hold(dof, link.kind == body::LinkKind::kBall ? phi[i] : joints.q[dof], parameters_.idle_pose);
      hold(n + dof, joints.qd[dof], parameters_.idle_rate);
      hold(2 * n + dof, joints.qdd[dof], parameters_.idle_acceleration);
    }
  }
  if (!groups.empty()) {
    filter.update(groups, record != nullptr ? &record->updates : nullptr);
  }
}

void BodyWatch::after(BodyFilter& filter, const BodyInstant& /*instant*/, std::size_t number, StepRecord* record) {
  if (std::binary_search(idle_looks_.begin(), idle_looks_.end(), number)) {
    rest_idle_joints(filter, usable_at(number), record);
  }
  if (looks_at_feet_) {
    contacts_.update(filter, number, record != nullptr ? &record->updates : nullptr);
  }
}

void BodyWatch::finished(const BodyFilter& filter) {
  last_mind_ = mind(filter);
}

Diagnostics BodyWatch::findings() const {
  Diagnostics found = sensors_.findings(now_);
  if (!looks_at_feet_) {
    return found;
  }
  const Diagnostics feet = contacts_.findings();
  found.insert(found.end(), feet.begin(), feet.end());
  return found;
}

BodyMind BodyWatch::mind(const BodyFilter& filter) const {
  const nlohmann::json watch{{"sensors", sensors_.save()},
                             {"contacts", contacts_.save()},
                             {"next_idle_look_s", next_idle_look_},
                             {"turned", std::vector<int>(turned_.begin(), turned_.end())},
                             {"now_s", now_}};
  const int states = filter.layout().size;
  std::vector<double> above;
  for (int i = 0; i < states; ++i) {
    above.insert(above.end(), filter.covariance().row(i) + i + 1, filter.covariance().row(i) + states);
  }
  return {filter.snapshot(), std::move(above), watch.dump(), states, static_cast<int>(model_.boards.size())};
}

Status BodyWatch::resume_from(const BodyMind& mind, const BodyFilter& filter) {
  const BodyState& state = mind.filter.state;
  const auto dofs = filter.layout().dofs;
  if (mind.states != filter.layout().size || state.joints.qd.size() != dofs ||
      state.joints.R_joint.size() != filter.tree().links().size() ||
      state.gyroscope_bias.size() != model_.boards.size() || state.source_place.size() != model_.sources.size() ||
      state.bone_scale.size() != model_.skeleton.segments.size()) {
    return Error{"the saved state is of another rig, skeleton or choice of sensors", "",
                 "resume with what it was saved with"};
  }
  Result<nlohmann::json> json = parse_json(mind.watch_text, "saved state");
  if (!json) {
    return json.error();
  }
  JsonReader::State problems{"saved state", {}};
  const JsonReader reader(*json, "watch", problems);
  sensors_.load(reader.at("sensors"));
  contacts_.load(reader.at("contacts"));
  next_idle_look_ = reader.at("next_idle_look_s").number();
  now_ = reader.at("now_s").number();
  const std::vector<double> turned = reader.at("turned").numbers(turned_.size());
  for (std::size_t b = 0; b < turned.size(); ++b) {
    turned_[b] = turned[b] != 0.0 ? 1 : 0;
  }
  if (problems.error) {
    return *problems.error;
  }
  usable_ = {{0, usable_boards()}};
  idles_ = any_idle(usable_.back().boards);
  return {};
}

}  // namespace limbwave::estimate
