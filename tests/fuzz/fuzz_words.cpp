#include <cstdlib>
#include <cstring>
#include <vector>

#include "decode/inertial_words.h"

// Any samples at all, with gaps: readings stay in order and in range.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  using namespace limbwave;
  decode::InertialWordDecoder decoder({}, SampleRate{140000.0}, 0);
  double time_s = -1e9;
  std::int64_t number = -1;
  const auto check = [&] {
    for (const decode::InertialReading& reading : decoder.take_readings()) {
      if (!(reading.time.value > time_s) || reading.number <= number || !reading.w_WS_S.allFinite() ||
          !reading.f_S.allFinite() || reading.w_WS_S.cwiseAbs().maxCoeff() > 5.3) {
        std::abort();
      }
      time_s = reading.time.value;
      number = reading.number;
    }
  };
  std::vector<float> samples;
  for (std::size_t i = 0; i < size;) {
    const unsigned char what = data[i++];
    samples.clear();
    if (what == 0xFF && i < size) {
      decoder.gap(SampleCount{data[i++] * 97});
    } else if (what >= 0xF0 && i + 4 <= size) {  // raw floats, also such that are no numbers
      float value = 0.0F;
      std::memcpy(&value, data + i, 4);
      i += 4;
      samples.assign(1 + what % 16, value);
    } else {  // bits of a line, ten samples and a little long
      for (int bit = 0; bit < 8; ++bit) {
        samples.insert(samples.end(), bit % 5 == 4 ? 11 : 10, ((what >> bit) & 1) != 0 ? 0.03F : -0.03F);
      }
    }
    decoder.push(samples.data(), samples.size(), 1);
    check();
  }
  return 0;
}
