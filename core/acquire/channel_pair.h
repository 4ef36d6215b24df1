/// Two inputs of a larger interface as a stereo source.
#pragma once

#include <memory>

#include "acquire/live_source.h"
#include "base/result.h"

namespace limbwave::acquire {

/// A source whose left and right channels are channels `left` and `right` of `source` (counted from 0; the same one
/// twice is allowed), samples bit by bit. Fails when `source` does not have them.
Result<std::unique_ptr<LiveSource>> pick_channels(std::unique_ptr<LiveSource> source, int left, int right);

}  // namespace limbwave::acquire
