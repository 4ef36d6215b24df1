#include "estimate/foot_contacts.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"
#include "base/units.h"
#include "estimate/rest_start.h"

namespace limbwave::estimate {
namespace {

using body::TreeKinematics;

constexpr double kRemembered = 3.0;  // s of places, for a fixed lag

double square(double x) {
  return x * x;
}

}  // namespace

FootContacts::FootContacts(const BodyModel& model, const ContactParameters& parameters)
    : parameters_(parameters),
      soles_(parameters.feet ? find_soles(model) : std::vector<Sole>{}),
      root_(soles_.size(), parameters.root),
      words_(model.boards.size()),
      usable_(model.boards.size(), 1) {}

void FootContacts::push(const BodyInstant& instant, const std::vector<char>& usable) {
  now_ = instant.time_s;
  usable_ = usable;
  for (std::size_t i = 0; i < instant.inertials; ++i) {
    const InertialReading& reading = instant.inertial[i];
    std::deque<Word>& words = words_[static_cast<std::size_t>(reading.board)];
    words.push_back({reading.time_s, reading.w_S, reading.f_S});
    while (words.size() > 1 && words.front().time_s < now_ - parameters_.still_s) {
      words.pop_front();
    }
  }
}

bool FootContacts::all_still() const {
  int boards = 0;
  for (std::size_t b = 0; b < words_.size(); ++b) {
    if (usable_[b] == 0 || words_[b].empty()) {
      continue;
    }
    ++boards;
    for (const Word& word : words_[b]) {
      if ((word.w.allFinite() && word.w.squaredNorm() > square(parameters_.still_rate)) ||
          (word.f.allFinite() && std::abs(word.f.norm() - kStandardGravity) > parameters_.still_force)) {
        return false;
      }
    }
  }
  return boards > 0;
}

// Whether the body was found to be still at a time that has been looked at.
bool FootContacts::still_at(double time_s) const {
  const auto behind = std::upper_bound(still_times_.begin(), still_times_.end(), time_s);
  return behind != still_times_.begin() && time_s - *std::prev(behind) < 1.5 * parameters_.period_s;
}

void FootContacts::rest(BodyFilter& filter, std::vector<UpdateRecord>* records) const {
  const int n = filter.layout().dofs;
  std::vector<MeasurementGroup> groups(1);
  MeasurementGroup& g = groups[0];
  g.rows = 3;
  for (int i = 0; i < 3; ++i) {
    g.support.push_back(n + i);
    for (int r = 0; r < 3; ++r) {
      g.H.push_back(r == i ? 1.0 : 0.0);
    }
    g.innovation[i] = -filter.state().joints.qd[i];
    g.variance[i] = square(parameters_.still_velocity_noise);
  }
  filter.update(groups, records);
}

FootLook FootContacts::look_at(const BodyFilter& filter, const BodyState& state, const double* covariance,
                               long stride) const {
  const body::Tree& tree = filter.tree();
  TreeKinematics kinematics(tree);
  kinematics.update(state.joints, bone_scales(tree, state));
  const body::LinkMotion& root = kinematics.link(tree.link_of(0));
  FootLook look;
  look.time_s = state.time_s;
  look.root_p = root.p;
  look.root_a = state.joints.qdd.head<3>();
  for (const Sole& sole : soles_) {
    const int link = tree.link_of(sole.segment);
    // How a foot without a board is inclined nobody knows: its middle stands.
    const bool told = sole.board >= 0;
    const auto heel = kinematics.point(link, told ? sole.heel_L : sole.p_L);
    const auto toe = kinematics.point(link, told ? sole.toe_L : sole.p_L);
    look.soles.push_back({heel.p - root.p, toe.p - root.p, heel.v - root.v, toe.v - root.v});
  }
  // How far the root may have turned about the vertical; its rotation is the fourth to sixth state, in its own frame.
  const Vector3d up = root.R_WL.transpose() * Vector3d::UnitZ();
  double variance = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      variance += up[i] * up[k] * covariance[(3 + i) * stride + 3 + k];
    }
  }
  look.heading = std::sqrt(std::max(0.0, variance));
  look.still = still_at(state.time_s);
  return look;
}

void FootContacts::look(const BodyFilter& filter) {
  if (!root_.started()) {
    const int n = filter.layout().dofs;
    const ErrorCovariance& P = filter.covariance();
    start_speed_ = std::sqrt((P(n, n) + P(n + 1, n + 1)) / 2.0);
    root_.start(start_speed_);
  }
  const FootLook look = look_at(filter, filter.state(), filter.covariance().row(0), filter.covariance().stride());
  const bool usable = std::all_of(look.soles.begin(), look.soles.end(), [](const FootLook::Sole& sole) {
    return sole.heel.allFinite() && sole.heel_v.allFinite() && sole.toe_v.allFinite();
  });
  if (!usable || !look.root_a.allFinite()) {
    return;
  }
  places_.emplace_back(look.time_s, root_.push(look));
  while (places_.front().first < look.time_s - kRemembered) {
    places_.pop_front();
  }
}

