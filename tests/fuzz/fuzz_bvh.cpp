#include "fuzz/check_clip.h"
#include "interchange/bvh_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace limbwave;
  interchange::BvhReadOptions options;
  if (size > 0 && data[size - 1] % 2 == 0) {
    options.metres_per_unit.reset();
    options.frames = interchange::BoneFrames::kFile;
  }
  const Result<motion::Clip> clip =
      interchange::read_bvh({reinterpret_cast<const char*>(data), size}, "fuzz.bvh", options);
  clip ? test::check_clip(*clip) : test::check_error(clip.error());
  return 0;
}
