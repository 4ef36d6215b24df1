/// All-or-nothing writing of files that are too large to be held in memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/byte_sink.h"
#include "base/result.h"

namespace limbwave {

/// A new file, written beside `path` and put in its place by `commit`. Until then, and when the writing fails or the
/// object goes away, `path` is as it was. Errors are kept until `commit`, so that writers need not ask after every
/// number. Used by one thread at a time.
class AtomicFile final : public ByteSink {
 public:
  explicit AtomicFile(std::filesystem::path path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile() override;

  void append(std::string_view bytes) override;
  void overwrite(std::uint64_t offset, std::string_view bytes) override;
  [[nodiscard]] std::uint64_t size() const override { return flushed_ + buffer_.size(); }

  /// Flushes to disk and renames. Fails with the operating system's reason of whatever failed first.
  Status commit();

 private:
  void flush();
  void start_storing(std::uint64_t offset, std::size_t bytes);
  void write_at(std::uint64_t offset, std::string_view bytes);
  void fail(const char* what);
  void discard();

  std::filesystem::path path_;
  std::string part_;
  int file_ = -1;
  std::string buffer_;
  std::uint64_t flushed_ = 0;
  Status status_;
};

}  // namespace limbwave
