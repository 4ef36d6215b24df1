#include "base/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>

#ifndef LIMBWAVE_DEFAULT_RESOURCES
#define LIMBWAVE_DEFAULT_RESOURCES ""
#endif

namespace limbwave {
namespace fs = std::filesystem;

Result<std::string> read_file(const fs::path& path, std::size_t limit_bytes) {
  std::error_code code;
  if (fs::is_directory(path, code)) {
    return Error{"is a folder, not a file", path.string(), "name a file"};
  }
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return Error{std::string("cannot be read (") + std::strerror(errno) + ")", path.string(), "check the path"};
  }
  const auto size = fs::file_size(path, code);
  if (!code && size > limit_bytes) {
    return Error{"is too large (" + std::to_string(size) + " bytes)", path.string(), "check that it is the right file"};
  }
  std::string content;
  if (!code) {
    content.reserve(size);
  }
  char buffer[65536];
  while (file.read(buffer, sizeof buffer) || file.gcount() > 0) {
    content.append(buffer, static_cast<std::size_t>(file.gcount()));
    if (content.size() > limit_bytes) {
      return Error{"is too large", path.string(), "check that it is the right file"};
    }
  }
  if (file.bad()) {
    return Error{"reading failed half-way", path.string(), "check the disk"};
  }
  return content;
}

Status write_file(const fs::path& path, std::string_view content) {
  // A name of this call's own: threads may save the same file at once.
  static std::atomic<unsigned> calls{0};
  const fs::path part = path.string() + ".part" + std::to_string(::getpid()) + "-" + std::to_string(calls++);
  const auto fail = [&](const char* what) {
    const int reason = errno;
    ::unlink(part.c_str());
    return Error{std::string(what) + " (" + std::strerror(reason) + ")", path.string(),
                 "check that the folder exists, that you may write there and that the disk has room"};
  };
  const int file = ::open(part.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file < 0) {
    return fail("cannot be written");
  }
  std::size_t done = 0;
  while (done < content.size()) {
    const ssize_t written = ::write(file, content.data() + done, content.size() - done);
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      const Error error = fail("writing failed");
      ::close(file);
      return error;
    }
    done += static_cast<std::size_t>(written);
  }
  if (::fsync(file) != 0) {
    const Error error = fail("writing failed");
    ::close(file);
    return error;
  }
  ::close(file);
  if (::rename(part.c_str(), path.c_str()) != 0) {
    return fail("cannot be written");
  }
  return {};
}

fs::path resources_folder() {
  if (const char* folder = std::getenv("LIMBWAVE_RESOURCES"); folder != nullptr && *folder != '\0') {
    return folder;
  }
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  if (!code) {
    for (const char* relative : {"../share/limbwave", "resources", "../resources", "../../../../resources"}) {
      const fs::path candidate = program.parent_path() / relative;
      if (fs::exists(candidate / "rigs", code)) {
        return candidate.lexically_normal();
      }
    }
  }
  return LIMBWAVE_DEFAULT_RESOURCES;
}

fs::path user_data_folder() {
  if (const char* folder = std::getenv("LIMBWAVE_HOME"); folder != nullptr && *folder != '\0') {
    return folder;
  }
  if (const char* folder = std::getenv("XDG_DATA_HOME"); folder != nullptr && *folder != '\0') {
    return fs::path(folder) / "limbwave";
  }
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr ? home : ".") / ".local/share/limbwave";
}

}  // namespace limbwave
