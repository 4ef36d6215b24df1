#include "estimate/foot_root.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"

namespace limbwave::estimate {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPlace = 0, kSpeed = 1, kLeak = 2, kSlip = 3;
constexpr double kFlat = 0.012;   // m: heel and toe that are so much as high as each other both stand
constexpr double kLook = 0.01;    // s: between the looks whose noise the parameters are
constexpr double kBegin = 1e-3;   // m: where it begins is the beginning
constexpr double kSurest = 1e-4;  // probability
constexpr double kGap = 0.2;      // s: more between two looks is a gap,
constexpr double kStray = 1.0;    // m/s: behind which the velocity is another
constexpr double kCarried = 1.0;  // m/s per √s that the velocity is given where nobody stands

double square(double x) {
  return x * x;
}

// Shares of heel and toe in standing: the lower one.
double toe_share(const FootLook::Sole& sole) {
  return 1.0 / (1.0 + std::exp((sole.toe.z() - sole.heel.z()) / kFlat));
}

// Velocities and accelerations by differences, each at its look.
void differentiate(std::vector<FootLook>& looks) {
  for (std::size_t k = 0; k < looks.size(); ++k) {
    const FootLook& a = looks[k == 0 ? 0 : k - 1];
    const FootLook& b = looks[std::min(k + 1, looks.size() - 1)];
    const double dt = b.time_s - a.time_s;
    for (std::size_t i = 0; i < looks[k].soles.size() && dt > 0.0; ++i) {
      looks[k].soles[i].heel_v = (b.soles[i].heel - a.soles[i].heel) / dt;
      looks[k].soles[i].toe_v = (b.soles[i].toe - a.soles[i].toe) / dt;
    }
  }
  // What takes the velocity of the middle of one interval to that of the next.
  std::vector<Vector3d> v(looks.size(), Vector3d::Zero());
  for (std::size_t k = 0; k < looks.size(); ++k) {
    const FootLook& a = looks[k == 0 ? 0 : k - 1];
    const FootLook& b = looks[std::min(k + 1, looks.size() - 1)];
    v[k] = (b.root_p - a.root_p) / std::max(1e-9, b.time_s - a.time_s);
  }
  for (std::size_t k = 1; k < looks.size(); ++k) {
    looks[k].root_a = (v[k] - v[k - 1]) / std::max(1e-9, looks[k].time_s - looks[k - 1].time_s);
  }
}

}  // namespace

FootRoot::FootRoot(std::size_t feet, const FootRootParameters& parameters) : p_(parameters), feet_(feet) {
  const auto states = static_cast<Eigen::Index>(kSlip + feet);
  x_ = MatrixXd::Zero(states, 3);
  P_ = Pz_ = MatrixXd::Zero(states, states);
}

FootRoot::Contact FootRoot::contact(const FootLook::Sole& sole, double dt) const {
  const double toe = toe_share(sole);
  Contact c;
  c.velocity = (1.0 - toe) * sole.heel_v + toe * sole.toe_v;
  const Vector3d along = sole.toe - sole.heel;
  c.turn = along.cross(sole.toe_v - sole.heel_v).norm() / std::max(1e-6, along.squaredNorm());
  c.variance = square(p_.jitter) * kLook / dt + square(p_.roll * c.turn);
  c.height = ((1.0 - toe) * sole.heel + toe * sole.toe).z();
  return c;
}

