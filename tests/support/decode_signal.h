/// Runs the line-in decoder over a test signal.
#pragma once

#include <string>
#include <vector>

#include "decode/line_in.h"

namespace limbwave::test {

struct Decoded {
  std::vector<decode::LineInCycle> cycles;
  Diagnostics findings;
  decode::LineInStatus status;

  [[nodiscard]] bool has(const std::string& code) const {
    for (const Diagnostic& finding : findings) {
      if (finding.code == code) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] std::string texts() const {
    std::string all;
    for (const Diagnostic& finding : findings) {
      all += finding.code + ": " + finding.text() + "\n";
    }
    return all;
  }
};

inline Decoded decode_signal(const std::vector<float>& interleaved, double rate,
                             const decode::LineInParameters& parameters = {}, std::size_t block_frames = 0) {
  decode::LineInDecoder decoder(decode::LineInFormat{}, SampleRate{rate}, parameters);
  Decoded result;
  const std::size_t block = block_frames == 0 ? interleaved.size() : 2 * block_frames;
  for (std::size_t at = 0; at < interleaved.size(); at += block) {
    decoder.push(std::span(interleaved).subspan(at, std::min(block, interleaved.size() - at)));
    for (auto& cycle : decoder.take_cycles()) {
      result.cycles.push_back(cycle);
    }
    for (auto& finding : decoder.take_diagnostics()) {
      result.findings.push_back(std::move(finding));
    }
  }
  decoder.finish();
  for (auto& cycle : decoder.take_cycles()) {
    result.cycles.push_back(cycle);
  }
  for (auto& finding : decoder.take_diagnostics()) {
    result.findings.push_back(std::move(finding));
  }
  result.status = decoder.status();
  return result;
}

}  // namespace limbwave::test
