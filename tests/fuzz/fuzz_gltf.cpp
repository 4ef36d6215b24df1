#include "fuzz/check_clip.h"
#include "interchange/gltf_clip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace limbwave;
  const Result<motion::Clip> clip = interchange::clip_from_glb({reinterpret_cast<const char*>(data), size}, "fuzz.glb");
  clip ? test::check_clip(*clip) : test::check_error(clip.error());
  return 0;
}
