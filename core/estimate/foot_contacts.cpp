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

constexpr double kMostStep = 0.04;  // m: another height is another ground (a stair, a slope), not an error
constexpr double kGivesWay = 1.0;   // m/s: what a contradicted root's velocity may be off

double square(double x) {
  return x * x;
}

}  // namespace

FootContacts::FootContacts(const BodyModel& model, const ContactParameters& parameters)
    : parameters_(parameters),
      soles_(parameters.feet ? find_soles(model) : std::vector<Sole>{}),
      feet_(soles_.size()),
      words_(model.boards.size()),
      usable_(model.boards.size(), 1) {
  for (int rows = 1; rows <= 3; ++rows) {
    gates_[rows] = chi_square_limit(rows, parameters.gate_probability);
  }
}

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

// Mean of ω² / rate² + |f − f̄|² / force² + (|f̄| − g)² / force² over the window, f̄ its mean; infinite where there is not
// enough. `newest`: of the newest word alone, whose f is compared with the mean of those before it.
double FootContacts::statistic(int board, bool newest) const {
  const std::deque<Word>& words = words_[static_cast<std::size_t>(board)];
  Vector3d mean = Vector3d::Zero();
  double squares = 0.0;
  double turning = 0.0;
  int count = 0;
  int forces = 0;
  for (auto word = words.rbegin() + (newest && !words.empty() ? 1 : 0);
       word != words.rend() && word->time_s >= now_ - parameters_.window_s; ++word) {
    if (!word->w.allFinite()) {
      return INFINITY;
    }
    turning += word->w.squaredNorm();
    ++count;
    if (word->f.allFinite()) {
      mean += word->f;
      squares += word->f.squaredNorm();
      ++forces;
    }
  }
  if (count < 3 || !words.back().w.allFinite()) {
    return INFINITY;
  }
  mean /= std::max(1, forces);
  double force2 = forces > 0 ? square(mean.norm() - kStandardGravity) : 0.0;
  if (newest) {
    turning = words.back().w.squaredNorm();
    force2 = forces > 0 && words.back().f.allFinite() ? (words.back().f - mean).squaredNorm() : 0.0;
    count = 1;
  } else if (forces > 0) {
    force2 += std::max(0.0, squares / forces - mean.squaredNorm());
  }
  return turning / count / square(parameters_.rate) + force2 / square(parameters_.force);
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

FootContacts::Decision FootContacts::decide(const BodyFilter& filter, std::size_t number) {
  const ContactParameters& p = parameters_;
  Decision decision;
  decision.number = number;
  if (!all_still()) {
    still_since_ = -1.0;
  } else if (still_since_ < 0.0) {
    still_since_ = now_;
  }
  decision.still = still_since_ >= 0.0 && now_ - still_since_ >= p.still_s;
  if (soles_.empty()) {
    return decision;
  }
  TreeKinematics kinematics(filter.tree());
  kinematics.update(filter.state().joints, bone_scales(filter.tree(), filter.state()));
  bool anybody = false;
  std::size_t lowest = 0;
  double lowest_height = INFINITY;
  for (std::size_t i = 0; i < soles_.size(); ++i) {
    Foot& foot = feet_[i];
    const auto point = kinematics.point(filter.tree().link_of(soles_[i].segment), soles_[i].p_L);
    const bool own = soles_[i].board >= 0 && usable_[static_cast<std::size_t>(soles_[i].board)] != 0 &&
                     !words_[static_cast<std::size_t>(soles_[i].board)].empty();
    bool stands = foot.standing;
    const double lately = own ? statistic(soles_[i].board, false) : INFINITY;
    if (std::isfinite(lately)) {
      // Slow to believe, quick to doubt: what begins to swing has speed before its window shows it, and what swings
      // slowly shows it in its window alone.
      stands = statistic(soles_[i].board, true) < p.leave && lately < (foot.standing ? p.doubt : 1.0);
    } else {
      const double speed = point.v.norm();
      const bool low = !foot.levelled || std::abs(point.p.z() - foot.ground) < p.low;
      stands = low && speed < (foot.standing ? p.lifted : p.slow);
    }
    if (point.p.z() < lowest_height) {
      lowest_height = point.p.z();
      lowest = i;
    }
    if (stands && !foot.standing) {
      ++foot.steps;
      if (!foot.levelled || std::abs(point.p.z() - foot.ground) > kMostStep) {
        // Another ground: from here on it is this one, as high as it seems now.
        foot.ground = point.p.z();
        foot.levelled = true;
      }
    }
    foot.standing = stands;
    anybody = anybody || stands;
    if (stands) {
      foot.stood_s += p.period_s;
      foot.last_contact = now_;
      decision.uses.push_back({static_cast<int>(i), true, foot.ground});
    }
  }
  // Nobody walks on air: the lower foot stands, and the estimate gives way.
  double last = 0.0;
  for (const Foot& foot : feet_) {
    last = std::max(last, foot.last_contact);
  }
  if (!anybody && last > 0.0 && now_ - last > p.lost_s && soles_[lowest].board < 0) {
    decision.gives_way = true;
    feet_[lowest].standing = true;
    feet_[lowest].last_contact = now_;
    decision.uses.push_back({static_cast<int>(lowest), false, feet_[lowest].ground});
  }
  return decision;
}

FootContacts::SoleMotion FootContacts::motion_of(const BodyFilter& filter, const Sole& sole) const {
  const body::Tree& tree = filter.tree();
  TreeKinematics kinematics(tree);
  kinematics.update(filter.state().joints, bone_scales(tree, filter.state()));
  const int link = tree.link_of(sole.segment);
  SoleMotion motion{kinematics.point(link, sole.p_L), {}, tree.chain_dofs(link)};
  kinematics.jacobians(link, motion.point, TreeKinematics::kVelocity, motion.jacobians);
  return motion;
}

MeasurementGroup FootContacts::velocity_group(const BodyFilter& filter, const Sole& sole) const {
  const SoleMotion motion = motion_of(filter, sole);
  MeasurementGroup g;
  g.rows = 3;
  const auto append = [&](int index, const Vector3d& column) {
    g.support.push_back(index);
    g.H.insert(g.H.end(), {column.x(), column.y(), column.z()});
  };
  for (std::size_t c = 0; c < motion.dofs.size(); ++c) {
    append(motion.dofs[c], motion.jacobians.J_v_theta.col(static_cast<Eigen::Index>(c)));
    append(filter.tree().dofs() + motion.dofs[c], motion.jacobians.J_p_theta.col(static_cast<Eigen::Index>(c)));
  }
  for (int r = 0; r < 3; ++r) {
    g.innovation[r] = -motion.point.v[r];
    g.variance[r] = parameters_.velocity_noise * parameters_.velocity_noise;
  }
  g.gate = gates_[3];
  return g;
}

MeasurementGroup FootContacts::height_group(const BodyFilter& filter, const Sole& sole, double ground) const {
  const SoleMotion motion = motion_of(filter, sole);
  MeasurementGroup g;
  g.rows = 1;
  for (std::size_t c = 0; c < motion.dofs.size(); ++c) {
    g.support.push_back(motion.dofs[c]);
    g.H.push_back(motion.jacobians.J_p_theta(2, static_cast<Eigen::Index>(c)));
  }
  g.innovation[0] = ground - motion.point.p.z();
  g.variance[0] = parameters_.height_noise * parameters_.height_noise;
  g.gate = gates_[1];
  return g;
}

void FootContacts::apply(BodyFilter& filter, const Decision& decision, std::vector<UpdateRecord>* records, bool fresh) {
  const int n = filter.layout().dofs;
  if (filter.tree().root_motion() != body::RootMotion::kFree) {
    return;
  }
  if (decision.gives_way) {
    for (int i = 0; i < 3; ++i) {
      filter.mutable_covariance().add_variance(n + i, kGivesWay * kGivesWay);
    }
  }
  std::vector<MeasurementGroup> groups(1);
  if (decision.still) {
    MeasurementGroup& g = groups[0];
    g.rows = 3;
    for (int i = 0; i < 3; ++i) {
      g.support.push_back(n + i);
      for (int r = 0; r < 3; ++r) {
        g.H.push_back(r == i ? 1.0 : 0.0);
      }
      g.innovation[i] = -filter.state().joints.qd[i];
      g.variance[i] = parameters_.still_velocity_noise * parameters_.still_velocity_noise;
    }
    filter.update(groups, records);
  }
  for (const Use& use : decision.uses) {
    const auto i = static_cast<std::size_t>(use.foot);
    groups[0] = velocity_group(filter, soles_[i]);
    filter.update(groups, records);
    const bool accepted = groups[0].accepted;
    if (fresh) {
      Foot& foot = feet_[i];
      foot.rejected_since = accepted ? -1.0 : (foot.rejected_since < 0.0 ? now_ : foot.rejected_since);
    }
    if (!accepted || !use.height) {
      continue;
    }
    groups[0] = height_group(filter, soles_[i], use.ground);  // linear where the velocity has just been
    filter.update(groups, records);
  }
}

void FootContacts::update(BodyFilter& filter, std::size_t number, std::vector<UpdateRecord>* records) {
  if (number < looked_) {
    const auto at = std::lower_bound(decisions_.begin(), decisions_.end(), number,
                                     [](const Decision& decision, std::size_t k) { return decision.number < k; });
    if (at != decisions_.end() && at->number == number) {
      apply(filter, *at, records, false);
    }
    return;
  }
  looked_ = number + 1;
  if (now_ < next_look_ - 1e-9) {
    return;
  }
  next_look_ = std::max(next_look_ + parameters_.period_s, now_ + 0.5 * parameters_.period_s);
  Decision decision = decide(filter, number);
  // A foot that stands beyond doubt, and an estimate that has been sure of the contrary for too long: it is wrong.
  for (Foot& foot : feet_) {
    if (!foot.standing) {
      foot.rejected_since = -1.0;
    } else if (foot.rejected_since >= 0.0 && now_ - foot.rejected_since > parameters_.patience_s) {
      decision.gives_way = true;
      foot.rejected_since = -1.0;
    }
  }
  if (!decision.still && decision.uses.empty() && !decision.gives_way) {
    return;
  }
  decisions_.push_back(decision);
  apply(filter, decision, records, true);
}

nlohmann::json FootContacts::save() const {
  nlohmann::json feet = nlohmann::json::array();
  for (const Foot& foot : feet_) {
    feet.push_back(
        {foot.standing, foot.levelled, foot.ground, foot.stood_s, foot.rejected_since, foot.last_contact, foot.steps});
  }
  nlohmann::json words = nlohmann::json::array();
  for (const auto& of_board : words_) {
    nlohmann::json list = nlohmann::json::array();
    for (const Word& word : of_board) {
      list.push_back({word.time_s, word.w.x(), word.w.y(), word.w.z(), word.f.x(), word.f.y(), word.f.z()});
    }
    words.push_back(std::move(list));
  }
  return {{"feet", feet}, {"words", words}, {"next_look_s", next_look_}, {"still_since_s", still_since_}};
}

void FootContacts::load(const JsonReader& saved) {
  const std::vector<JsonReader> feet = saved.at("feet").items();
  const std::vector<JsonReader> words = saved.at("words").items();
  if (feet.size() != feet_.size() || words.size() != words_.size()) {
    saved.fail("is of another skeleton or rig");
    return;
  }
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const std::vector<JsonReader> v = feet[i].items();
    if (v.size() != 7) {
      feet[i].fail("has not seven entries");
      return;
    }
    feet_[i] = {v[0].boolean(),
                v[1].boolean(),
                v[2].number(),
                v[3].number(),
                v[4].number(),
                v[5].number(),
                static_cast<int>(v[6].number())};
  }
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
  still_since_ = saved.at("still_since_s").number();
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
    if (feet_[i].steps == 0) {
      found.push_back({Severity::kWarning, "body.foot-never-stands",
                       "\"" + soles_[i].name + "\" never stood: its contacts do not hold the root",
                       "check its sensor, or solve with another root", soles_[i].name});
    } else {
      found.push_back({Severity::kInfo, "body.foot-stands",
                       "\"" + soles_[i].name + "\" stood " + std::to_string(feet_[i].steps) + " times, " +
                           std::to_string(static_cast<int>(std::lround(feet_[i].stood_s))) + " s in all",
                       "", soles_[i].name});
    }
  }
  return found;
}

}  // namespace limbwave::estimate
