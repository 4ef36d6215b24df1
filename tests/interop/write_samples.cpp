// Writes files of all kinds into a folder, and beside each what other programs must find in it (expected.h).
// Usage: interop_samples FOLDER
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "base/files.h"
#include "base/units.h"
#include "expected.h"
#include "interchange/bone_map.h"
#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/export_file.h"
#include "interchange/fbx_reader.h"
#include "interchange/fbx_writer.h"
#include "interchange/frame_rate.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_file.h"
#include "interchange/mesh_file.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "motion/mannequin.h"
#include "motion/skinning.h"
#include "person.h"

namespace {

namespace fs = std::filesystem;
namespace ic = limbwave::interchange;
using limbwave::motion::Clip;
using limbwave::motion::Interpolation;
using limbwave::test::Expect;
using limbwave::test::person_clip;

constexpr const char* kAll[] = {".fbx", ".glb", ".gltf", ".bvh"};
constexpr const char* kSkinned[] = {".fbx", ".glb", ".gltf"};
constexpr const char* kOneEach[] = {".fbx", ".glb", ".bvh"};

fs::path folder;  // set once at the start

void fail(const std::string& text) {
  std::fprintf(stderr, "interop_samples: %s\n", text.c_str());
  std::exit(1);
}
template <typename T>
T must(limbwave::Result<T> result) {
  if (!result) {
    fail(result.error().text());
  }
  return *std::move(result);
}
void must(const limbwave::Status& status) {
  if (!status) {
    fail(status.error().text());
  }
}

// A preset must leave joints where they are in the world: bones in their order, one more in front where it adds a root,
// one frame later where it shows the rest pose first.
void demand_same_places(const Clip& source, const Clip& arranged, bool rest_frame, const std::string& what) {
  const std::size_t more = arranged.skeleton.segments.size() - source.skeleton.segments.size();
  const double shift = rest_frame ? 1.0 / arranged.frame_rate_hz : 0.0;
  for (double t = 0.0; t <= source.duration(); t += 7.0 / arranged.frame_rate_hz) {
    const auto a = limbwave::motion::pose_at(source, t);
    const auto b = limbwave::motion::pose_at(arranged, t + shift);
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (!((a[i].p_WL - b[i + more].p_WL).norm() < 1e-9)) {
        fail(what + ": the preset moves " + source.skeleton.segments[i].name);
      }
    }
  }
}

// Writes the clips under a name, once for every ending.
void write(const std::string& name, std::span<const Clip> clips, std::span<const char* const> endings,
           const ic::ExportOptions& options, const Expect& more = {}) {
  std::vector<const Clip*> pointers;
  for (const Clip& clip : clips) {
    pointers.push_back(&clip);
  }
  for (const char* ending : endings) {
    const fs::path file = folder / (name + ending);
    (void)must(ic::export_file(pointers, file, options));
    ic::ExportReport report;
    const std::vector<Clip> meant = must(ic::prepared(pointers, must(ic::format_of(file)), options, report));
    Expect how = more;
    how.fps = report.fps;
    how.bvh = std::string_view(ending) == ".bvh";
    how.gltf = !how.bvh && std::string_view(ending) != ".fbx";
    if (how.bvh) {
      how.at_keys_m = limbwave::test::kAtBvhKeys;
      how.reduced = false;
      how.metres_per_unit = options.unit.value_or(options.preset.bvh_unit) == ic::FileUnit::kMetres ? 1.0 : 0.01;
    }
    limbwave::test::expect(file, meant, how);
    if (options.fps <= 0.0 && options.key_tolerance_rad <= 0.0) {
      for (std::size_t c = 0; c < clips.size(); ++c) {
        demand_same_places(clips[c], meant[c], options.preset.rest_frame, file.filename().string());
      }
    }
  }
}
void write(const std::string& name, const Clip& clip, std::span<const char* const> endings,
           const ic::ExportOptions& options = {}, const Expect& more = {}) {
  write(name, {&clip, 1}, endings, options, more);
}

ic::ExportOptions with_preset(const std::string& name) {
  ic::ExportOptions options;
  options.preset = must(ic::load_preset(name));
  return options;
}

void presets() {
  const Clip person = person_clip(90, 60.0, 61);
  for (const std::string& name : ic::preset_names()) {
    write("preset_" + name, person, kAll, with_preset(name));
  }
  constexpr const char* kVrm[] = {".vrm"};
  write("preset_vrm", person, kVrm, with_preset("vrm"));
}

void rates() {
  for (const double fps : {23.976, 24.0, 25.0, 29.97, 30.0, 48.0, 50.0, 59.94, 60.0, 73.5, 100.0, 120.0}) {
    const Clip clip = limbwave::test::random_clip(3, 241, 240.0, 62);
    ic::ExportOptions options;
    options.fps = fps;
    char name[32];
    std::snprintf(name, sizeof name, "rate_%g", fps);
    write(name, clip, kOneEach, options);
  }
}

