#include "estimate/rest_start.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "base/units.h"
#include "geometry/so3.h"

namespace limbwave::estimate {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kBiasLeft = 0.0007;  // rad/s: nobody stands more still
constexpr double kHeading = 0.002;    // rad: of the start, by definition
constexpr double kUpsideDown = 2.4;   // rad
constexpr double kStrangePose = 0.8;  // rad: of joints when the pose is another
constexpr int kLeast = 10;            // readings that make a mean

double first_time(const BodyReadings& readings) {
  return std::min(readings.inertial.empty() ? INFINITY : readings.inertial.front().time_s,
                  readings.ranges.empty() ? INFINITY : readings.ranges.front().time_s);
}

// What a board at rest in this state reads.
Vector3d expected_force(const BodyFilter& filter, const body::TreeKinematics& kinematics, const BodyState& state,
                        std::size_t b) {
  const BodyBoard& board = filter.model().boards[b];
  const Matrix3d& R_WL = kinematics.link(filter.tree().link_of(board.segment)).R_WL;
  return (R_WL * (board.R_LS * state.mount_rotation[b]).toRotationMatrix()).transpose() *
         Vector3d(0.0, 0.0, kStandardGravity);
}

bool says_gravity(const BoardAtRest& board) {
  return board.forces >= kLeast && !board.moved && !board.silent && !board.turned;
}

// The root's rotation from a board on it.
bool incline(const BodyModel& model, const std::vector<BoardAtRest>& boards, RootReading& root) {
  for (std::size_t b = 0; b < boards.size(); ++b) {
    if (model.boards[b].segment == 0 && boards[b].forces > 0 && !boards[b].silent) {
      const Quaterniond rest = model.skeleton.segments.front().R_PL_rest;
      const Vector3d up_W = rest * (model.boards[b].R_LS * boards[b].force);
      if (up_W.normalized().z() < 0.0) {
        return false;  // nobody starts head down: the board is turned
      }
      root.R_WL = geometry::shortest_arc(up_W, Vector3d::UnitZ()) * rest;
      root.p_W = model.skeleton.segments.front().p_PL;
      return true;
    }
  }
  return false;
}

}  // namespace

std::string listed(const std::vector<std::string>& names, std::size_t most) {
  std::string text;
  const std::size_t count = std::min(names.size(), most);
  for (std::size_t i = 0; i < count; ++i) {
    const bool last = i + 1 == count && count == names.size();
    text += (i == 0 ? "\"" : (last ? " and \"" : ", \"")) + names[i] + "\"";
  }
  return names.size() > count ? text + " and " + std::to_string(names.size() - count) + " more" : text;
}

std::vector<double> bone_scales(const body::Tree& tree, const BodyState& state) {
  std::vector<double> scale(tree.links().size(), 1.0);
  for (std::size_t l = 0; l < scale.size(); ++l) {
    if (const int parent = tree.links()[l].parent; parent >= 0) {
      const auto segment = static_cast<std::size_t>(tree.links()[static_cast<std::size_t>(parent)].segment);
      scale[l] = 1.0 + state.bone_scale[segment];
    }
  }
  return scale;
}

std::vector<BoardAtRest> look_at_rest(const BodyModel& model, const BodyReadings& readings,
                                      const RestParameters& rest) {
  std::vector<BoardAtRest> boards(model.boards.size());
  std::vector<double> force_squares(boards.size(), 0.0);
  std::vector<double> rate_squares(boards.size(), 0.0);
  const double end = first_time(readings) + rest.window_s;
  for (const InertialReading& reading : readings.inertial) {
    if (reading.time_s > end) {
      break;
    }
    const auto b = static_cast<std::size_t>(reading.board);
    if (reading.f_S.allFinite()) {
      boards[b].force += reading.f_S;
      force_squares[b] += reading.f_S.squaredNorm();
      ++boards[b].forces;
    }
    if (reading.w_S.allFinite()) {
      boards[b].rate += reading.w_S;
      rate_squares[b] += reading.w_S.squaredNorm();
      ++boards[b].rates;
    }
  }
  for (std::size_t b = 0; b < boards.size(); ++b) {
    BoardAtRest& board = boards[b];
    const auto spread = [](Vector3d& sum, double squares, int count) {
      sum /= std::max(1, count);
      return std::sqrt(std::max(0.0, squares / std::max(1, count) - sum.squaredNorm()));
    };
    board.tremble = spread(board.force, force_squares[b], board.forces);
    board.spread = spread(board.rate, rate_squares[b], board.rates);
    board.moved = (board.rates >= kLeast && (board.spread > rest.most_spread || board.rate.norm() > rest.most_rate)) ||
                  (board.forces >= kLeast && board.tremble > rest.most_tremble);
    board.silent = (board.forces == 0 && board.rates == 0) ||
                   (board.forces >= kLeast && !board.moved && board.force.norm() < rest.least_force);
  }
  return boards;
}

