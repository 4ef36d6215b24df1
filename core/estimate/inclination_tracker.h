/// The live form of `estimate_inclinations`: one sample in, the present inclination out.
#pragma once

#include <memory>

#include "estimate/inclination.h"

namespace limbwave::estimate {

/// Causal. The offline estimate runs the same filter forward, then goes back over what it has noted.
class InclinationTracker {
 public:
  explicit InclinationTracker(Smoothing smoothing, const InclinationParameters& parameters = {});
  ~InclinationTracker();
  InclinationTracker(const InclinationTracker& other);
  InclinationTracker& operator=(const InclinationTracker& other);
  InclinationTracker(InclinationTracker&&) noexcept;
  InclinationTracker& operator=(InclinationTracker&&) noexcept;

  /// Times must increase; another sample changes nothing and gives the last result again.
  Inclination push(const ForceSample& given);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::estimate
