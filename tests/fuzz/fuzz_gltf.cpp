// Both readers of glTF: files of other programs, and the clips that takes keep.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include "fuzz/check_clip.h"
#include "interchange/gltf_clip.h"
#include "interchange/gltf_file.h"

namespace {

// A binary file whose sizes are made right again: mutations that insert or delete would not get past them.
std::string with_right_sizes(std::string bytes) {
  constexpr std::size_t kHeader = 12;
  constexpr std::size_t kChunk = 8;
  const auto put = [&](std::size_t at, std::size_t value) {
    const auto word = static_cast<std::uint32_t>(value);
    std::memcpy(bytes.data() + at, &word, sizeof word);
  };
  put(8, bytes.size());
  const std::size_t bin = bytes.find(std::string("BIN\0", 4), kHeader + kChunk);
  const std::size_t json_end = bin == std::string::npos ? bytes.size() : std::max(bin - 4, kHeader + kChunk);
  put(kHeader, json_end - kHeader - kChunk);
  if (bin != std::string::npos && json_end + kChunk <= bytes.size()) {
    put(json_end, bytes.size() - json_end - kChunk);
  }
  return bytes;
}

void read_both(const std::string& bytes) {
  using namespace limbwave;
  Diagnostics findings;
  const Result<std::vector<motion::Clip>> clips = interchange::read_gltf(bytes, "fuzz.glb", {}, &findings);
  if (clips) {
    for (const motion::Clip& clip : *clips) {
      test::check_clip(clip);
    }
  } else {
    test::check_error(clips.error());
  }
  const Result<motion::Clip> clip = interchange::clip_from_glb(bytes, "fuzz.glb");
  clip ? test::check_clip(*clip) : test::check_error(clip.error());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read_both(bytes);
  if (size >= 20 && bytes.starts_with("glTF")) {
    read_both(with_right_sizes(bytes));
  }
  return 0;
}
