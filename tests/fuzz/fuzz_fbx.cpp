#include <cstring>

#include "fuzz/check_clip.h"
#include "fuzz/fbx_mutator.h"
#include "interchange/fbx_reader.h"

extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t most);

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace limbwave;
  interchange::FbxReadOptions options;
  if (size > 0 && data[size / 2] % 2 == 0) {
    options.frames = interchange::BoneFrames::kAlongBone;
  }
  const Result<std::vector<motion::Clip>> clips =
      interchange::read_fbx({reinterpret_cast<const char*>(data), size}, "fuzz.fbx", options);
  if (!clips) {
    test::check_error(clips.error());
    return 0;
  }
  for (const motion::Clip& clip : *clips) {
    test::check_clip(clip);
  }
  return 0;
}

// Mostly changes of what whole records say, sometimes of bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size, std::size_t most, unsigned seed) {
  if (seed % 5 != 0) {
    const std::string mutated = limbwave::test::FbxMutator(seed).mutated({reinterpret_cast<const char*>(data), size});
    if (!mutated.empty() && mutated.size() <= most) {
      std::memcpy(data, mutated.data(), mutated.size());
      return mutated.size();
    }
  }
  return LLVMFuzzerMutate(data, size, most);
}