void FootRoot::predict(const FootLook& look, double dt, Kept* kept) {
  const Eigen::Index n = x_.rows();
  const double leaks = std::exp(-dt / p_.leak_time);
  const double slips = std::exp(-dt / p_.slip_time);
  MatrixXd F = MatrixXd::Identity(n, n);
  F(kPlace, kSpeed) = dt;
  F(kPlace, kLeak) = 0.5 * dt * dt;
  F(kSpeed, kLeak) = dt;
  F(kLeak, kLeak) = leaks;
  for (Eigen::Index i = kSlip; i < n; ++i) {
    F(i, i) = slips;
  }
  VectorXd Q = VectorXd::Zero(n);
  Q[kSpeed] = square(p_.walk) * dt;
  Q[kLeak] = square(p_.leak) * (1.0 - leaks * leaks);
  Q.tail(n - kSlip).setConstant(square(p_.slip) * (1.0 - slips * slips));
  // Nobody walks on air: an estimate by which nobody stands for long is wrong.
  if (alone_s_ > p_.patience) {
    Q[kSpeed] += square(kCarried) * dt;
  }
  if (dt > kGap) {
    Q[kSpeed] += square(kStray);  // nobody looked
  }
  for (MatrixXd* P : {&P_, &Pz_}) {
    *P = F * *P * F.transpose();
    P->diagonal() += Q;
  }
  x_ = F * x_;
  x_.row(kPlace) += 0.5 * dt * dt * look.root_a.transpose();
  x_.row(kSpeed) += dt * look.root_a.transpose();
  if (kept != nullptr) {
    kept->F = F;
    kept->x_before = x_;
    kept->P_before = P_;
    kept->Pz_before = Pz_;
  }
}

void FootRoot::observe_velocity(std::size_t foot, const Vector3d& innovation, double variance) {
  const auto slip = static_cast<Eigen::Index>(kSlip + foot);
  for (int axis = 0; axis < 3; ++axis) {
    MatrixXd& P = axis < 2 ? P_ : Pz_;
    VectorXd PH = P.col(kSpeed);
    double S = variance;
    if (foot < feet_.size()) {
      PH -= P.col(slip);
      S += PH[kSpeed] - PH[slip];
    } else {
      S += PH[kSpeed];
    }
    x_.col(axis) += PH * (innovation[axis] / S);
    if (axis > 0) {  // the covariance of x is that of y
      P -= PH * PH.transpose() / S;
    }
  }
}

void FootRoot::observe_height(double innovation, double variance) {
  const VectorXd PH = Pz_.col(kPlace);
  const double S = PH[kPlace] + variance;
  x_.col(2) += PH * (innovation / S);
  Pz_ -= PH * PH.transpose() / S;
}

// How much likelier a foot that stands makes what is seen of it than one that does not.
double FootRoot::log_odds(const Contact& c, double lowest, const Vector3d& v, double variance,
                          double variance_z) const {
  const double standing = square(p_.slip) + c.variance;
  const double swinging = square(p_.swing) + c.variance;
  double odds = 0.0;
  for (int axis = 0; axis < 3; ++axis) {
    const double known = axis < 2 ? variance : variance_z;
    const double s1 = known + standing;
    const double s0 = known + swinging * (axis < 2 ? 1.0 : 0.25);
    odds += 0.5 * (std::log(s0 / s1) - v[axis] * v[axis] * (1.0 / s1 - 1.0 / s0));
  }
  odds += c.height <= lowest ? p_.carries : 0.0;
  odds -= 0.5 * std::min(10.0, square((c.height - lowest) / p_.low));
  odds -= 0.5 * std::min(8.0, square(c.turn / p_.turn));
  return std::clamp(odds, -20.0, 20.0);
}

RootPlace FootRoot::place_of(const MatrixXd& x, double variance, double variance_z, double heading) const {
  RootPlace place;
  place.p = x.row(kPlace).transpose();
  // What is wrong in the same way all the time: lengths of legs and slip turn into lengths of ways, heading into their
  // direction, unevenness into height.
  const Vector3d way = place.p - begin_;
  const double along = square(p_.lengths) + square(heading);
  const double flat = variance + along * (square(way.x()) + square(way.y()));
  place.sigma = Vector3d(flat, flat, variance_z).cwiseMax(0.0).cwiseSqrt();
  return place;
}

