/// Progress of long work, which its observer can stop.
#pragma once

#include <functional>
#include <string_view>
#include <utility>

#include "base/result.h"

namespace limbwave {

/// Handed down into long work. `report` returns false when the user wants it to stop; the work then cleans up and
/// returns `cancelled()`.
class Progress {
 public:
  /// `fraction` in 0..1, `what` is the present step ("decoding"); answers whether to go on.
  using Callback = std::function<bool(double fraction, std::string_view what)>;

  Progress() = default;
  explicit Progress(Callback callback) : callback_(std::move(callback)) {}

  [[nodiscard]] bool report(double fraction, std::string_view what = {}) const {
    return !callback_ || callback_(begin_ + fraction * (end_ - begin_), what);
  }

  /// The part of this progress between two fractions, for a step of a longer work.
  [[nodiscard]] Progress part(double begin, double end) const {
    Progress sub(callback_);
    sub.begin_ = begin_ + begin * (end_ - begin_);
    sub.end_ = begin_ + end * (end_ - begin_);
    return sub;
  }

 private:
  Callback callback_;
  double begin_ = 0.0;
  double end_ = 1.0;
};

/// The error that stopped work returns; `is_cancelled` tells it from real failures.
inline Error cancelled() {
  return {"cancelled", "", ""};
}
inline bool is_cancelled(const Error& error) {
  return error.message == "cancelled" && error.place.empty();
}

}  // namespace limbwave
