/// A text file that is written as it goes: the truth of a long take would not fit well into memory.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <utility>

namespace limbwave::simulate {

/// Failures are kept until `close`, which tells of them.
class TextFile {
 public:
  explicit TextFile(const std::filesystem::path& path) : file_(std::fopen(path.c_str(), "wb")) {}
  ~TextFile() {
    if (file_ != nullptr) {
      std::fclose(file_);
    }
  }
  TextFile(const TextFile&) = delete;
  TextFile& operator=(const TextFile&) = delete;

  template <typename... Arguments>
  void add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(buffer_), format, std::forward<Arguments>(arguments)...);
    if (buffer_.size() > (std::size_t{1} << 20U)) {
      flush();
    }
  }
  bool close() {
    flush();
    const bool closed = file_ != nullptr && std::fclose(file_) == 0;
    file_ = nullptr;
    return good_ && closed;
  }

 private:
  void flush() {
    good_ = good_ && file_ != nullptr && std::fwrite(buffer_.data(), 1, buffer_.size(), file_) == buffer_.size();
    buffer_.clear();
  }
  std::FILE* file_;
  fmt::memory_buffer buffer_;
  bool good_ = true;
};

}  // namespace limbwave::simulate