RootPlace FootRoot::place(double time_s) const {
  RootPlace place =
      place_of(x_, P_(kPlace, kPlace), Pz_(kPlace, kPlace) + square(p_.height) + ground_variance_, heading_);
  place.p += (time_s - time_s_) * x_.row(kSpeed).transpose();
  return place;
}

RootPlace FootRoot::advance(const FootLook& look, const std::vector<double>* standing, Kept* kept) {
  const double dt = look.time_s - time_s_;
  if (!started_) {
    started_ = true;
    begin_ = look.root_p;
    time_s_ = look.time_s;
    x_.setZero();
    x_.row(kPlace) = look.root_p.transpose();
    P_.setZero();
    P_(kPlace, kPlace) = square(kBegin);
    P_(kSpeed, kSpeed) = square(start_speed_);
    P_(kLeak, kLeak) = square(p_.leak);
    P_.diagonal().tail(P_.rows() - kSlip).setConstant(square(p_.slip));
    Pz_ = P_;
  }
  heading_ = look.heading;
  if (dt <= 0.0 || time_s_ == look.time_s) {
    if (kept != nullptr) {
      *kept = {x_, x_, P_, P_, Pz_, Pz_, MatrixXd::Identity(P_.rows(), P_.rows()), ground_variance_};
    }
    return place(look.time_s);
  }
  predict(look, dt, kept);
  looked_s_ += dt;
  time_s_ = look.time_s;
  if (look.still) {
    observe_velocity(feet_.size(), -x_.row(kSpeed).transpose(), square(p_.still) * kLook / dt);
  }
  std::vector<Contact> contacts;
  double lowest = INFINITY;
  for (const FootLook::Sole& sole : look.soles) {
    contacts.push_back(contact(sole, dt));
    lowest = std::min(lowest, contacts.back().height);
  }
  // All feet are judged before any is believed: their order does not count.
  struct Belief {
    std::size_t foot;
    double weight, variance, height, height_variance;
  };
  std::vector<Belief> beliefs;
  for (std::size_t i = 0; i < feet_.size(); ++i) {
    Foot& foot = feet_[i];
    const Contact& c = contacts[i];
    const Vector3d v = x_.row(kSpeed).transpose() + c.velocity;
    if (standing != nullptr) {
      foot.standing = (*standing)[i];
    } else {
      const double stays = foot.standing * std::exp(-dt / p_.stance_time);
      const double comes = (1.0 - foot.standing) * (1.0 - std::exp(-dt / p_.swing_time));
      const double before = std::clamp(stays + comes, kSurest, 1.0 - kSurest);
      const double odds =
          log_odds(c, lowest, v, P_(kSpeed, kSpeed), Pz_(kSpeed, kSpeed)) * std::min(1.0, dt / p_.evidence_time);
      foot.standing = 1.0 / (1.0 + (1.0 - before) / before * std::exp(-odds));
    }
    foot.stood_s += foot.standing * dt;
    foot.down = foot.down && foot.standing > 0.3;
    const double weight = 2.0 * foot.standing - 1.0;
    if (weight <= 0.05) {
      continue;
    }
    // What hardly stands any more, or not yet, says less.
    const double spread = c.variance + square(p_.slip) + P_(kSpeed, kSpeed);
    const double doubt = std::max(1.0, v.squaredNorm() / (p_.doubt * spread));
    const double height = x_(kPlace, 2) + c.height;
    if (!foot.down && weight > 0.5) {
      foot.down = true;
      ++foot.steps;
      const double away = std::abs(height - foot.ground);
      if (!foot.levelled || away > p_.step + 2.0 * std::sqrt(Pz_(kPlace, kPlace))) {
        ground_variance_ += foot.levelled ? Pz_(kPlace, kPlace) + square(p_.height) : 0.0;
        foot.ground = height;
        foot.levelled = true;
      }
    }
    beliefs.push_back({i, weight, c.variance * doubt / weight, c.height,
                       foot.down ? square(p_.height) * p_.slip_time / dt / weight : 0.0});
  }
  for (const Belief& b : beliefs) {
    const Vector3d v = x_.row(kSpeed).transpose() + contacts[b.foot].velocity;
    observe_velocity(b.foot, x_.row(static_cast<Eigen::Index>(kSlip + b.foot)).transpose() - v, b.variance);
  }
  for (const Belief& b : beliefs) {
    if (b.height_variance > 0.0) {
      observe_height(feet_[b.foot].ground - x_(kPlace, 2) - b.height, b.height_variance);
    }
  }
  const bool carried = !beliefs.empty() || look.still;
  alone_s_ = carried ? 0.0 : alone_s_ + dt;
  carried_s_ += carried ? dt : 0.0;
  if (kept != nullptr) {
    kept->x = x_;
    kept->P = P_;
    kept->Pz = Pz_;
    kept->ground_variance = ground_variance_;
  }
  return place(look.time_s);
}

