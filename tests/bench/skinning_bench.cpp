// How long bone heat takes on meshes of twenty thousand vertices and 25 bones: a person of capsules whose surface is
// one piece, and a nasty mesh of many pieces with holes, open ends, doubled vertices and slivers.
#include <benchmark/benchmark.h>

#include "motion/meshes.h"
#include "motion/skinning.h"

namespace {

using namespace limbwave;

void skin(benchmark::State& state, const motion::TriangleMesh& mesh) {
  const body::Skeleton skeleton = test::person_of_25();
  const std::vector<body::SegmentPose> rest = motion::rest_poses(skeleton);
  std::size_t reports = 0;
  const Progress progress([&](double /*part*/, std::string_view /*what*/) {
    ++reports;
    return true;
  });
  for (auto _ : state) {
    reports = 0;
    const auto result = motion::skinned(mesh, skeleton, rest, {}, progress);
    if (!result) {
      state.SkipWithError(result.error().text().c_str());
      break;
    }
    benchmark::DoNotOptimize(result->weights.data());
  }
  state.counters["vertices"] = static_cast<double>(mesh.positions.size());
  state.counters["reports"] = static_cast<double>(reports);
}

void BM_SkinPerson(benchmark::State& state) {
  skin(state, test::person_mesh(20000));
}
void BM_SkinNastyMesh(benchmark::State& state) {
  skin(state, test::nasty_mesh(20000));
}
BENCHMARK(BM_SkinPerson)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SkinNastyMesh)->Unit(benchmark::kMillisecond);

}  // namespace