// A mesh of somebody else, skinned without help: the mannequin of the person as an OBJ file.
std::shared_ptr<const limbwave::motion::SkinnedMesh> own_mesh(const Clip& clip) {
  const auto figure = limbwave::motion::mannequin(clip.skeleton);
  std::string text;
  for (const Eigen::Vector3f& p : figure->positions) {
    text += "v " + std::to_string(p.y()) + " " + std::to_string(p.z()) + " " + std::to_string(p.x()) + "\n";
  }
  for (const auto& [a, b, c] : figure->triangles) {
    text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  }
  const fs::path file = folder / "own_mesh.obj";
  must(limbwave::write_file(file, text));
  const auto bind = limbwave::motion::rest_poses(clip.skeleton);
  const auto mesh = limbwave::motion::fitted(must(ic::load_mesh(file)), bind);
  auto skinned = must(limbwave::motion::skinned(mesh, clip.skeleton, bind));
  skinned.name = "own mesh";
  skinned.bind_poses = bind;
  return std::make_shared<limbwave::motion::SkinnedMesh>(std::move(skinned));
}

void bodies() {
  Clip person = person_clip(30, 60.0, 63);
  // Meshes are made in a T-pose, whatever the rest pose is.
  const auto in_t_pose =
      limbwave::motion::with_rest(person, ic::t_pose(person.skeleton, ic::roles_of(person.skeleton)));
  person.meshes = {own_mesh(in_t_pose)};
  for (const std::string& name : ic::preset_names()) {
    write("own_mesh_" + name, person, kSkinned, with_preset(name));
  }
  person.meshes = {own_mesh(person)};
  write("own_mesh_at_rest", person, kSkinned);
  person.meshes = {limbwave::test::tetrahedra(person, 64), limbwave::test::tetrahedra(person, 65)};
  write("two_meshes", person, kSkinned, with_preset("maya"));
  ic::ExportOptions bare;
  bare.mesh = false;
  write("bones_only", person, kOneEach, bare);
  Clip longer = person_clip(45, 60.0, 66);
  longer.root_position.values[0] += Eigen::Vector3d(1, 1, 0);
  const Clip two[] = {person_clip(30, 60.0, 67), longer};
  write("two_actors", two, kSkinned, {});
  write("two_actors_unreal", two, kSkinned, with_preset("unreal"));
}

void odd() {
  write("one_frame", person_clip(1, 60.0, 68), kAll);
  write("one_frame_maya", person_clip(1, 60.0, 68), kAll, with_preset("maya"));

  Clip names = limbwave::test::random_clip(6, 20, 60.0, 69);
  names.name = "Tanz über 2 Kanten";
  const char* const called[] = {"Hüfte", "linker Arm", "右手", "linker Arm", "linker Arm", "mannequin"};
  for (std::size_t i = 0; i < 6; ++i) {
    names.skeleton.segments[i].name = called[i];
  }
  write("names", names, kAll);

  // Joints that coincide, bones without length.
  const Clip coinciding = limbwave::test::random_clip(22, 60, 60.0, 70);
  write("coinciding", coinciding, kAll);
  write("coinciding_blender", coinciding, kAll, with_preset("blender"));

  Clip sliding = person_clip(40, 60.0, 71);
  for (std::size_t joint : {2U, 8U}) {
    auto& track = sliding.joints[joint].position;
    for (std::size_t f = 0; f < 40; ++f) {
      track.times.push_back(static_cast<double>(f) / 60.0);
      track.values.push_back(sliding.skeleton.segments[joint].p_PL +
                             0.05 * Eigen::Vector3d(std::sin(0.3 * static_cast<double>(f)), 0.2, 0.0));
    }
    track.interpolation = joint == 8 ? Interpolation::kStep : Interpolation::kLinear;
  }
  write("sliding", sliding, kAll);
  write("sliding_blender", sliding, kAll, with_preset("blender"));

  Clip keyed = person_clip(1, 30.0, 72);
  for (std::size_t i = 0; i < keyed.joints.size(); ++i) {
    auto& track = keyed.joints[i].rotation;
    const Eigen::Quaterniond rest = keyed.skeleton.segments[i].R_PL_rest;
    track = {{0.0, 0.5, 1.0, 2.0}, {}, i % 3 == 0 ? Interpolation::kStep : Interpolation::kCubic};
    for (int k = 0; k < 4; ++k) {
      track.values.push_back(rest * limbwave::geometry::exp_so3({0.3 * k, 0.2 * std::sin(k + double(i)), -0.1 * k}));
    }
    if (i % 3 == 1) {
      track.key_interpolation = {Interpolation::kCubic, Interpolation::kLinear, Interpolation::kStep,
                                 Interpolation::kLinear};
    }
  }
  keyed.root_position = {{0.0, 1.0, 2.0}, {{0, 0, 1}, {1, 0, 1.2}, {1, 1, 1}}, Interpolation::kCubic};
  Expect sparse;
  sparse.reduced = true;
  write("keyed", keyed, kAll, {}, sparse);

  Clip still = person_clip(1, 60.0, 73);
  still.joints.assign(still.joints.size(), {});
  still.root_position = {};
  write("still", still, kSkinned);
}