RootPlace FootRoot::push(const FootLook& look) {
  return advance(look, nullptr, nullptr);
}

std::vector<RootPlace> FootRoot::smooth(std::vector<FootLook> looks, const FootRootParameters& parameters,
                                        double speed) {
  const std::size_t count = looks.size();
  const std::size_t feet = count == 0 ? 0 : looks.front().soles.size();
  std::vector<RootPlace> places(count);
  std::vector<std::vector<double>> standing;  // by what lies to both sides
  differentiate(looks);
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds && count > 0; ++round) {
    FootRoot forward(feet, parameters);
    forward.start(speed);
    std::vector<Kept> kept(count);
    for (std::size_t k = 0; k < count; ++k) {
      places[k] = forward.advance(looks[k], round > 0 ? &standing[k] : nullptr, &kept[k]);
    }
    // Rauch, Tung and Striebel.
    std::vector<MatrixXd> x(count);
    std::vector<double> v_variance(count), vz_variance(count);
    MatrixXd P = kept.back().P;
    MatrixXd Pz = kept.back().Pz;
    x.back() = kept.back().x;
    v_variance.back() = P(kSpeed, kSpeed);
    vz_variance.back() = Pz(kSpeed, kSpeed);
    for (std::size_t k = count - 1; k-- > 0;) {
      const Kept& now = kept[k];
      const Kept& next = kept[k + 1];
      const MatrixXd G = next.P_before.ldlt().solve(next.F * now.P).transpose();
      const MatrixXd Gz = next.Pz_before.ldlt().solve(next.F * now.Pz).transpose();
      x[k] = now.x;
      x[k].leftCols(2) += G * (x[k + 1] - next.x_before).leftCols(2);
      x[k].col(2) += Gz * (x[k + 1] - next.x_before).col(2);
      P = now.P + G * (P - next.P_before) * G.transpose();
      Pz = now.Pz + Gz * (Pz - next.Pz_before) * Gz.transpose();
      v_variance[k] = P(kSpeed, kSpeed);
      vz_variance[k] = Pz(kSpeed, kSpeed);
      places[k] =
          forward.place_of(x[k], P(kPlace, kPlace),
                           Pz(kPlace, kPlace) + square(parameters.height) + now.ground_variance, looks[k].heading);
    }
    if (round + 1 == kRounds) {
      break;
    }
    // Forward and backward over the chain, with the velocities of both sides.
    standing.assign(count, std::vector<double>(feet, 0.5));
    std::vector<std::vector<double>> odds(count, std::vector<double>(feet, 0.0));
    FootRoot judge(feet, parameters);
    for (std::size_t k = 1; k < count; ++k) {
      const double dt = looks[k].time_s - looks[k - 1].time_s;
      if (dt <= 0.0) {
        continue;
      }
      std::vector<Contact> contacts;
      double lowest = INFINITY;
      for (std::size_t i = 0; i < feet; ++i) {
        contacts.push_back(judge.contact(looks[k].soles[i], dt));
        lowest = std::min(lowest, contacts.back().height);
      }
      for (std::size_t i = 0; i < feet; ++i) {
        const Vector3d v = x[k].row(kSpeed).transpose() + contacts[i].velocity;
        odds[k][i] = judge.log_odds(contacts[i], lowest, v, v_variance[k], vz_variance[k]) *
                     std::min(1.0, dt / parameters.evidence_time);
      }
    }
    for (std::size_t i = 0; i < feet; ++i) {
      std::vector<double> ahead(count, 0.5);
      const auto leaves = [&](std::size_t k) {
        return 1.0 - std::exp(-(looks[k].time_s - looks[k - 1].time_s) / parameters.stance_time);
      };
      const auto comes = [&](std::size_t k) {
        return 1.0 - std::exp(-(looks[k].time_s - looks[k - 1].time_s) / parameters.swing_time);
      };
      for (std::size_t k = 1; k < count; ++k) {
        const double before = ahead[k - 1] * (1.0 - leaves(k)) + (1.0 - ahead[k - 1]) * comes(k);
        const double one = before * std::exp(odds[k][i]);
        ahead[k] = one / (one + 1.0 - before);
      }
      double one = 1.0;  // likelihood of what comes, if it stands, against
      double none = 1.0;
      for (std::size_t k = count; k-- > 0;) {
        const double a = ahead[k] * one;
        standing[k][i] = a / (a + (1.0 - ahead[k]) * none);
        if (k > 0) {
          const double e = std::exp(odds[k][i]);
          const double next_one = (1.0 - leaves(k)) * e * one + leaves(k) * none;
          none = comes(k) * e * one + (1.0 - comes(k)) * none;
          one = next_one;
          const double sum = one + none;
          one /= sum;
          none /= sum;
        }
      }
    }
  }
  return places;
}

