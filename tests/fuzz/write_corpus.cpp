// Writes small files for the fuzz targets to start from. Usage: fuzz_corpus FOLDER
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "interchange/bvh_writer.h"
#include "interchange/fbx_writer.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_file.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"

namespace {

namespace fs = std::filesystem;
using namespace limbwave;

void must(const Status& status) {
  if (!status) {
    std::fprintf(stderr, "fuzz_corpus: %s\n", status.error().text().c_str());
    std::exit(1);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_corpus FOLDER\n");
    return 2;
  }
  const fs::path folder = argv[1];
  for (const char* format : {"bvh", "fbx", "gltf"}) {
    fs::create_directories(folder / format);
  }
  for (unsigned n = 0; n < 4; ++n) {
    motion::Clip clip = test::random_clip(1 + 2 * n, 1 + 3 * n, 60.0, n);
    if (n % 2 == 1) {
      clip.meshes = {test::tetrahedra(clip, n)};
    }
    if (n == 3) {
      clip.joints[1].rotation.interpolation = motion::Interpolation::kCubic;
      clip.root_position.interpolation = motion::Interpolation::kStep;
    }
    const std::string name = "small" + std::to_string(n);
    must(interchange::write_bvh(clip, folder / "bvh" / (name + ".bvh")));
    interchange::FbxWriteOptions options;
    options.keys = n == 3 ? interchange::FbxKeyMode::kOwn : interchange::FbxKeyMode::kDense;
    must(interchange::write_fbx(clip, folder / "fbx" / (name + ".fbx"), options));
    motion::Clip solve = clip;  // solves have no meshes
    solve.meshes.clear();
    must(interchange::write_glb(solve, folder / "gltf" / (name + ".glb")));
    const motion::Clip* const clips[] = {&clip};
    must(interchange::write_gltf(clips, folder / "gltf" / (name + "-file.glb")));
    must(interchange::write_gltf(clips, folder / "gltf" / (name + "-file.gltf")));
  }
  return 0;
}
