// Writes BVH and glTF files into a folder, and beside every BVH the joint positions that a reader must find in it.
// Usage: interop_samples FOLDER
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/gltf_clip.h"
#include "interchange/random_clip.h"

namespace {

namespace fs = std::filesystem;
using limbwave::Status;
using limbwave::motion::Clip;

void must(const Status& status) {
  if (!status) {
    std::fprintf(stderr, "interop_samples: %s\n", status.error().text().c_str());
    std::exit(1);
  }
}

// Positions (metres, in Blender's world: z up, figures face −y) of all joints at every frame of `fps`, and of the ends
// of the last bones.
void write_expected(const Clip& clip, const fs::path& bvh, double fps, double metres_per_unit) {
  using nlohmann::json;
  const auto& segments = clip.skeleton.segments;
  std::vector<bool> leaf(segments.size(), true);
  for (const auto& segment : segments) {
    if (segment.parent >= 0) {
      leaf[static_cast<std::size_t>(segment.parent)] = false;
    }
  }
  json expected = {{"fps", fps}, {"metres_per_unit", metres_per_unit}};
  for (std::size_t i = 0; i < segments.size(); ++i) {
    expected["joints"].push_back(segments[i].name);
    leaf[i] = leaf[i] && segments[i].length > 1e-3;
    if (leaf[i]) {
      expected["ends"].push_back(segments[i].name);
    }
  }
  const auto to_json = [](const Eigen::Vector3d& p) { return json{p.y(), -p.x(), p.z()}; };
  const std::size_t frames = limbwave::motion::frame_count(clip.duration(), fps);
  for (std::size_t frame = 0; frame < frames; ++frame) {
    json heads;
    json tails;
    const auto poses = limbwave::motion::pose_at(clip, static_cast<double>(frame) / fps);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      heads.push_back(to_json(poses[i].p_WL));
      if (leaf[i]) {
        tails.push_back(to_json(poses[i].p_WL + poses[i].R_WL * Eigen::Vector3d(segments[i].length, 0.0, 0.0)));
      }
    }
    expected["heads"].push_back(std::move(heads));
    expected["tails"].push_back(std::move(tails));
  }
  must(limbwave::write_file(fs::path(bvh).replace_extension(".json"), expected.dump()));
}

}  // namespace

int main(int argc, char** argv) {
  namespace ic = limbwave::interchange;
  if (argc != 2) {
    std::fprintf(stderr, "usage: interop_samples FOLDER\n");
    return 2;
  }
  const fs::path folder = argv[1];
  fs::remove_all(folder);
  fs::create_directories(folder);

  const Clip centimetres = limbwave::test::random_clip(22, 240, 60.0, 41);
  must(ic::write_bvh(centimetres, folder / "centimetres_zxy.bvh"));
  write_expected(centimetres, folder / "centimetres_zxy.bvh", 60.0, 0.01);

  const Clip metres = limbwave::test::random_clip(22, 120, 30 / 1.001, 42);
  must(ic::write_bvh(metres, folder / "metres_zyx.bvh", {ic::BvhUnit::kMetres, ic::BvhRotationOrder::kZYX, 0.0}));
  write_expected(metres, folder / "metres_zyx.bvh", 30 / 1.001, 1.0);

  must(ic::write_glb(centimetres, folder / "random.glb"));
  must(ic::write_glb(limbwave::test::random_clip(1, 1, 60.0, 43), folder / "one_key.glb"));
  Clip still = limbwave::test::random_clip(4, 1, 60.0, 44);
  still.joints.assign(4, {});
  still.root_position = {};
  must(ic::write_glb(still, folder / "still.glb"));
  Clip late = limbwave::test::random_clip(3, 50, 960.0, 45);  // neighbouring frames are the same float
  for (double& time : late.root_position.times) {
    time += 18000.0;
  }
  late.joints[1].rotation.interpolation = limbwave::motion::Interpolation::kStep;
  must(ic::write_glb(late, folder / "late.glb"));

  // A file that another program wrote: there it is our reading that the other reader must agree with.
  const char* data = std::getenv("LIMBWAVE_DATA");
  for (const char* name : {"motions/02_03.bvh", "files/pybvh_bvh_test1.bvh", "files/pybvh_bvh_test2.bvh"}) {
    const fs::path original = fs::path(data != nullptr ? data : "") / name;
    if (data == nullptr || !fs::exists(original)) {
      std::printf("skipped %s: set LIMBWAVE_DATA\n", name);
      continue;
    }
    ic::BvhReadOptions options;
    options.metres_per_unit.reset();
    const limbwave::Result<Clip> clip = ic::load_bvh(original, options);
    must(clip ? Status() : Status(clip.error()));
    const fs::path copy = folder / original.filename();
    fs::copy_file(original, copy);
    options.metres_per_unit = 1.0;
    const limbwave::Result<Clip> in_units = ic::load_bvh(original, options);
    const double unit = ic::guess_metres_per_unit(in_units->skeleton);
    write_expected(*clip, copy, clip->frame_rate_hz, unit);
    const fs::path written = folder / ("written_" + original.filename().string());
    must(ic::write_bvh(*clip, written));
    write_expected(*clip, written, clip->frame_rate_hz, 0.01);
    must(ic::write_glb(*clip, fs::path(written).replace_extension(".glb")));
  }
  return 0;
}