nlohmann::json FootRoot::save() const {
  const auto list = [](const MatrixXd& m) { return std::vector<double>(m.data(), m.data() + m.size()); };
  nlohmann::json feet = nlohmann::json::array();
  for (const Foot& foot : feet_) {
    feet.push_back({foot.standing, foot.stood_s, foot.ground, foot.levelled ? 1 : 0, foot.down ? 1 : 0, foot.steps});
  }
  return {{"started", started_},
          {"x", list(x_)},
          {"P", list(P_)},
          {"P_z", list(Pz_)},
          {"begin", list(begin_)},
          {"times",
           std::vector<double>{time_s_, heading_, start_speed_, alone_s_, carried_s_, looked_s_, ground_variance_}},
          {"feet", feet}};
}

void FootRoot::load(const JsonReader& saved) {
  const auto read = [&](const char* key, double* to, Eigen::Index count) {
    const std::vector<double> values = saved.at(key).numbers(static_cast<std::size_t>(count));
    std::copy(values.begin(), values.end(), to);
  };
  started_ = saved.at("started").boolean();
  read("x", x_.data(), x_.size());
  read("P", P_.data(), P_.size());
  read("P_z", Pz_.data(), Pz_.size());
  read("begin", begin_.data(), 3);
  const std::vector<double> times = saved.at("times").numbers(7);
  const std::vector<JsonReader> feet = saved.at("feet").items();
  if (times.size() != 7 || feet.size() != feet_.size()) {
    saved.fail("is of another skeleton or rig");
    return;
  }
  time_s_ = times[0];
  heading_ = times[1];
  start_speed_ = times[2];
  alone_s_ = times[3];
  carried_s_ = times[4];
  looked_s_ = times[5];
  ground_variance_ = times[6];
  for (std::size_t i = 0; i < feet.size(); ++i) {
    if (const std::vector<double> v = feet[i].numbers(6); v.size() == 6) {
      feet_[i] = {v[0], v[1], v[2], v[3] != 0.0, v[4] != 0.0, static_cast<int>(v[5])};
    }
  }
}

}  // namespace limbwave::estimate
