/// A walking person with boards, for tests of what stands around the body filter.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "estimate/body_smoother.h"
#include "estimate/body_watch.h"
#include "support/pose_readings.h"
#include "support/walking_person.h"

namespace limbwave::testing_support {

/// The person's skeleton with boards in the middle of segments, each named like its segment.
inline estimate::BodyModel worn_boards(const std::vector<std::string>& segments) {
  estimate::BodyModel model;
  const auto skeleton = body::load_skeleton("body");
  EXPECT_TRUE(skeleton.ok());
  model.skeleton = *skeleton;
  for (const std::string& name : segments) {
    estimate::BodyBoard board;
    board.name = name;
    board.segment = model.skeleton.find(name);
    const auto s = static_cast<std::size_t>(board.segment);
    board.R_LS = geometry::exp_so3({0.3, -0.2, 0.5});
    board.p_LS = {0.5 * model.skeleton.segments[s].length, 0.01, 0.05};
    board.gyroscope = board.accelerometer = true;
    model.boards.push_back(board);
  }
  return model;
}

/// Eight: pelvis, chest, and both legs.
inline estimate::BodyModel eight_boards() {
  return worn_boards(
      {"pelvis", "chest", "left_thigh", "left_shin", "left_foot", "right_thigh", "right_shin", "right_foot"});
}

inline estimate::BodyFilterParameters free_root() {
  estimate::BodyFilterParameters p;
  p.root = estimate::RootMode::kFree;
  return p;
}

inline bool mentions(const Diagnostics& found, const std::string& code, const std::string& text = "") {
  return std::any_of(found.begin(), found.end(), [&](const Diagnostic& d) {
    return d.code == code && (text.empty() || d.text().find(text) != std::string::npos);
  });
}

/// Mean geodesic error of the joints of `segments`, degrees, from `begin_s` on; and whether everything is finite.
inline double joint_error(const estimate::BodyTrack& track, const PosesAt& poses, const body::Skeleton& skeleton,
                          const std::vector<std::string>& segments, double begin_s = 0.0) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < track.times.size(); ++i) {
    for (const auto& R : track.R_joint[i]) {
      EXPECT_TRUE(R.coeffs().allFinite());
    }
    EXPECT_TRUE(track.root_p_W[i].allFinite());
    if (track.times[i] < begin_s) {
      continue;
    }
    const auto truth = poses(track.times[i]);
    for (const std::string& name : segments) {
      const auto s = static_cast<std::size_t>(skeleton.find(name));
      const auto parent = static_cast<std::size_t>(skeleton.segments[s].parent);
      const Eigen::Quaterniond R_true = truth[parent].R_WL.conjugate() * truth[s].R_WL;
      sum += degrees(geometry::geodesic_angle(R_true, skeleton.segments[s].R_PL_rest * track.R_joint[i][s]));
      ++count;
    }
  }
  return count == 0 ? 0.0 : sum / count;
}

inline const std::vector<std::string>& legs() {
  static const std::vector<std::string> names{"left_thigh",  "left_shin",  "left_foot",
                                              "right_thigh", "right_shin", "right_foot"};
  return names;
}

}  // namespace limbwave::testing_support
