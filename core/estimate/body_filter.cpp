#include "estimate/body_filter.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

namespace limbwave::estimate {
namespace {

using body::TreeLink;
using Eigen::VectorXd;

// Rows that are updated with at once: more rows pass over the covariance less often, fewer need less to be
// decorrelated. All readings of a body with some twenty boards.
constexpr int kChunkRows = 150;

BodyLayout make_layout(const BodyModel& model, const BodyFilterParameters& p, const body::Tree& tree) {
  BodyLayout layout;
  layout.dofs = tree.dofs();
  layout.size = 3 * tree.dofs();
  const auto take = [&](bool wanted, int count) {
    const int first = wanted ? layout.size : -1;
    layout.size += wanted ? count : 0;
    return first;
  };
  const bool inertial = p.use_gyroscopes || p.use_accelerometers;
  // What moves lies together.
  const auto slides = [&](const BodyBoard& board) {
    return p.tissue_angle > 0.0 &&
           ((p.use_gyroscopes && board.gyroscope) || (p.use_accelerometers && board.accelerometer));
  };
  for (const BodyBoard& board : model.boards) {
    layout.tissue_angle.push_back(take(slides(board), 3));
  }
  for (const BodyBoard& board : model.boards) {
    layout.tissue_gain.push_back(take(slides(board), 3));
  }
  layout.moving = layout.size;
  for (const BodyBoard& board : model.boards) {
    const bool gyroscope = p.use_gyroscopes && board.gyroscope;
    const bool accelerometer = p.use_accelerometers && board.accelerometer;
    const bool microphone = p.use_ranges && board.microphone && !model.sources.empty();
    layout.gyroscope_bias.push_back(take(gyroscope && p.gyroscope_bias > 0.0, 3));
    layout.accelerometer_bias.push_back(take(accelerometer && p.accelerometer_bias > 0.0, 3));
    layout.mount_rotation.push_back(take(inertial && (gyroscope || accelerometer) && p.mount_rotation > 0.0, 3));
    layout.mount_place.push_back(take((accelerometer || microphone) && p.mount_place > 0.0, 3));
  }
  for (std::size_t s = 0; s < model.sources.size(); ++s) {
    layout.source_place.push_back(take(p.use_ranges && p.source_place > 0.0, 3));
    layout.range_offset.push_back(take(p.use_ranges && p.range_offset > 0.0, 1));
  }
  layout.sound_scale = take(p.use_ranges && !model.sources.empty() && p.sound_scale > 0.0, 1);
  for (std::size_t s = 0; s < model.skeleton.segments.size(); ++s) {
    const bool carries = std::any_of(
        model.skeleton.segments.begin(), model.skeleton.segments.end(),
        [&](const body::Segment& child) { return child.parent == static_cast<int>(s) && !child.p_PL.isZero(); });
    layout.bone_scale.push_back(take(carries && p.bone_scale > 0.0 && (p.use_accelerometers || p.use_ranges), 1));
  }
  return layout;
}

body::RootMotion root_motion(RootMode mode) {
  return mode == RootMode::kFixed ? body::RootMotion::kJoint : body::RootMotion::kFree;
}

// Probability that χ² exceeds x: closed forms for up to three degrees of freedom.
double chi_square_tail(int freedom, double x) {
  const double one = std::erfc(std::sqrt(0.5 * x));
  return freedom == 1   ? one
         : freedom == 2 ? std::exp(-0.5 * x)
                        : one + std::sqrt(2.0 * x / EIGEN_PI) * std::exp(-0.5 * x);
}

}  // namespace

double chi_square_limit(int freedom, double probability) {
  assert(freedom >= 1 && freedom <= 3 && probability > 0.0 && probability < 1.0);
  double low = 0.0;
  double high = 1000.0;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (chi_square_tail(freedom, middle) > probability ? low : high) = middle;
  }
  return high;
}

