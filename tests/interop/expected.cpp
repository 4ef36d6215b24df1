#include "expected.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "base/files.h"

namespace limbwave::test {
namespace {

using nlohmann::json;

constexpr std::size_t kMostMeshTimes = 4;

json to_json(const Eigen::Vector3d& p) {
  return {p.y(), -p.x(), p.z()};
}

// Whether a bone ends in the open and has a length.
std::vector<bool> open_ends(const body::Skeleton& skeleton) {
  std::vector<bool> open;
  for (const body::Segment& segment : skeleton.segments) {
    open.push_back(segment.length > 1e-3);
    if (segment.parent >= 0) {
      open[static_cast<std::size_t>(segment.parent)] = false;
    }
  }
  return open;
}

class Builder {
 public:
  Builder(std::span<const motion::Clip> clips, const Expect& how) : clips_(clips), how_(how) {
    double duration = 0.0;
    for (const motion::Clip& clip : clips) {
      duration = std::max(duration, clip.duration());
    }
    frames_ = motion::frame_count(duration, how.fps);
    json_ = {{"fps", how.fps},
             {"duration_s", static_cast<double>(frames_ - 1) / how.fps},
             {"name", clips.front().name},
             {"actors", clips.size()},
             {"metres_per_unit", how.metres_per_unit},
             {"reduced", how.reduced},
             {"foreign", how.keep_names},
             {"rest", json::array()},
             {"rest_y", json::array()},
             {"ends", json::array()},
             {"samples", json::array()}};
    names();
    rest();
  }

  json build() {
    const std::size_t step = 1 + frames_ / how_.most_times;
    for (std::size_t frame = 0; frame < frames_; frame += step) {
      const bool all_have_keys = !how_.reduced || frame == 0 || frame + 1 == frames_;
      sample(static_cast<double>(frame) / how_.fps, all_have_keys ? how_.at_keys_m : kHalfway, true);
      if (how_.halfway && frame + 1 < frames_) {
        sample((static_cast<double>(frame) + 0.5) / how_.fps, kHalfway, false);
      }
    }
    if ((frames_ - 1) % step != 0) {
      sample(static_cast<double>(frames_ - 1) / how_.fps, how_.at_keys_m, true);
    }
    return json_;
  }

 private:
  void names() {
    std::vector<std::string> joints;
    std::vector<std::string> meshes;
    std::vector<std::string> both;
    std::vector<bool> is_mesh;
    for (const motion::Clip& clip : clips_) {
      for (const body::Segment& segment : clip.skeleton.segments) {
        joints.push_back(segment.name);
        if (how_.bvh) {
          std::ranges::replace(joints.back(), ' ', '_');
        }
        both.push_back(joints.back());
        is_mesh.push_back(false);
      }
      for (const auto& mesh : clip.meshes) {
        meshes.push_back(mesh->name);
        both.push_back(mesh->name);
        is_mesh.push_back(true);
      }
    }
    json_["joints"] = how_.keep_names ? joints : made_unique(joints);
    std::vector<std::string> all = joints;
    all.insert(all.end(), meshes.begin(), meshes.end());
    all = made_unique(all);
    json_["meshes"] = std::vector<std::string>(all.begin() + static_cast<std::ptrdiff_t>(joints.size()), all.end());
    if (how_.gltf && !how_.keep_names) {
      json_["joints"] = json_["meshes"] = json::array();
      const std::vector<std::string> unique = made_unique(both);
      for (std::size_t i = 0; i < unique.size(); ++i) {
        json_[is_mesh[i] ? "meshes" : "joints"].push_back(unique[i]);
      }
    }
  }

  void rest() {
    std::size_t first = 0;
    for (const motion::Clip& clip : clips_) {
      // A mesh that was bound in another pose brings that pose along.
      std::vector<body::SegmentPose> poses = motion::rest_poses(clip.skeleton);
      if (!clip.meshes.empty() && !clip.meshes.front()->bind_poses.empty()) {
        poses = clip.meshes.front()->bind_poses;
      }
      const Eigen::Vector3d origin = how_.bvh ? poses.front().p_WL : Eigen::Vector3d::Zero();
      const std::vector<bool> open = open_ends(clip.skeleton);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        json_["rest"].push_back(to_json(poses[i].p_WL - origin));
        // Files' own y is our bone frames' z.
        json_["rest_y"].push_back(to_json(poses[i].R_WL * Eigen::Vector3d::UnitZ()));
        if (how_.bvh && open[i]) {
          json_["ends"].push_back(json_["joints"][first + i]);
        }
      }
      first += poses.size();
    }
  }

  void sample(double time_s, double bar_m, bool at_key) {
    json entry = {{"time_s", time_s}, {"bar_m", bar_m}, {"at_key", at_key}};
    const bool vertices = mesh_times_ < kMostMeshTimes;
    mesh_times_ += vertices ? 1 : 0;
    for (const motion::Clip& clip : clips_) {
      const std::vector<body::SegmentPose> poses = motion::pose_at(clip, time_s);
      const std::vector<bool> open = open_ends(clip.skeleton);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        entry["heads"].push_back(to_json(poses[i].p_WL));
        if (how_.bvh && open[i]) {
          const Eigen::Vector3d end(clip.skeleton.segments[i].length, 0.0, 0.0);
          entry["tails"].push_back(to_json(poses[i].p_WL + poses[i].R_WL * end));
        }
      }
      for (const auto& mesh : clip.meshes) {
        if (vertices) {
          json list = json::array();
          for (const Eigen::Vector3f& p : motion::deformed(*mesh, clip.skeleton, poses)) {
            list.push_back(to_json(p.cast<double>()));
          }
          entry["vertices"].push_back(std::move(list));
        }
      }
    }
    json_["samples"].push_back(std::move(entry));
  }

  std::span<const motion::Clip> clips_;
  const Expect& how_;
  std::size_t frames_ = 0;
  std::size_t mesh_times_ = 0;
  json json_;
};

}  // namespace

std::vector<std::string> made_unique(const std::vector<std::string>& names) {
  std::map<std::string, int> seen;
  std::vector<std::string> unique;
  for (const std::string& name : names) {
    const int number = ++seen[name];
    unique.push_back(number == 1 ? name : name + "_" + std::to_string(number));
  }
  return unique;
}

void expect(const std::filesystem::path& file, std::span<const motion::Clip> clips, const Expect& how) {
  const json expected = Builder(clips, how).build();
  if (const Status status = write_file(file.string() + ".expected.json", expected.dump()); !status) {
    std::fprintf(stderr, "%s\n", status.error().text().c_str());
    std::exit(1);
  }
}

}  // namespace limbwave::test