// A take's own clips, which say more than glTF does.
void own_clips() {
  must(ic::write_glb(limbwave::test::random_clip(22, 100, 60.0, 41), folder / "take_random.glb"));
  must(ic::write_glb(limbwave::test::random_clip(1, 1, 60.0, 43), folder / "take_one_key.glb"));
  Clip still = limbwave::test::random_clip(4, 1, 60.0, 44);
  still.joints.assign(4, {});
  still.root_position = {};
  must(ic::write_glb(still, folder / "take_still.glb"));
  Clip late = limbwave::test::random_clip(3, 50, 960.0, 45);  // neighbouring frames are the same float
  for (double& time : late.root_position.times) {
    time += 18000.0;
  }
  late.joints[1].rotation.interpolation = Interpolation::kStep;
  must(ic::write_glb(late, folder / "take_late.glb"));
}

// How far a recording at a higher rate is from the movement at 60 frames a second half-way between its frames, metres.
// Straight lines cut corners whatever the file; this says by how much.
void print_cut_corners(const std::string& name, const Clip& recording, const Clip& written) {
  std::vector<double> off;
  for (double t = 0.5 / 60.0; t <= written.duration(); t += 1.0 / 60.0) {
    const auto a = limbwave::motion::pose_at(recording, t);
    const auto b = limbwave::motion::pose_at(written, t);
    for (std::size_t i = 0; i < a.size(); ++i) {
      off.push_back((a[i].p_WL - b[i].p_WL).norm());
    }
  }
  std::ranges::sort(off);
  std::printf(
      "%s: half-way between frames the recording is off by %.2f mm (median), %.1f mm (99.9 %%), %.1f mm (most)\n",
      name.c_str(), 1e3 * off[off.size() / 2], 1e3 * off[off.size() * 999 / 1000], 1e3 * off.back());
}

// Recordings of people at 60 frames a second, looked at half-way between frames too.
void motions(const fs::path& data) {
  int count = 0;
  std::vector<fs::path> files;
  for (const char* part : {"motions", "pairs"}) {
    for (const auto& entry : fs::directory_iterator(data / part)) {
      files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  for (const fs::path& path : files) {
    ic::BvhReadOptions read;
    read.metres_per_unit.reset();
    read.skip_frames = 10;  // an artificial T-pose
    const Clip whole = must(ic::load_bvh(path, read));
    const Clip clip = limbwave::motion::trimmed(whole, 0.0, std::min(whole.duration(), 6.0));
    ic::ExportOptions options;
    options.fps = 60.0;
    Expect how;
    how.halfway = true;
    how.most_times = 60;
    const std::string name = "motion_" + path.stem().string();
    print_cut_corners(name, clip, limbwave::motion::resampled(clip, 60.0));
    write(name, clip, kOneEach, options, how);
    options = with_preset(count % 2 == 0 ? "blender" : "unity");
    options.fps = 60.0;
    write(name + "_" + options.preset.name, clip, kOneEach, options, how);
    options.key_tolerance_rad = limbwave::radians(0.5);
    how.halfway = false;
    how.reduced = true;
    write(name + "_reduced", clip, kSkinned, options, how);
    ++count;
  }
  if (count < 2) {
    fail("no motions in " + data.string());
  }
}

// Files of other programs: what we read in them must be what other readers find there.
void foreign(const fs::path& data) {
  const auto expect_read = [&](const fs::path& original, std::vector<Clip> clips, Expect how) {
    const fs::path copy = folder / ("foreign_" + original.filename().string());
    fs::copy_file(original, copy);
    how.fps = clips.front().frame_rate_hz;
    how.keep_names = true;
    for (Clip& clip : clips) {
      clip.meshes.clear();
    }
    limbwave::test::expect(copy, {clips.data(), 1}, how);
  };
  for (const char* name : {"motions/02_03.bvh", "files/pybvh_bvh_test1.bvh", "files/pybvh_bvh_test2.bvh"}) {
    ic::BvhReadOptions read;
    read.metres_per_unit = 1.0;
    const double unit = ic::guess_metres_per_unit(must(ic::load_bvh(data / name, read)).skeleton);
    read.metres_per_unit.reset();
    expect_read(data / name, {must(ic::load_bvh(data / name, read))},
                {.bvh = true, .metres_per_unit = unit, .at_keys_m = limbwave::test::kAtBvhKeys});
  }
  const fs::path fbx = data / "files/ufbx_maya_human_ik_7400_binary.fbx";
  expect_read(fbx, must(ic::load_fbx(fbx)), {});
  const fs::path gltf = data / "files/simple_skin.gltf";
  expect_read(gltf, must(ic::load_gltf(gltf)), {.reduced = true});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: interop_samples FOLDER\n");
    return 2;
  }
  folder = argv[1];
  fs::remove_all(folder);
  fs::create_directories(folder);
  presets();
  rates();
  bodies();
  odd();
  own_clips();
  const char* data = std::getenv("LIMBWAVE_DATA");
  if (data == nullptr || !fs::exists(fs::path(data) / "motions")) {
    std::printf("skipped real motions and other programs' files: set LIMBWAVE_DATA\n");
    return 0;
  }
  motions(data);
  foreign(data);
  return 0;
}