double refine_at_rest(const BodyFilter& filter, const std::vector<BoardAtRest>& boards, const VectorXd& prior,
                      double gravity_noise, BodyState& state) {
  const BodyLayout& layout = filter.layout();
  const BodyState start = state;
  body::TreeKinematics kinematics(filter.tree());
  body::PointJacobians jacobians;
  VectorXd x = VectorXd::Zero(layout.size);  // from the start; the rotations among it are small
  // Only what turns a board or is its offset: a dense system of a few hundred at most.
  std::vector<int> used;
  std::vector<int> place(static_cast<std::size_t>(layout.size), -1);
  const auto use = [&](int index) {
    if (index >= 0 && place[static_cast<std::size_t>(index)] < 0 && prior[index] > 0.0) {
      place[static_cast<std::size_t>(index)] = static_cast<int>(used.size());
      used.push_back(index);
    }
  };
  for (std::size_t b = 0; b < boards.size(); ++b) {
    if (!says_gravity(boards[b])) {
      continue;
    }
    for (const int dof : filter.tree().chain_dofs(filter.tree().link_of(filter.model().boards[b].segment))) {
      use(dof);
    }
    for (int i = 0; i < 3; ++i) {
      use(layout.mount_rotation[b] < 0 ? -1 : layout.mount_rotation[b] + i);
      use(layout.accelerometer_bias[b] < 0 ? -1 : layout.accelerometer_bias[b] + i);
    }
  }
  const auto size = static_cast<Eigen::Index>(used.size());
  double last = 0.0;
  for (int iteration = 0; iteration < 15 && size > 0; ++iteration) {
    kinematics.update(state.joints, bone_scales(filter.tree(), state));
    MatrixXd A = MatrixXd::Zero(size, size);
    VectorXd g = VectorXd::Zero(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double sigma = prior[used[static_cast<std::size_t>(i)]];
      A(i, i) = 1.0 / (sigma * sigma);
      g[i] = -x[used[static_cast<std::size_t>(i)]] * A(i, i);
    }
    const double weight = 1.0 / (gravity_noise * gravity_noise);
    for (std::size_t b = 0; b < boards.size(); ++b) {
      if (!says_gravity(boards[b])) {
        continue;
      }
      const BodyBoard& board = filter.model().boards[b];
      const int link = filter.tree().link_of(board.segment);
      const Matrix3d R_SW =
          (kinematics.link(link).R_WL * (board.R_LS * state.mount_rotation[b]).toRotationMatrix()).transpose();
      const Vector3d f_S = expected_force(filter, kinematics, state, b);
      const Vector3d residual = boards[b].force - f_S - state.accelerometer_bias[b];
      kinematics.jacobians(link, kinematics.point(link, board.p_LS), body::TreeKinematics::kPosition, jacobians);
      std::vector<int> columns;
      std::vector<Vector3d> H;
      const auto put = [&](int index, const Vector3d& column) {
        if (index >= 0 && place[static_cast<std::size_t>(index)] >= 0) {
          columns.push_back(place[static_cast<std::size_t>(index)]);
          H.push_back(column);
        }
      };
      const std::vector<int>& dofs = filter.tree().chain_dofs(link);
      for (std::size_t c = 0; c < dofs.size(); ++c) {
        const Vector3d s = jacobians.J_phi_theta.col(static_cast<Eigen::Index>(c));
        put(dofs[c], -(R_SW * s.cross(Vector3d(0.0, 0.0, kStandardGravity))));
      }
      const Matrix3d turn = geometry::skew(f_S);
      for (int i = 0; i < 3; ++i) {
        put(layout.mount_rotation[b] < 0 ? -1 : layout.mount_rotation[b] + i, turn.col(i));
        put(layout.accelerometer_bias[b] < 0 ? -1 : layout.accelerometer_bias[b] + i, Vector3d::Unit(i));
      }
      for (std::size_t i = 0; i < columns.size(); ++i) {
        g[columns[i]] += weight * H[i].dot(residual);
        for (std::size_t k = 0; k < columns.size(); ++k) {
          A(columns[i], columns[k]) += weight * H[i].dot(H[k]);
        }
      }
    }
    const VectorXd step = A.ldlt().solve(g);
    for (Eigen::Index i = 0; i < size; ++i) {
      x[used[static_cast<std::size_t>(i)]] += step[i];
    }
    state = start;
    filter.inject(state, x);
    last = step.cwiseAbs().maxCoeff();
    if (last < 1e-9) {
      break;
    }
  }
  return size > 0 ? x.cwiseAbs().maxCoeff() : 0.0;
}

