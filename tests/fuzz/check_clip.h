/// What must hold of every clip that a reader accepts, whatever the file.
#pragma once

#include <cstdio>
#include <cstdlib>

#include "base/result.h"
#include "motion/clip.h"

namespace limbwave::test {

inline void demand(bool truth, const char* what) {
  if (!truth) {
    std::fprintf(stderr, "fuzz: %s\n", what);
    std::abort();
  }
}

inline void check_clip(const motion::Clip& clip) {
  const auto& segments = clip.skeleton.segments;
  demand(!segments.empty() && segments.front().parent < 0, "no root");
  demand(clip.joints.size() == segments.size(), "joints and segments differ in number");
  demand(clip.frame_rate_hz > 0.0 && clip.frame_rate_hz < 1e9, "frame rate");
  for (std::size_t i = 1; i < segments.size(); ++i) {
    demand(segments[i].parent >= 0 && segments[i].parent < static_cast<int>(i), "parents before children");
  }
  for (const auto& mesh : clip.meshes) {
    demand(motion::validate(*mesh, clip.skeleton).ok(), "mesh");
  }
  for (const double time_s : {0.0, 0.01, clip.duration()}) {
    for (const body::SegmentPose& pose : motion::pose_at(clip, time_s)) {
      demand(pose.p_WL.allFinite() && pose.R_WL.coeffs().allFinite(), "a pose that is no number");
    }
  }
}

/// Errors are one line that says where.
inline void check_error(const Error& error) {
  demand(!error.message.empty() && !error.place.empty(), "an error without message or place");
  demand(error.text().find('\n') == std::string::npos, "an error of several lines");
}

}  // namespace limbwave::test