RootPlace FootContacts::place(double time_s) const {
  if (places_.empty() || time_s >= places_.back().first) {
    return root_.place(time_s);
  }
  const auto behind = std::upper_bound(places_.begin(), places_.end(), time_s,
                                       [](double t, const auto& place) { return t < place.first; });
  return behind == places_.begin() ? behind->second : std::prev(behind)->second;
}

std::vector<RootPlace> FootContacts::smooth(std::vector<FootLook> looks) const {
  return FootRoot::smooth(std::move(looks), parameters_.root, start_speed_);
}

void FootContacts::update(BodyFilter& filter, std::size_t number, std::vector<UpdateRecord>* records) {
  if (filter.tree().root_motion() != body::RootMotion::kFree) {
    return;
  }
  if (number < looked_) {
    if (std::binary_search(still_.begin(), still_.end(), number)) {
      rest(filter, records);
    }
    return;
  }
  looked_ = number + 1;
  if (now_ >= next_look_ - 1e-9) {
    next_look_ = std::max(next_look_ + parameters_.period_s, now_ + 0.5 * parameters_.period_s);
    if (!all_still()) {
      still_since_ = -1.0;
    } else if (still_since_ < 0.0) {
      still_since_ = now_;
    }
    if (still_since_ >= 0.0 && now_ - still_since_ >= parameters_.still_s) {
      still_.push_back(number);
      still_times_.push_back(now_);
      rest(filter, records);
    }
  }
  if (hold_root() && now_ >= next_feet_ - 1e-9) {
    next_feet_ = now_ + parameters_.look_s;
    look(filter);
  }
}

nlohmann::json FootContacts::save() const {
  nlohmann::json words = nlohmann::json::array();
  for (const auto& of_board : words_) {
    nlohmann::json list = nlohmann::json::array();
    for (const Word& word : of_board) {
      list.push_back({word.time_s, word.w.x(), word.w.y(), word.w.z(), word.f.x(), word.f.y(), word.f.z()});
    }
    words.push_back(std::move(list));
  }
  return {{"root", root_.save()},          {"words", words},
          {"next_look_s", next_look_},     {"next_feet_s", next_feet_},
          {"still_since_s", still_since_}, {"was_still_s", still_times_.empty() ? -1e300 : still_times_.back()},
          {"start_speed", start_speed_}};
}

void FootContacts::load(const JsonReader& saved) {
  const std::vector<JsonReader> words = saved.at("words").items();
  if (words.size() != words_.size()) {
    saved.fail("is of another skeleton or rig");
    return;
  }
  root_.load(saved.at("root"));
  for (std::size_t b = 0; b < words.size(); ++b) {
    words_[b].clear();
    for (const JsonReader& word : words[b].items()) {
      double v[7] = {};
      const std::vector<JsonReader> values = word.items();
      for (std::size_t k = 0; k < 7 && k < values.size(); ++k) {
        v[k] = values[k].raw().is_null() ? kMissing : values[k].number();
      }
      words_[b].push_back({v[0], {v[1], v[2], v[3]}, {v[4], v[5], v[6]}});
    }
  }
  next_look_ = saved.at("next_look_s").number();
  next_feet_ = saved.at("next_feet_s").number();
  still_since_ = saved.at("still_since_s").number();
  still_times_ = {saved.at("was_still_s").number()};
  start_speed_ = saved.at("start_speed").number();
}

Diagnostics FootContacts::findings() const {
  Diagnostics found;
  if (!parameters_.feet) {
    return found;
  }
  if (soles_.empty()) {
    found.push_back({Severity::kWarning, "body.no-feet", "the skeleton has no feet that could stand: the root is free",
                     "give it segments that reach the ground, or solve with another root", ""});
    return found;
  }
  for (std::size_t i = 0; i < soles_.size(); ++i) {
    if (root_.steps(i) == 0) {
      found.push_back({Severity::kWarning, "body.foot-never-stands",
                       "\"" + soles_[i].name + "\" never stood: its contacts do not hold the root",
                       "check its sensor, or solve with another root", soles_[i].name});
    } else {
      found.push_back({Severity::kInfo, "body.foot-stands",
                       "\"" + soles_[i].name + "\" stood " + std::to_string(root_.steps(i)) + " times, " +
                           std::to_string(static_cast<int>(std::lround(root_.stood_s(i)))) + " s in all",
                       "", soles_[i].name});
    }
  }
  if (root_.looked_s() > 0.0) {
    const int share = static_cast<int>(std::lround(100.0 * root_.carried_s() / root_.looked_s()));
    found.push_back({share < 30 ? Severity::kWarning : Severity::kInfo, "body.root-by-feet",
                     "the root's place is told by its feet for " + std::to_string(share) +
                         " % of the time, and by its own acceleration for the rest",
                     share < 30 ? "feet that glide or float tell little: give the root's path" : "", ""});
  }
  return found;
}

}  // namespace limbwave::estimate
