#include "base/atomic_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <utility>

namespace limbwave {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20;

// Two files of one program may be on their way to the same place.
std::string part_of(const std::filesystem::path& path) {
  static std::atomic<unsigned> count = 0;
  return path.string() + ".part" + std::to_string(::getpid()) + "-" + std::to_string(count++);
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), part_(part_of(path_)) {
  file_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (file_ < 0) {
    fail("cannot be written");
  }
  buffer_.reserve(kBuffer);
}

AtomicFile::~AtomicFile() {
  discard();
}

void AtomicFile::append(std::string_view bytes) {
  if (buffer_.size() + bytes.size() > kBuffer) {
    flush();
  }
  if (bytes.size() >= kBuffer) {
    write_at(flushed_, bytes);
    start_storing(flushed_, bytes.size());
    flushed_ += bytes.size();
  } else {
    buffer_ += bytes;
  }
}

void AtomicFile::overwrite(std::uint64_t offset, std::string_view bytes) {
  assert(offset + bytes.size() <= size());
  if (offset < flushed_ && offset + bytes.size() > flushed_) {
    flush();
  }
  if (offset >= flushed_) {
    std::memcpy(buffer_.data() + (offset - flushed_), bytes.data(), bytes.size());
  } else {
    write_at(offset, bytes);
  }
}

Status AtomicFile::commit() {
  flush();
  if (status_ && ::fsync(file_) != 0) {
    fail("writing failed");
  }
  if (status_ && ::rename(part_.c_str(), path_.c_str()) != 0) {
    fail("cannot be written");
  }
  if (status_) {
    ::close(file_);
    file_ = -1;
  }
  discard();
  return status_;
}

void AtomicFile::flush() {
  write_at(flushed_, buffer_);
  start_storing(flushed_, buffer_.size());
  flushed_ += buffer_.size();
  buffer_.clear();
}

// Asks the disk to begin, so that `commit` need not wait for all of it. A file system that cannot do so does it then.
void AtomicFile::start_storing(std::uint64_t offset, std::size_t bytes) {
  if (status_ && bytes > 0) {
    (void)::sync_file_range(file_, static_cast<off_t>(offset), static_cast<off_t>(bytes), SYNC_FILE_RANGE_WRITE);
  }
}

void AtomicFile::write_at(std::uint64_t offset, std::string_view bytes) {
  while (status_ && !bytes.empty()) {
    const ssize_t written = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written < 0) {
      fail("writing failed");
      return;
    }
    offset += static_cast<std::uint64_t>(written);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void AtomicFile::fail(const char* what) {
  if (status_) {
    status_ = Error{std::string(what) + " (" + std::strerror(errno) + ")", path_.string(),
                    "check that the folder exists, that you may write there and that the disk has room"};
  }
}

void AtomicFile::discard() {
  if (file_ >= 0) {
    ::close(file_);
    ::unlink(part_.c_str());
    file_ = -1;
  }
}

}  // namespace limbwave