Result<RestStart> start_at_rest(BodyFilter& filter, const BodyReadings& readings, const RestParameters& rest,
                                const RootReading* root) {
  const BodyModel& model = filter.model();
  const BodyFilterParameters& p = filter.parameters();
  const BodyLayout& layout = filter.layout();
  const double begin = first_time(readings);
  std::vector<BoardAtRest> boards = look_at_rest(model, readings, rest);
  Diagnostics found;
  std::vector<std::string> moved;
  for (std::size_t b = 0; b < boards.size(); ++b) {
    if (boards[b].moved) {
      moved.push_back(model.boards[b].name);
    }
  }
  if (rest.mode == StartMode::kRest && !moved.empty()) {
    return Error{listed(moved) + " moved in the first second", "",
                 "begin with a second of standing still in the rest pose, or start in mid-motion"};
  }
  const bool moving = rest.mode == StartMode::kMoving || 3 * moved.size() > boards.size();
  if (rest.mode == StartMode::kAny && moving) {
    found.push_back({Severity::kWarning, "body.starts-moving",
                     listed(moved) + " moved in the first second: the pose at the start is hardly known",
                     "begin with a second of standing still in the rest pose", "", begin});
  }
  for (std::size_t b = 0; b < boards.size() && rest.mode == StartMode::kAny && !moving; ++b) {
    if (boards[b].moved) {
      found.push_back({Severity::kWarning, "body.not-still",
                       "\"" + model.boards[b].name + "\" moved in the first second: its gyroscope's bias is not known",
                       "begin with a second of standing still", model.boards[b].name, begin});
    }
  }
  RootReading inclined;
  const bool free = filter.tree().root_motion() == body::RootMotion::kFree;
  const bool by_gravity = root == nullptr && free && p.use_accelerometers && incline(model, boards, inclined);
  filter.start(begin, root != nullptr ? root : (by_gravity ? &inclined : nullptr));
  ErrorCovariance& P = filter.mutable_covariance();
  const int n = layout.dofs;
  const auto deviation = [&](int i, double sigma) { P.set_variance(i, sigma * sigma); };
  for (int i = 0; i < n; ++i) {
    // A root that is given is where it is given; how fast it is then, its path tells.
    const bool of_root = free && i < 6;
    if (moving && !of_root) {
      deviation(i, rest.moving_pose);
    }
    if (!of_root || root == nullptr) {
      deviation(n + i, moving ? rest.moving_rate : rest.rate);
      deviation(2 * n + i, moving ? rest.moving_acceleration : rest.acceleration);
    }
  }
  if (by_gravity) {
    // What a mounting may be off, and a pelvis not upright; but where ahead is, is the start's to say.
    const double tilt = moving ? 0.3 : 0.05;
    const Vector3d up = inclined.R_WL.conjugate() * Vector3d::UnitZ();
    const Matrix3d along = up * up.transpose();
    const Matrix3d C = tilt * tilt * (Matrix3d::Identity() - along) + kHeading * kHeading * along;
    for (int i = 0; i < 3; ++i) {
      deviation(3 + i, tilt);
    }
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        P.row(3 + i)[3 + k] = C(i, k);
      }
    }
  }
  BodyState state = filter.state();
  body::TreeKinematics kinematics(filter.tree());
  kinematics.update(state.joints, bone_scales(filter.tree(), state));
  std::size_t turned = 0;
  for (std::size_t b = 0; b < boards.size() && !moving; ++b) {
    BoardAtRest& board = boards[b];
    if (board.forces < kLeast || board.moved || board.silent) {
      continue;
    }
    const Vector3d expected = expected_force(filter, kinematics, state, b);
    board.off = std::atan2(expected.cross(board.force).norm(), expected.dot(board.force));
    board.turned = model.boards.size() > 1 && board.off > rest.turned;
    turned += board.turned ? 1 : 0;
  }
  const bool strange = turned > std::max<std::size_t>(1, boards.size() / 6);
  for (std::size_t b = 0; b < boards.size(); ++b) {
    if (!boards[b].turned) {
      continue;
    }
    boards[b].turned = !strange;
    if (!strange) {
      found.push_back({Severity::kWarning, "body.board-turned",
                       "\"" + model.boards[b].name + "\" feels gravity " +
                           std::to_string(static_cast<int>(std::lround(degrees(boards[b].off)))) +
                           "° away from where it should be in the rest pose",
                       boards[b].off > kUpsideDown ? "it is mounted upside down: turn it round, or say so in the rig"
                                                   : "mount it as the rig says, and hold the rest pose",
                       model.boards[b].name, begin});
    }
  }
  if (strange) {
    found.push_back({Severity::kWarning, "body.not-rest-pose",
                     std::to_string(turned) + " sensors feel gravity far from where it is in the rest pose",
                     "begin in the rest pose", "", begin});
    for (int i = free ? 6 : 0; i < n; ++i) {
      deviation(i, kStrangePose);
    }
  }
  if (!moving && p.use_accelerometers) {
    VectorXd prior(layout.size);
    for (int i = 0; i < layout.size; ++i) {
      prior[i] = std::sqrt(P(i, i));
    }
    refine_at_rest(filter, boards, prior, rest.gravity_noise, state);
  }
  for (std::size_t b = 0; b < boards.size(); ++b) {
    const BoardAtRest& board = boards[b];
    if (board.rates < 2 * kLeast || layout.gyroscope_bias[b] < 0 || board.moved || board.silent || moving) {
      continue;
    }
    state.gyroscope_bias[b] = board.rate;
    for (int i = 0; i < 3; ++i) {
      P.set_variance(layout.gyroscope_bias[b] + i, kBiasLeft * kBiasLeft + board.spread * board.spread / board.rates);
    }
  }
  filter.set_state(state);
  return RestStart{std::move(found), std::move(boards), moving, strange};
}

}  // namespace limbwave::estimate
