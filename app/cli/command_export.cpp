#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/units.h"
#include "commands.h"
#include "interchange/animation_file.h"
#include "interchange/bone_map.h"
#include "interchange/export_file.h"
#include "interchange/mesh_file.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::cli {
namespace {

struct Options {
  std::vector<std::string> inputs;
  std::string output, solve = "default", clip, preset = "plain", names, rest, unit, root, mesh, json;
  double fps = 0.0, from = 0.0, to = -1.0, key_tolerance_deg = 0.0;
  bool no_mesh = false, rest_frame = false, no_rest_frame = false;
};

// The movement that is wanted: by number from 1 on or by name, empty: the first.
motion::Clip choose(std::vector<motion::Clip> clips, const std::string& wanted, const std::string& input,
                    Console& console) {
  if (clips.size() > 1 && wanted.empty()) {
    console.print(fmt::format("{}: the first of {} movements is taken, \"{}\"; --clip chooses another", input,
                              clips.size(), clips.front().name));
  }
  std::vector<std::string> names;
  for (std::size_t i = 0; i < clips.size(); ++i) {
    if (wanted.empty() || wanted == clips[i].name || wanted == std::to_string(i + 1)) {
      return std::move(clips[i]);
    }
    names.push_back(fmt::format("{} \"{}\"", i + 1, clips[i].name));
  }
  console.fail(
      {fmt::format("has no movement \"{}\"", wanted), input, fmt::format("choose one of {}", fmt::join(names, ", "))});
}

motion::Clip load_clip(const std::string& input, const std::string& solve, const std::string& wanted,
                       Console& console) {
  if (std::filesystem::is_directory(input)) {
    const take::Take take = console.check(take::open_take(input));
    return console.check(solve::load_solve(take, solve)).clip;
  }
  if (!interchange::is_animation_file(input)) {
    console.fail({"is neither a take nor an animation that can be read", input,
                  "name a take's folder, a .bvh, .glb, .gltf, .vrm or .fbx"});
  }
  Diagnostics findings;
  std::vector<motion::Clip> clips = console.check(interchange::load_animation(input, &findings));
  console.print(findings);
  return choose(std::move(clips), wanted, input, console);
}

interchange::ExportOptions read_options(const Options& options, Console& console) {
  interchange::ExportOptions result;
  result.preset = console.check(interchange::load_preset(options.preset));
  if (!options.names.empty()) {
    result.preset.bone_map = options.names == "as-is" ? "" : options.names;
  }
  if (!options.rest.empty()) {
    result.preset.rest = options.rest == "t-pose" ? interchange::RestPose::kTPose : interchange::RestPose::kAsIs;
  }
  result.preset.rest_frame = result.preset.rest_frame || options.rest_frame;
  result.fps = options.fps;
  result.begin_s = options.from;
  if (options.to >= 0.0) {
    result.end_s = options.to;
  }
  if (options.root == "in-place") {
    result.root_motion = motion::RootMotion::kInPlace;
  } else if (options.root == "free") {
    result.root_motion = motion::RootMotion::kFree;
  }
  if (!options.unit.empty()) {
    result.unit = options.unit == "cm" ? interchange::FileUnit::kCentimetres : interchange::FileUnit::kMetres;
  }
  result.rest_frame = !options.no_rest_frame;
  result.key_tolerance_rad = radians(options.key_tolerance_deg);
  result.mesh = !options.no_mesh;
  return result;
}

void run(const Options& options, bool as_json, Console& console) {
  std::vector<motion::Clip> clips;
  for (const std::string& input : options.inputs) {
    clips.push_back(load_clip(input, options.solve, options.clip, console));
    if (!options.mesh.empty()) {
      clips.back().meshes = {
          console.check(interchange::skinned_mesh_file(options.mesh, clips.back(), console.progress()))};
    }
  }
  const interchange::ExportReport report = console.check(interchange::export_and_release(
      std::move(clips), options.output, read_options(options, console), console.progress()));
  if (as_json) {
    console.print_json({{"file", options.output},
                        {"bytes", report.bytes},
                        {"actors", report.actors},
                        {"bones", report.bones},
                        {"frames", report.frames},
                        {"fps", report.fps},
                        {"duration_s", report.duration_s},
                        {"keys_before", report.keys_before},
                        {"keys", report.keys_after},
                        {"worst_difference_m", report.worst_m}},
                       options.json);
    return;
  }
  console.print(fmt::format("{}: {} bones, {} frames at {:.6g} Hz, {:.2f} s; read back, joints within {:.3f} mm",
                            options.output, report.bones, report.frames, report.fps, report.duration_s,
                            1e3 * report.worst_m));
  if (report.keys_after < report.keys_before) {
    console.print(fmt::format("{} of {} keys are left", report.keys_after, report.keys_before));
  }
}

}  // namespace

