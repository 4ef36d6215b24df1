#include "estimate/fixed_lag.h"

#include <algorithm>

#include "estimate/body_smoother.h"

namespace limbwave::estimate {

void FixedLag::push(const BodyFilter& filter, StepRecord record, bool wanted) {
  Kept& kept = steps_.emplace_back();
  kept.record = std::move(record);
  kept.time_s = filter.state().time_s;
  kept.wanted = wanted;
  if (wanted) {
    kept.state = filter.state();
    const int dofs = filter.layout().dofs;
    kept.P_theta.resize(filter.layout().size, dofs);
    for (int d = 0; d < dofs; ++d) {
      std::copy_n(filter.covariance().row(d), filter.layout().size, kept.P_theta.col(d).data());
    }
  }
  drop_old();
}

// Steps before the oldest wanted one are of no use any more.
void FixedLag::drop_old() {
  while (!steps_.empty() && !steps_.front().wanted && steps_.back().time_s - steps_.front().time_s > lag_s_) {
    steps_.pop_front();
  }
}

std::optional<BodyState> FixedLag::next(const BodyFilter& filter, bool all) {
  const auto oldest = std::find_if(steps_.begin(), steps_.end(), [](const Kept& kept) { return kept.wanted; });
  if (oldest == steps_.end() || (!all && steps_.back().time_s - oldest->time_s < lag_s_ - 1e-9)) {
    return std::nullopt;
  }
  Eigen::VectorXd lambda = Eigen::VectorXd::Zero(filter.layout().size);
  for (auto step = std::prev(steps_.end()); step != oldest; --step) {
    adjoint_over_step(step->record, filter.tree(), lambda);
  }
  BodyState state = oldest->state;
  filter.tree().add(state.joints, -(oldest->P_theta.transpose() * lambda));
  oldest->wanted = false;
  oldest->P_theta.resize(0, 0);
  drop_old();
  return state;
}

}  // namespace limbwave::estimate
