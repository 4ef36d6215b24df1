/// Where writers of binary files put their bytes.
#pragma once

#include <cassert>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

namespace limbwave {

class ByteSink {
 public:
  virtual ~ByteSink() = default;
  virtual void append(std::string_view bytes) = 0;
  /// Replaces bytes that were appended before. Asserts that they were.
  virtual void overwrite(std::uint64_t offset, std::string_view bytes) = 0;
  [[nodiscard]] virtual std::uint64_t size() const = 0;
};

/// Keeps them in memory.
class MemorySink final : public ByteSink {
 public:
  void append(std::string_view bytes) override { bytes_ += bytes; }
  void overwrite(std::uint64_t offset, std::string_view bytes) override {
    assert(offset + bytes.size() <= bytes_.size());
    std::memcpy(bytes_.data() + offset, bytes.data(), bytes.size());
  }
  [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

}  // namespace limbwave
