#include "estimate/chain_model.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "base/units.h"
#include "estimate/joint_plausibility.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using geometry::skew;

constexpr std::array<double, 3> kNumerov{1.0 / 12.0, 10.0 / 12.0, 1.0 / 12.0};

// How a residual changes with one unknown vector.
struct Term {
  std::size_t instant;
  Index column;
  Matrix3d J;
};
using Terms = std::vector<Term>;

// Sums costs.
struct CostSink {
  static constexpr bool kJacobians = false;
  double cost = 0.0;
  void add(const Terms& /*terms*/, const Vector3d& residual, double weight) {
    cost += 0.5 * weight * residual.squaredNorm();
  }
  void add_robust(const Terms& /*terms*/, const Vector3d& residual, double sd) {
    cost += 0.5 * (ChainModel::kStudent + 3.0) * std::log1p(residual.squaredNorm() / (sd * sd * ChainModel::kStudent));
  }
};

// Sums normal equations too.
struct EquationSink {
  static constexpr bool kJacobians = true;
  explicit EquationSink(BlockBand& equations) : system(equations) {}
  BlockBand& system;
  CostSink costs;

  void add(const Terms& terms, const Vector3d& residual, double weight) {
    costs.add(terms, residual, weight);
    accumulate(terms, residual, weight);
  }
  void add_robust(const Terms& terms, const Vector3d& residual, double sd) {
    costs.add_robust(terms, residual, sd);
    const double square = residual.squaredNorm() / (sd * sd);
    accumulate(terms, residual, (ChainModel::kStudent + 3.0) / (ChainModel::kStudent + square) / (sd * sd));
  }

 private:
  void accumulate(const Terms& terms, const Vector3d& residual, double weight) {
    for (const Term& a : terms) {
      const Matrix3d weighted = weight * a.J.transpose();
      system.right(a.instant).segment<3>(a.column).noalias() -= weighted * residual;
      for (const Term& b : terms) {
        if (a.instant > b.instant || (a.instant == b.instant && a.column >= b.column)) {
          system.at(a.instant, b.instant).block<3, 3>(a.column, b.column).noalias() += weighted * b.J;
        }
      }
    }
  }
};

}  // namespace

ChainModel::ChainModel(const LimbChain& chain, std::vector<double> times, std::vector<std::vector<ForceSample>> samples,
                       const ChainPriors& priors)
    : chain_(chain), times_(std::move(times)), samples_(std::move(samples)), priors_(priors) {
  assert(times_.size() > kReach && samples_.size() == chain_.links.size());
  int roots = 0;
  for (std::size_t i = 0; i < chain_.links.size(); ++i) {
    const int parent = chain_.links[i].parent;
    root_of_.push_back(parent < 0 ? roots++ : root_of_[static_cast<std::size_t>(parent)]);
    std::vector<int>& path = path_.emplace_back();
    for (int link = static_cast<int>(i); link >= 0; link = chain_.links[static_cast<std::size_t>(link)].parent) {
      path.push_back(link);
    }
  }
  size_ = static_cast<Index>(3 * (chain_.links.size() + static_cast<std::size_t>(roots)));
  step_s_ = (times_.back() - times_.front()) / static_cast<double>(times_.size() - 1);
  second_.resize(times_.size());
  for (std::size_t k = 1; k + 1 < times_.size(); ++k) {
    const double before = times_[k] - times_[k - 1];
    const double after = times_[k + 1] - times_[k];
    const double mean = 0.5 * (before + after);
    second_[k] = {1.0 / (before * mean), -1.0 / (before * mean) - 1.0 / (after * mean), 1.0 / (after * mean)};
  }
}

bool ChainModel::force_residual(const ChainState& state, std::size_t link, std::size_t instant,
                                Vector3d& residual) const {
  if (instant == 0 || instant + 1 >= times_.size()) {
    return false;
  }
  residual = Vector3d(0.0, 0.0, -kStandardGravity);
  const auto root = static_cast<std::size_t>(root_of_[link]);
  for (std::size_t m = 0; m < 3; ++m) {
    const std::size_t k = instant + m - 1;
    if (!samples_[link][k].usable) {
      return false;
    }
    residual += kNumerov[m] * (state.R_WL[link][k] * samples_[link][k].f_L);
    Vector3d x = state.q_W[root][k];
    const Vector3d* p = &chain_.links[link].p_LS;
    for (const int on_path : path_[link]) {
      const auto i = static_cast<std::size_t>(on_path);
      x += state.R_WL[i][k] * *p;
      p = &chain_.links[i].p_PL;
    }
    residual -= second_[instant][m] * x;
  }
  return true;
}

Vector3d ChainModel::rate(const ChainState& state, std::size_t link, std::size_t instant) const {
  const auto& R = state.R_WL[link];
  return geometry::log_so3(R[instant + 1] * R[instant].conjugate()) / (times_[instant + 1] - times_[instant]);
}