BodyFilter::BodyFilter(BodyModel model, const BodyFilterParameters& parameters)
    : model_(std::move(model)),
      parameters_(parameters),
      tree_(model_.skeleton, root_motion(parameters.root)),
      layout_(make_layout(model_, parameters_, tree_)),
      kinematics_(tree_),
      P_(layout_.size),
      correction_(VectorXd::Zero(layout_.size)),
      gyroscope_counts_(model_.boards.size()),
      accelerometer_counts_(model_.boards.size()),
      range_counts_(model_.sources.size()) {
  for (int rows = 1; rows <= 3; ++rows) {
    gates_[rows] = parameters_.gate_probability > 0.0 ? chi_square_limit(rows, parameters_.gate_probability) : 0.0;
  }
  for (std::size_t l = 0; l < tree_.links().size(); ++l) {
    std::vector<int> moved;
    for (int i = static_cast<int>(l); i >= 0; i = tree_.links()[static_cast<std::size_t>(i)].parent) {
      const TreeLink& link = tree_.links()[static_cast<std::size_t>(i)];
      if (link.parent < 0 || link.p_PL.isZero()) {
        continue;
      }
      const TreeLink& parent = tree_.links()[static_cast<std::size_t>(link.parent)];
      if (layout_.bone_scale[static_cast<std::size_t>(parent.segment)] >= 0) {
        moved.push_back(i);
      }
    }
    bone_links_.push_back(std::move(moved));
  }
  const std::size_t boards = model_.boards.size();
  state_.joints = tree_.rest();
  state_.gyroscope_bias.assign(boards, Vector3d::Zero());
  state_.accelerometer_bias = state_.mount_place = state_.tissue_angle = state_.tissue_gain = state_.gyroscope_bias;
  state_.mount_rotation.assign(boards, Quaterniond::Identity());
  state_.source_place.assign(model_.sources.size(), Vector3d::Zero());
  state_.range_offset.assign(model_.sources.size(), 0.0);
  state_.bone_scale.assign(model_.skeleton.segments.size(), 0.0);
}

void BodyFilter::start(double time_s, const RootReading* root) {
  state_.time_s = next_prior_s_ = time_s;
  const BodyFilterParameters& p = parameters_;
  const int n = layout_.dofs;
  const auto square = [](double x) { return x * x; };
  std::vector<int> freedom(model_.skeleton.segments.size(), 0);
  for (const TreeLink& link : tree_.links()) {
    freedom[static_cast<std::size_t>(link.segment)] += link.kind == body::LinkKind::kTranslation ? 0 : link.count;
  }
  for (const TreeLink& link : tree_.links()) {
    for (int i = link.first; i < link.first + link.count; ++i) {
      P_.set_variance(i, square(p.rest_pose) / std::max(1, freedom[static_cast<std::size_t>(link.segment)]));
    }
  }
  for (int i = 0; i < n; ++i) {
    P_.set_variance(n + i, square(p.start_rate));
    P_.set_variance(2 * n + i, square(p.start_acceleration));
  }
  if (tree_.root_motion() == body::RootMotion::kFree) {
    const body::Segment& segment = model_.skeleton.segments.front();
    tree_.set_root(state_.joints, root != nullptr ? root->R_WL : segment.R_PL_rest,
                   root != nullptr ? root->p_W : segment.p_PL);
    for (int i = 0; i < 3; ++i) {
      P_.set_variance(i, square(root != nullptr ? 0.01 : 0.001));
      P_.set_variance(3 + i, square(root != nullptr ? 0.02 : p.rest_pose / std::sqrt(3.0)));
      P_.set_variance(n + i, square(0.2 + (root != nullptr ? 1.0 : 0.0)));
      P_.set_variance(n + 3 + i, square(p.start_rate + (root != nullptr ? 1.0 : 0.0)));
    }
  }
  const auto constants = [&](const std::vector<int>& first, int count, double sigma) {
    for (const int f : first) {
      for (int i = 0; f >= 0 && i < count; ++i) {
        P_.set_variance(f + i, sigma * sigma);
      }
    }
  };
  constants(layout_.gyroscope_bias, 3, p.gyroscope_bias);
  constants(layout_.accelerometer_bias, 3, p.accelerometer_bias);
  constants(layout_.mount_rotation, 3, p.mount_rotation);
  constants(layout_.mount_place, 3, p.mount_place);
  constants(layout_.tissue_angle, 3, p.tissue_angle);
  constants(layout_.tissue_gain, 3, tissue_gain_sigma());
  constants(layout_.source_place, 3, p.source_place);
  constants(layout_.range_offset, 1, p.range_offset);
  constants(layout_.bone_scale, 1, p.bone_scale);
  constants({layout_.sound_scale}, 1, p.sound_scale);
}

