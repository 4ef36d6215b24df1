#include "fuzz/check_clip.h"
#include "interchange/fbx_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace limbwave;
  interchange::FbxReadOptions options;
  if (size > 0 && data[size - 1] % 2 == 0) {
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
