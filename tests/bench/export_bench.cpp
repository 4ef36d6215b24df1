// Whether writing keeps pace with reading: ten minutes of a person of 22 joints at 120 Hz to FBX and glb, and Assimp
// reading the same files, in one run.
#include <benchmark/benchmark.h>
#include <malloc.h>

#include <assimp/Importer.hpp>
#include <filesystem>

#include "interchange/fbx_reader.h"
#include "interchange/fbx_writer.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_file.h"
#include "interchange/random_clip.h"
#include "support/temporary_folder.h"

namespace {

using namespace limbwave;

// Captured motion is smooth: no jumps into gimbal lock, turns of up to a few hundred degrees a second.
const motion::Clip& ten_minutes() {
  static const motion::Clip clip = [] {
    motion::Clip made = test::random_clip(22, 1, 120.0, 52);
    constexpr std::size_t kFrames = 600 * 120 + 1;
    for (std::size_t i = 0; i < made.joints.size(); ++i) {
      motion::RotationTrack& track = made.joints[i].rotation;
      const Eigen::Quaterniond rest = made.skeleton.segments[i].R_PL_rest;
      track = {};
      for (std::size_t f = 0; f < kFrames; ++f) {
        const double t = static_cast<double>(f) / 120.0;
        const double s = static_cast<double>(i);
        track.times.push_back(t);
        track.values.push_back(rest * geometry::exp_so3({std::sin(2.1 * t + s), 0.7 * std::sin(1.3 * t + 2.0 * s),
                                                         0.5 * std::cos(3.7 * t + s)}));
      }
    }
    made.root_position = {};
    for (std::size_t f = 0; f < kFrames; ++f) {
      const double t = static_cast<double>(f) / 120.0;
      made.root_position.times.push_back(t);
      made.root_position.values.emplace_back(std::cos(0.3 * t), std::sin(0.3 * t), 1.0 + 0.05 * std::sin(6.0 * t));
    }
    return made;
  }();
  return clip;
}

std::filesystem::path file(const char* name) {
  static const test::TemporaryFolder folder;
  return folder.path() / name;
}

// Every round starts as a program does that opens or saves one file: without the memory of the rounds before, whose
// pages a reader would find ready.
void start_fresh(benchmark::State& state) {
  state.PauseTiming();
  ::malloc_trim(0);
  state.ResumeTiming();
}

template <typename Write>
void write(benchmark::State& state, const char* name, const Write& write_file) {
  for (auto _ : state) {
    start_fresh(state);
    if (const Status status = write_file(ten_minutes(), file(name)); !status) {
      state.SkipWithError(status.error().text().c_str());
    }
  }
  state.counters["MB"] = static_cast<double>(std::filesystem::file_size(file(name))) * 1e-6;
}

void BM_WriteFbx(benchmark::State& state) {
  write(state, "ten.fbx",
        [](const motion::Clip& clip, const std::filesystem::path& path) { return interchange::write_fbx(clip, path); });
}
void BM_WriteGlb(benchmark::State& state) {
  write(state, "ten.glb", [](const motion::Clip& clip, const std::filesystem::path& path) {
    const motion::Clip* const clips[] = {&clip};
    return interchange::write_gltf(clips, path);
  });
}
// The form in which takes keep solves: with all keys in double precision as well.
void BM_WriteSolve(benchmark::State& state) {
  write(state, "solve.glb",
        [](const motion::Clip& clip, const std::filesystem::path& path) { return interchange::write_glb(clip, path); });
}

void read_with_assimp(benchmark::State& state, const char* name) {
  for (auto _ : state) {
    start_fresh(state);
    Assimp::Importer importer;
    importer.SetPropertyBool("IMPORT_FBX_PRESERVE_PIVOTS", false);
    const aiScene* scene = importer.ReadFile(file(name).string(), 0);
    if (scene == nullptr) {
      state.SkipWithError(importer.GetErrorString());
      break;
    }
    benchmark::DoNotOptimize(scene);
  }
}
void BM_AssimpReadsFbx(benchmark::State& state) {
  read_with_assimp(state, "ten.fbx");
}
void BM_AssimpReadsGlb(benchmark::State& state) {
  read_with_assimp(state, "ten.glb");
}
void BM_ReadFbx(benchmark::State& state) {
  for (auto _ : state) {
    start_fresh(state);
    benchmark::DoNotOptimize(interchange::load_fbx(file("ten.fbx")).ok());
  }
}
void BM_ReadGlb(benchmark::State& state) {
  for (auto _ : state) {
    start_fresh(state);
    benchmark::DoNotOptimize(interchange::load_gltf(file("ten.glb")).ok());
  }
}

// In this order: what is read must have been written.
BENCHMARK(BM_WriteFbx)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_AssimpReadsFbx)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReadFbx)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WriteGlb)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_AssimpReadsGlb)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ReadGlb)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WriteSolve)->Unit(benchmark::kMillisecond);

}  // namespace
