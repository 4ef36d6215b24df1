#include <fmt/format.h>

#include <filesystem>
#include <memory>

#include "commands.h"
#include "interchange/bvh_reader.h"
#include "interchange/bvh_writer.h"
#include "interchange/csv_poses.h"
#include "interchange/fbx_reader.h"
#include "interchange/fbx_writer.h"
#include "interchange/frame_rate.h"
#include "interchange/gltf_clip.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::cli {
namespace {

motion::Clip load_clip(const std::string& input, const std::string& solve, Console& console) {
  const std::filesystem::path path(input);
  const std::string extension = path.extension().string();
  if (std::filesystem::is_directory(path)) {
    const take::Take take = console.check(take::open_take(path));
    return console.check(solve::load_solve(take, solve)).clip;
  }
  if (extension == ".bvh") {
    interchange::BvhReadOptions read;
    read.metres_per_unit = std::nullopt;  // the file does not say; the skeleton's size does
    return console.check(interchange::load_bvh(path, read));
  }
  if (extension == ".glb") {
    return console.check(interchange::load_glb(path));
  }
  if (extension == ".fbx") {
    std::vector<motion::Clip> clips = console.check(interchange::load_fbx(path));
    if (clips.size() > 1) {
      console.print(fmt::format("{}: the first of {} movements is taken", input, clips.size()));
    }
    return std::move(clips.front());
  }
  console.fail(
      {"is neither a take nor an animation that can be read", input, "name a take's folder, a .bvh, a .glb or a .fbx"});
}

}  // namespace

void add_export(CLI::App& app, Console& console) {
  struct Options {
    std::string input, output, solve = "default", unit = "cm";
    double fps = 0.0;
  };
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("export", "Write a solve or clip for animation programs");
  command->add_option("INPUT", options->input, "Take, or animation (.bvh, .glb, .fbx)")->required();
  command->add_option("-o,--output", options->output, "File to write: .bvh, .csv, .glb or .fbx")->required();
  command->add_option("--solve", options->solve, "Name of the solve")->capture_default_str();
  command->add_option("--fps", options->fps, "Frames a second; 0: as the clip has them")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  command->add_option("--unit", options->unit, "Unit of lengths in BVH and FBX")
      ->check(CLI::IsMember({"cm", "m"}))
      ->capture_default_str();
  command->footer("Example: limbwave export reach.take -o reach.bvh --fps 30");
  command->callback([options, &console] {
    motion::Clip clip = load_clip(options->input, options->solve, console);
    const std::filesystem::path output(options->output);
    const std::string extension = output.extension().string();
    const double fps = interchange::exact_frame_rate(options->fps);
    if (fps > 0.0 && extension != ".fbx") {
      clip = motion::resampled(clip, fps);
    }
    if (extension == ".bvh") {
      interchange::BvhWriteOptions write;
      write.unit = options->unit == "cm" ? interchange::BvhUnit::kCentimetres : interchange::BvhUnit::kMetres;
      write.fps = fps;
      console.check(interchange::write_bvh(clip, output, write, console.progress()));
    } else if (extension == ".csv") {
      console.check(interchange::write_csv_poses(clip, output));
    } else if (extension == ".glb") {
      console.check(interchange::write_glb(clip, output));
    } else if (extension == ".fbx") {
      interchange::FbxWriteOptions write;
      write.fps = fps;
      write.metres_per_unit = options->unit == "cm" ? 0.01 : 1.0;
      console.check(interchange::write_fbx(clip, output, write, console.progress()));
    } else {
      console.fail({"has an ending that cannot be written", options->output, "use .bvh, .csv, .glb or .fbx"});
    }
    console.print(fmt::format("{}: {} joints, {:.2f} s", options->output, clip.joints.size(), clip.duration()));
  });
}

}  // namespace limbwave::cli