Vector3d ChainModel::turning(const ChainState& state, std::size_t link, std::size_t instant) const {
  return (rate(state, link, instant) - rate(state, link, instant - 1)) /
         (0.5 * (times_[instant + 1] - times_[instant - 1]));
}

Vector3d ChainModel::root_acceleration(const ChainState& state, std::size_t root, std::size_t instant) const {
  const auto& q = state.q_W[root];
  const auto& w = second_[instant];
  return w[0] * q[instant - 1] + w[1] * q[instant] + w[2] * q[instant + 1];
}

template <typename Sink>
void ChainModel::visit_forces(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const {
  Terms terms;
  Vector3d residual;
  for (std::size_t link = 0; link < chain_.links.size(); ++link) {
    if (!force_residual(state, link, k, residual)) {
      continue;
    }
    terms.clear();
    if constexpr (Sink::kJacobians) {
      const auto links = static_cast<Index>(chain_.links.size());
      for (std::size_t m = 0; m < 3; ++m) {
        const std::size_t at = k + m - 1;
        const double second = second_[k][m];
        const Vector3d* p = &chain_.links[link].p_LS;
        for (const int on_path : path_[link]) {
          const auto i = static_cast<std::size_t>(on_path);
          Vector3d moment = second * (state.R_WL[i][at] * *p);
          if (i == link) {
            moment -= kNumerov[m] * (state.R_WL[i][at] * samples_[i][at].f_L);
          }
          terms.push_back({at, 3 * static_cast<Index>(on_path), skew(moment)});
          p = &chain_.links[i].p_PL;
        }
        terms.push_back({at, 3 * (links + root_of_[link]), -second * Matrix3d::Identity()});
      }
    }
    sink.add_robust(terms, residual, weights.force_sd[link][k]);
  }
}

template <typename Sink>
void ChainModel::visit_turning(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const {
  Terms terms;
  for (std::size_t link = 0; link < chain_.links.size(); ++link) {
    const auto& R = state.R_WL[link];
    const auto column = 3 * static_cast<Index>(link);
    // The three rates around the inner instants k and k + 1 are linear in small turns at k − 1 .. k + 2.
    std::array<Vector3d, 3> rates;
    std::array<Matrix3d, 3> from;  // d rate / d turn of its later and of its earlier end
    std::array<Matrix3d, 3> to;
    std::array<double, 3> steps{};
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t at = k + m - 1;
      steps[m] = times_[at + 1] - times_[at];
      const Vector3d turn = geometry::log_so3(R[at + 1] * R[at].conjugate());
      rates[m] = turn / steps[m];
      if constexpr (Sink::kJacobians) {
        to[m] = geometry::left_jacobian_inverse(turn) / steps[m];
        from[m] = -geometry::right_jacobian_inverse(turn) / steps[m];
      }
    }
    const double early = 2.0 / (steps[0] + steps[1]);
    const double late = 2.0 / (steps[1] + steps[2]);
    const double kept = std::exp(-1.0 / (priors_.turning_memory_s * late));
    // late · (w2 − w1) − kept · early · (w1 − w0)
    const std::array<double, 3> c{kept * early, -late - kept * early, late};
    terms.clear();
    if constexpr (Sink::kJacobians) {
      terms.push_back({k - 1, column, c[0] * from[0]});
      terms.push_back({k, column, c[0] * to[0] + c[1] * from[1]});
      terms.push_back({k + 1, column, c[1] * to[1] + c[2] * from[2]});
      terms.push_back({k + 2, column, c[2] * to[2]});
    }
    const double sd = 0.5 * (weights.turning_sd[link][k] + weights.turning_sd[link][k + 1]);
    sink.add(terms, c[0] * rates[0] + c[1] * rates[1] + c[2] * rates[2], 1.0 / (sd * sd * (1.0 - kept * kept)));
    // Nobody turns without end.
    terms.clear();
    if constexpr (Sink::kJacobians) {
      terms.push_back({k, column, from[1]});
      terms.push_back({k + 1, column, to[1]});
    }
    const double share = std::min(1.0, steps[1] / priors_.turning_rate_memory_s);
    sink.add(terms, rates[1], share / std::pow(weights.rate_sd[link][k], 2));
  }
}

template <typename Sink>
void ChainModel::visit_root(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const {
  Terms terms;
  for (std::size_t root = 0; root < state.q_W.size(); ++root) {
    const auto column = 3 * static_cast<Index>(chain_.links.size() + root);
    const Vector3d early = root_acceleration(state, root, k);
    const Vector3d late = root_acceleration(state, root, k + 1);
    const double step = times_[k + 1] - times_[k];
    const double kept = std::exp(-step / priors_.root_memory_s);
    const auto& a = second_[k];
    const auto& b = second_[k + 1];
    terms.clear();
    if constexpr (Sink::kJacobians) {
      const Matrix3d one = Matrix3d::Identity();
      terms.push_back({k - 1, column, -kept * a[0] * one});
      terms.push_back({k, column, (b[0] - kept * a[1]) * one});
      terms.push_back({k + 1, column, (b[1] - kept * a[2]) * one});
      terms.push_back({k + 2, column, b[2] * one});
    }
    const double sd = weights.root_sd[root][k];
    sink.add(terms, late - kept * early, 1.0 / (sd * sd * (1.0 - kept * kept)));
    // The velocity stays near zero; what is constant of it does not matter, but it must not grow.
    terms.clear();
    if constexpr (Sink::kJacobians) {
      terms.push_back({k, column, -Matrix3d::Identity() / step});
      terms.push_back({k + 1, column, Matrix3d::Identity() / step});
    }
    const double share = std::min(1.0, step / priors_.root_velocity_memory_s);
    const double velocity_sd = priors_.root_velocity_s * sd;
    sink.add(terms, (state.q_W[root][k + 1] - state.q_W[root][k]) / step, share / (velocity_sd * velocity_sd));
    terms.clear();
    if constexpr (Sink::kJacobians) {
      terms.push_back({k, column, Matrix3d::Identity()});
    }
    sink.add(terms, state.q_W[root][k], 1e-4);  // from somewhere
  }
}

template <typename Sink>
void ChainModel::visit_joints(const ChainState& state, std::size_t k, Sink& sink) const {
  Terms terms;
  const double share = std::min(1.0, step_s_ / priors_.joint_memory_s);
  for (std::size_t link = 0; link < chain_.links.size(); ++link) {
    const ChainLink& child = chain_.links[link];
    if (child.parent < 0) {
      continue;
    }
    const Quaterniond R_WP = state.R_WL[static_cast<std::size_t>(child.parent)][k] * child.R_PL_rest;
    const Quaterniond R = R_WP.conjugate() * state.R_WL[link][k];
    for (const JointResidual& residual : joint_residuals(child.joint, R, priors_.joint_sd, priors_.joint_middle)) {
      terms.clear();
      if constexpr (Sink::kJacobians) {
        // In W: a turn of the child, or the opposite one of the parent.
        Matrix3d J = Matrix3d::Zero();
        J.row(0) = (R_WP * residual.gradient).transpose();
        terms.push_back({k, 3 * static_cast<Index>(link), J});
        terms.push_back({k, 3 * static_cast<Index>(child.parent), -J});
      }
      sink.add(terms, Vector3d(residual.value, 0.0, 0.0), share);
    }
  }
}

template <typename Sink>
void ChainModel::visit(const ChainState& state, const ChainWeights& weights, std::size_t k, Sink& sink) const {
  if (k >= 1 && k + 1 < times_.size()) {
    visit_forces(state, weights, k, sink);
  }
  if (k >= 1 && k + 2 < times_.size()) {
    visit_turning(state, weights, k, sink);
    visit_root(state, weights, k, sink);
  }
  visit_joints(state, k, sink);
}

double ChainModel::cost(const ChainState& state, const ChainWeights& weights) const {
  CostSink sink;
  for (std::size_t k = 0; k < times_.size(); ++k) {
    visit(state, weights, k, sink);
  }
  return sink.cost;
}

std::vector<double> ChainModel::costs(const ChainState& state, const ChainWeights& weights) const {
  std::vector<double> costs;
  for (std::size_t k = 0; k < times_.size(); ++k) {
    CostSink sink;
    visit(state, weights, k, sink);
    costs.push_back(sink.cost);
  }
  return costs;
}

double ChainModel::linearise(const ChainState& state, const ChainWeights& weights, BlockBand& system) const {
  system.set_zero();
  EquationSink sink(system);
  for (std::size_t k = 0; k < times_.size(); ++k) {
    visit(state, weights, k, sink);
  }
  return sink.costs.cost;
}

ChainState ChainModel::moved(const ChainState& state, const std::vector<Eigen::VectorXd>& step) const {
  ChainState result = state;
  const std::size_t links = chain_.links.size();
  for (std::size_t k = 0; k < times_.size(); ++k) {
    for (std::size_t i = 0; i < links; ++i) {
      const Vector3d turn = step[k].segment<3>(3 * static_cast<Index>(i));
      result.R_WL[i][k] = (geometry::exp_so3(turn) * state.R_WL[i][k]).normalized();
    }
    for (std::size_t r = 0; r < result.q_W.size(); ++r) {
      result.q_W[r][k] += step[k].segment<3>(3 * static_cast<Index>(links + r));
    }
  }
  return result;
}

}  // namespace limbwave::estimate
