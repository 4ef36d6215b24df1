// Writes small files for the fuzz targets to start from. Usage: fuzz_corpus FOLDER
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "acquire/driver_box_protocol.h"
#include "base/files.h"
#include "interchange/bvh_writer.h"
#include "interchange/fbx_writer.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_file.h"
#include "interchange/random_clip.h"
#include "interchange/skinned_clip.h"
#include "simulate/word_line.h"

namespace {

namespace fs = std::filesystem;
using namespace limbwave;

void must(const Status& status) {
  if (!status) {
    std::fprintf(stderr, "fuzz_corpus: %s\n", status.error().text().c_str());
    std::exit(1);
  }
}

void must_write(const fs::path& path, std::span<const std::byte> bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fclose(file) != 0) {
    std::fprintf(stderr, "fuzz_corpus: %s cannot be written\n", path.c_str());
    std::exit(1);
  }
}

// A box that says hello and sends some blocks, one of them twice.
void write_line(const fs::path& path) {
  std::vector<std::byte> line;
  const auto add = [&](acquire::PacketKind kind, std::uint16_t number, const std::vector<std::byte>& body) {
    const auto packet = acquire::write_packet(kind, number, body);
    line.insert(line.end(), packet.begin(), packet.end());
  };
  acquire::BoxHello hello;
  hello.firmware = "small";
  add(acquire::PacketKind::kHello, 0, acquire::hello_body(hello));
  for (const std::uint16_t n : {0, 1, 3, 2, 2, 5}) {
    const acquire::BoxBlock block{4 * n, 4, 3, n == 3 ? 5U : 7U, std::vector<std::int16_t>(12, 100)};
    add(acquire::PacketKind::kBlock, n, acquire::block_body(block));
  }
  add(acquire::PacketKind::kStatus, 9, acquire::status_body({20, 7.4F, 30.0F, 0}));
  must_write(path, line);
}

// Two hundred frames as bits of a line.
void write_words(const fs::path& path) {
  simulate::WordEncoder encoder;
  std::vector<std::byte> bytes;
  for (int n = 0; n < 40; ++n) {
    const simulate::WordFrame frame = encoder.next({n, -n, 7 * n, 100, -100, 2000});
    for (std::size_t i = 0; i < frame.size(); i += 8) {
      unsigned byte = 0;
      for (std::size_t bit = 0; bit < 8; ++bit) {
        byte |= static_cast<unsigned>(frame[i + bit]) << bit;
      }
      bytes.push_back(static_cast<std::byte>(byte < 0xF0 ? byte : byte - 0x10));
    }
  }
  must_write(path, bytes);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: fuzz_corpus FOLDER\n");
    return 2;
  }
  const fs::path folder = argv[1];
  for (const char* format : {"bvh", "fbx", "gltf", "driver_box", "words"}) {
    fs::create_directories(folder / format);
  }
  write_line(folder / "driver_box" / "line");
  write_words(folder / "words" / "frames");
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