void BodyFilter::step(const BodyInstant& instant, const RootReading* root, StepRecord* record, const BodyState* about) {
  if (record != nullptr) {
    record->predict = {};
    // Their memory is used again.
    std::move(record->updates.begin(), record->updates.end(), std::back_inserter(spare_records_));
    record->updates.clear();
  }
  const double dt = instant.time_s - state_.time_s;
  if (dt > 0.0) {
    predict(dt, record != nullptr ? &record->predict : nullptr);
  }
  correction_.setZero();
  corrected_ = about != nullptr;
  if (about != nullptr) {
    // The prediction becomes a correction of what is linearised about.
    correction_ = difference(*about, state_);
    const double time_s = state_.time_s;
    state_ = *about;
    state_.time_s = time_s;
  }
  kinematics_.update(state_.joints, place_scale());
  if (root != nullptr) {
    add_root(*root);
  }
  for (std::size_t i = 0; i < instant.inertials; ++i) {
    add_inertial(instant.inertial[i]);
    flush_full(record);
  }
  for (std::size_t i = 0; i < instant.range_count; ++i) {
    add_range(instant.ranges[i]);
    flush_full(record);
  }
  if (instant.time_s >= next_prior_s_) {
    add_priors();
    add_limits();
    next_prior_s_ = instant.time_s + 0.1 - 1e-9;
  }
  flush(record);
  inject(state_, correction_);
}

UpdateRecord& BodyFilter::add_record(std::vector<UpdateRecord>& records) {
  if (spare_records_.empty()) {
    return records.emplace_back();
  }
  UpdateRecord& record = records.emplace_back(std::move(spare_records_.back()));
  spare_records_.pop_back();
  record.e.clear();
  record.groups.clear();
  return record;
}

MeasurementGroup& BodyFilter::group(int rows, int tag) {
  if (used_groups_ == groups_.size()) {
    groups_.emplace_back();
  }
  MeasurementGroup& g = groups_[used_groups_++];
  g.rows = rows;
  g.support.clear();
  g.H.clear();
  g.gate = gates_[rows];
  g.softened = false;
  g.tag = tag;
  pending_rows_ += rows;
  return g;
}

void BodyFilter::flush_full(StepRecord* record) {
  if (pending_rows_ >= kChunkRows) {
    flush(record);
    corrected_ = true;
  }
}

void BodyFilter::flush(StepRecord* record) {
  if (used_groups_ == 0) {
    return;
  }
  MeasurementGroup* first = groups_.data();
  MeasurementGroup* last = first + used_groups_;
  for (const MeasurementGroup* g = first; g != last; ++g) {
    for (int r = 0; r < g->rows; ++r) {
      cost_ += g->innovation[r] * g->innovation[r] / g->variance[r];
    }
  }
  // Earlier updates of this instant have moved the state; everything is linearised where it was before.
  for (MeasurementGroup* g = first; corrected_ && g != last; ++g) {
    for (std::size_t s = 0; s < g->support.size(); ++s) {
      for (int r = 0; r < g->rows; ++r) {
        g->innovation[r] -=
            g->H[s * static_cast<std::size_t>(g->rows) + static_cast<std::size_t>(r)] * correction_[g->support[s]];
      }
    }
  }
  if (record != nullptr && record->linearised != nullptr) {
    record->linearised->emplace_back(first, last);
  }
  UpdateRecord* update = nullptr;
  if (record != nullptr) {
    update = &add_record(record->updates);
  }
  log_likelihood_ += P_.update(first, last, correction_, update);
  if (update != nullptr && update->e.empty()) {
    record->updates.pop_back();  // nothing was accepted
  }
  for (const MeasurementGroup* g = first; g != last; ++g) {
    count(*g);
  }
  used_groups_ = 0;
  pending_rows_ = 0;
}

void BodyFilter::update(std::vector<MeasurementGroup>& groups, std::vector<UpdateRecord>* records) {
  correction_.setZero();
  UpdateRecord* record = records != nullptr ? &add_record(*records) : nullptr;
  P_.update(groups.data(), groups.data() + groups.size(), correction_, record);
  if (record != nullptr && record->e.empty()) {
    records->pop_back();  // nothing was accepted
  }
  inject(state_, correction_);
}

}  // namespace limbwave::estimate
