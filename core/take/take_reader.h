/// The samples of a take, as a stream and at random.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "acquire/sample_format.h"
#include "base/result.h"
#include "base/time.h"
#include "take/take.h"

namespace limbwave::take {

/// Reads signal.wav, also of a take that is being recorded or was left open by a crash. Movable; may be used by one
/// thread at a time.
class TakeReader {
 public:
  static Result<TakeReader> open(const Take& take);

  ~TakeReader();
  TakeReader(TakeReader&&) noexcept;
  TakeReader& operator=(TakeReader&&) noexcept;

  [[nodiscard]] const acquire::StreamFormat& format() const;
  [[nodiscard]] std::int64_t frames() const;

  /// Interleaved samples of all channels, full scale ±1, from frame `first` on: as many whole frames as fit and exist.
  /// Returns the number of frames. `first` beyond the end gives 0.
  Result<std::size_t> read(SampleIndex first, std::span<float> out);
  /// The same as raw bytes of `format()`; returns the number of frames.
  Result<std::size_t> read_raw(SampleIndex first, std::span<std::byte> out);

  /// Stream: the next frames after the last `next`, from the start of the take; 0 at the end.
  Result<std::size_t> next(std::span<float> out);
  /// Where `next` goes on.
  [[nodiscard]] SampleIndex position() const;
  void seek(SampleIndex position);

 private:
  struct Impl;
  explicit TakeReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace limbwave::take