void add_export(CLI::App& app, Console& console) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write solves or clips for animation programs, and check the file");
  command->add_option("INPUT", options->inputs, "Takes, or animations (.bvh, .glb, .gltf, .fbx): one an actor")
      ->required();
  command->add_option("-o,--output", options->output, "File to write: .fbx, .glb, .gltf, .vrm, .bvh or .csv")
      ->required();
  command->add_option("--solve", options->solve, "Name of the solve")->capture_default_str();
  command->add_option("--clip", options->clip,
                      "Which movement of an FBX or glTF with several: its name or number; default: the first");
  command
      ->add_option("--preset", options->preset,
                   fmt::format("Program that it is for: {}, or a file", fmt::join(interchange::preset_names(), ", ")))
      ->capture_default_str();
  command->add_option("--fps", options->fps, "Frames a second; 0: as the clip has them")
      ->check(within(0.0, 1000.0))
      ->capture_default_str();
  command->add_option("--from", options->from, "First second that is written")
      ->check(within(0.0, 1e9))
      ->capture_default_str();
  command->add_option("--to", options->to, "Last second that is written; default: the end")->check(within(0.0, 1e9));
  command->add_option("--root", options->root, "Way over the floor: free or in-place; default: as the preset has it")
      ->check(CLI::IsMember({"free", "in-place"}));
  command
      ->add_option("--key-tolerance", options->key_tolerance_deg,
                   "Leave out keys as long as no joint turns by more, degrees; 0: keep all")
      ->check(within(0.0, 45.0))
      ->capture_default_str();
  command->add_option("--unit", options->unit, "Unit of lengths in BVH and FBX: cm or m; default: as the preset has it")
      ->check(CLI::IsMember({"cm", "m"}));
  auto* mesh = command->add_option("--mesh", options->mesh, "Mesh to skin to the skeleton (.obj, .glb, .fbx)")
                   ->check(CLI::ExistingFile);
  command->add_flag("--no-mesh", options->no_mesh, "No skinned mesh, not even a mannequin")->excludes(mesh);
  command->add_option("--bone-names", options->names,
                      fmt::format("Names of the bones: as-is, {}, or a file; default: as the preset has it",
                                  fmt::join(interchange::bone_map_names(), ", ")));
  command->add_option("--rest", options->rest, "Rest pose: as-is or t-pose; default: as the preset has it")
      ->check(CLI::IsMember({"as-is", "t-pose"}));
  auto* rest_frame = command->add_flag("--rest-frame", options->rest_frame, "The rest pose on frame 0");
  command->add_flag("--no-rest-frame", options->no_rest_frame, "No rest pose on frame 0, where the preset has one")
      ->excludes(rest_frame);
  add_json_option(*command, options->json, "Write what was exported as JSON");
  command->footer("Example: limbwave export reach.take -o reach.fbx --preset unreal --fps 30");
  command->callback([options, command, &console] { run(*options, command->count("--json") > 0, console); });
}

}  // namespace limbwave::cli
