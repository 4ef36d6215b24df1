// Writes FBX files into a folder, and beside each what a reader must find in it: FILE.json with the frame rate, the
// duration, the joints' names and rest positions, and joint and vertex positions at keys and half-way between them.
// Positions are in Blender's world: metres, z up, figures face −y. Usage: interop_fbx_samples FOLDER
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "interchange/bvh_reader.h"
#include "interchange/fbx_writer.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"

namespace {

namespace fs = std::filesystem;
namespace ic = limbwave::interchange;
using limbwave::Status;
using limbwave::motion::Clip;
using nlohmann::json;

// Differences that readers may have, metres.
constexpr double kAtKeys = 1e-5;
constexpr double kHalfway = 1e-2;
constexpr std::size_t kMostTimes = 60;
constexpr std::size_t kMostMeshTimes = 4;

void must(const Status& status) {
  if (!status) {
    std::fprintf(stderr, "interop_fbx_samples: %s\n", status.error().text().c_str());
    std::exit(1);
  }
}

json to_json(const Eigen::Vector3d& p) {
  return {p.y(), -p.x(), p.z()};
}

json heads(const std::vector<limbwave::body::SegmentPose>& poses) {
  json list = json::array();
  for (const auto& pose : poses) {
    list.push_back(to_json(pose.p_WL));
  }
  return list;
}

// What must be found of one clip.
json expectation(const Clip& clip, const ic::FbxWriteOptions& options, bool halfway) {
  const double fps = options.fps > 0.0 ? options.fps : clip.frame_rate_hz;
  const std::size_t frames = limbwave::motion::frame_count(clip.duration(), fps);
  json expected = {{"fps", fps},
                   {"duration_s", static_cast<double>(frames - 1) / fps},
                   {"name", clip.name},
                   {"rest", heads(limbwave::motion::rest_poses(clip.skeleton))},
                   {"armatures", 1},
                   {"joints", json::array()},
                   {"samples", json::array()},
                   {"meshes", json::array()}};
  for (const auto& segment : clip.skeleton.segments) {
    expected["joints"].push_back(segment.name);
  }
  const std::size_t step = 1 + frames / kMostTimes;
  const auto sample = [&](double time_s, double bar) {
    const auto poses = limbwave::motion::pose_at(clip, time_s);
    json entry = {{"time_s", time_s}, {"bar_m", bar}, {"heads", heads(poses)}};
    if (expected["samples"].size() < kMostMeshTimes && !clip.meshes.empty()) {
      for (const Eigen::Vector3f& p : limbwave::motion::deformed(*clip.meshes.front(), clip.skeleton, poses)) {
        entry["vertices"].push_back(to_json(p.cast<double>()));
      }
    }
    expected["samples"].push_back(std::move(entry));
  };
  for (std::size_t frame = 0; frame < frames; frame += step) {
    sample(static_cast<double>(frame) / fps, kAtKeys);
    if (halfway && frame + 1 < frames) {
      sample((static_cast<double>(frame) + 0.5) / fps, kHalfway);
    }
  }
  return expected;
}

void write(const Clip& clip, const fs::path& path, const ic::FbxWriteOptions& options, bool halfway) {
  must(ic::write_fbx(clip, path, options));
  const json expected = expectation(clip, options, halfway);
  must(limbwave::write_file(fs::path(path).replace_extension(".json"), expected.dump()));
}

// Two actors with the same names; those of the second are made unique.
void write_two(const Clip& first, Clip second, const fs::path& path) {
  const Clip* const clips[] = {&first, &second};
  must(ic::write_fbx(clips, path));
  for (auto& segment : second.skeleton.segments) {
    segment.name += "_2";
  }
  json expected = expectation(first, {}, false);
  const json other = expectation(second, {}, false);
  expected["armatures"] = 2;
  const auto add = [](json& list, const json& more) { list.insert(list.end(), more.begin(), more.end()); };
  add(expected["joints"], other["joints"]);
  add(expected["rest"], other["rest"]);
  for (std::size_t i = 0; i < expected["samples"].size(); ++i) {
    add(expected["samples"][i]["heads"], other["samples"][i]["heads"]);
  }
  must(limbwave::write_file(fs::path(path).replace_extension(".json"), expected.dump()));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: interop_fbx_samples FOLDER\n");
    return 2;
  }
  const fs::path folder = argv[1];
  fs::remove_all(folder);
  fs::create_directories(folder);

  // Blender makes bones at least 0.01 file units long and turns such a short one by up to a milliradian: joints that
  // coincide come right in metres only.
  Clip coinciding = limbwave::test::random_clip(22, 120, 60.0, 65);
  ic::FbxWriteOptions in_metres;
  in_metres.metres_per_unit = 1.0;
  write(coinciding, folder / "coinciding_joints.fbx", in_metres, false);

  Clip clip = limbwave::test::random_clip(22, 240, 60.0, 61);
  for (std::size_t i = 1; i < clip.skeleton.segments.size(); ++i) {
    if (clip.skeleton.segments[i].p_PL.norm() < 0.05) {
      clip.skeleton.segments[i].p_PL += Eigen::Vector3d(0.1, 0.05, -0.07);
    }
  }
  clip.name = "Tanz über Kanten";
  clip.skeleton.segments[3].name = "linke Hüfte";
  clip.skeleton.segments[7].name = "右手";
  clip.meshes = {limbwave::test::tetrahedra(clip, 62)};
  write(clip, folder / "random.fbx", {}, false);

  ic::FbxWriteOptions options;
  options.up = ic::FbxUpAxis::kZ;
  write(clip, folder / "z_up.fbx", options, false);
  Clip bones = clip;
  bones.meshes.clear();
  write(bones, folder / "bones_only.fbx", {}, false);
  write_two(limbwave::test::random_clip(3, 60, 60.0, 66), limbwave::test::random_clip(3, 60, 60.0, 67),
            folder / "two_actors.fbx");
  write(limbwave::test::random_clip(2, 1, 60.0, 63), folder / "one_key.fbx", {}, false);

  const char* data = std::getenv("LIMBWAVE_DATA");
  for (const char* name : {"01_08", "02_03", "12_01_walk"}) {
    const fs::path original = fs::path(data != nullptr ? data : "") / "motions" / (std::string(name) + ".bvh");
    if (data == nullptr || !fs::exists(original)) {
      std::printf("skipped %s: set LIMBWAVE_DATA\n", name);
      continue;
    }
    ic::BvhReadOptions read;
    read.metres_per_unit.reset();
    const limbwave::Result<Clip> motion = ic::load_bvh(original, read);
    must(motion ? Status() : Status(motion.error()));
    Clip at_60 = limbwave::motion::resampled(*motion, 60.0);
    at_60.meshes = {limbwave::test::tetrahedra(at_60, 64)};
    write(at_60, folder / (std::string(name) + ".fbx"), {}, true);
    Clip at_ntsc = limbwave::motion::resampled(*motion, 30 / 1.001);
    write(at_ntsc, folder / (std::string(name) + "_ntsc.fbx"), {}, false);
  }
  return 0;
}
