#include "acquire/wav_writer.h"

#include <fcntl.h>
#include <sndfile.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>
#include <cstring>

namespace limbwave::acquire {
namespace {

int subtype(SampleType type) {
  switch (type) {
    case SampleType::kInt16:
      return SF_FORMAT_PCM_16;
    case SampleType::kInt24:
      return SF_FORMAT_PCM_24;
    case SampleType::kInt32:
      return SF_FORMAT_PCM_32;
    case SampleType::kFloat32:
      return SF_FORMAT_FLOAT;
  }
  return SF_FORMAT_PCM_16;
}

SF_INFO file_info(const StreamFormat& format) {
  SF_INFO info{};
  info.samplerate = static_cast<int>(std::lround(format.rate.hz));
  info.channels = format.channels;
  info.format = SF_FORMAT_RF64 | subtype(format.type);
  return info;
}

void set_up(SNDFILE* file) {
  sf_command(file, SFC_RF64_AUTO_DOWNGRADE, nullptr, SF_TRUE);
  // The peak chunk would need the samples as floats, and its room in the header.
  sf_command(file, SFC_SET_ADD_PEAK_CHUNK, nullptr, SF_FALSE);
  sf_command(file, SFC_UPDATE_HEADER_NOW, nullptr, 0);
}

// A file of which only the header exists, in memory; its length is pretended.
struct HeaderFile {
  std::string header;
  sf_count_t length = 0;
  sf_count_t position = 0;
};

SF_VIRTUAL_IO header_io() {
  SF_VIRTUAL_IO io{};
  io.get_filelen = [](void* data) { return static_cast<HeaderFile*>(data)->length; };
  io.seek = [](sf_count_t offset, int whence, void* data) {
    auto* file = static_cast<HeaderFile*>(data);
    file->position = offset + (whence == SEEK_CUR ? file->position : whence == SEEK_END ? file->length : 0);
    return file->position;
  };
  io.read = [](void*, sf_count_t, void*) -> sf_count_t { return 0; };
  io.write = [](const void* bytes, sf_count_t count, void* data) {
    auto* file = static_cast<HeaderFile*>(data);
    const auto at = static_cast<std::size_t>(file->position);
    const auto size = static_cast<std::size_t>(count);
    file->header.resize(std::max(file->header.size(), at + size));
    std::memcpy(file->header.data() + at, bytes, size);
    file->position += count;
    file->length = std::max(file->length, file->position);
    return count;
  };
  io.tell = [](void* data) { return static_cast<HeaderFile*>(data)->position; };
  return io;
}

Error write_error(const std::filesystem::path& path, int reason) {
  return {reason == ENOSPC ? "the disk is full" : std::string("writing failed (") + std::strerror(reason) + ")",
          path.string(), "what was recorded until then is kept; make room, or record to another disk"};
}

}  // namespace

std::string wav_header(const StreamFormat& format, std::int64_t frames) {
  HeaderFile memory;
  SF_VIRTUAL_IO io = header_io();
  SF_INFO info = file_info(format);
  SNDFILE* file = sf_open_virtual(&io, SFM_WRITE, &info, &memory);
  assert(file != nullptr);
  set_up(file);
  if (frames > 0) {
    memory.length += static_cast<sf_count_t>(frames) * static_cast<sf_count_t>(format.bytes_per_frame());
    sf_command(file, SFC_UPDATE_HEADER_NOW, nullptr, 0);
  }
  std::string header = memory.header;
  sf_close(file);
  return header;
}

struct WavWriter::Impl {
  std::filesystem::path path;
  StreamFormat format;
  std::string empty_header;
  int descriptor = -1;
  SNDFILE* file = nullptr;
  std::int64_t frames = 0;
  bool failed = false;

  [[nodiscard]] off_t end() const {
    return static_cast<off_t>(empty_header.size()) + frames * static_cast<off_t>(format.bytes_per_frame());
  }
};

WavWriter::WavWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<WavWriter>> WavWriter::create(const std::filesystem::path& path, const StreamFormat& format) {
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->format = format;
  SF_INFO info = file_info(format);
  if (sf_format_check(&info) == 0) {
    return Error{"cannot hold this rate and number of channels", path.string(), "choose another format"};
  }
  impl->empty_header = wav_header(format, 0);
  impl->descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (impl->descriptor < 0) {
    return Error{std::string("cannot be written (") + std::strerror(errno) + ")", path.string(),
                 "check that the folder exists and that you may write there"};
  }
  ::flock(impl->descriptor, LOCK_EX | LOCK_NB);
  impl->file = sf_open_fd(impl->descriptor, SFM_WRITE, &info, SF_FALSE);
  if (impl->file == nullptr) {
    const Error error{std::string("cannot be written (") + sf_strerror(nullptr) + ")", path.string(), ""};
    ::close(impl->descriptor);
    return error;
  }
  set_up(impl->file);
  if (::lseek(impl->descriptor, 0, SEEK_END) != impl->end()) {
    const Error error = write_error(path, errno);
    sf_close(impl->file);
    ::close(impl->descriptor);
    return error;
  }
  return std::unique_ptr<WavWriter>(new WavWriter(std::move(impl)));
}

WavWriter::~WavWriter() {
  (void)close();
}

std::int64_t WavWriter::frames() const {
  return impl_->frames;
}

Status WavWriter::write(std::span<const std::byte> bytes) {
  const std::size_t frame = impl_->format.bytes_per_frame();
  assert(bytes.size() % frame == 0);
  assert(impl_->file != nullptr);
  if (impl_->failed) {
    return write_error(impl_->path, EIO);
  }
  errno = 0;
  const sf_count_t written = sf_write_raw(impl_->file, bytes.data(), static_cast<sf_count_t>(bytes.size()));
  const int reason = errno;
  impl_->frames += static_cast<std::int64_t>(std::max<sf_count_t>(written, 0)) / static_cast<std::int64_t>(frame);
  if (written != static_cast<sf_count_t>(bytes.size())) {
    impl_->failed = true;
    // A part of a frame is of no use to anyone.
    const bool cut = ::ftruncate(impl_->descriptor, impl_->end()) == 0;
    (void)(update_header().ok() && cut);  // `close` tries again and reports
    return write_error(impl_->path, reason != 0 ? reason : EIO);
  }
  return {};
}

Status WavWriter::update_header() {
  assert(impl_->file != nullptr);
  if (!impl_->failed) {
    sf_command(impl_->file, SFC_UPDATE_HEADER_NOW, nullptr, 0);
    return {};
  }
  // libsndfile does nothing more after an error; the header needs no new room on the disk.
  const std::string header = wav_header(impl_->format, impl_->frames);
  if (::pwrite(impl_->descriptor, header.data(), header.size(), 0) != static_cast<ssize_t>(header.size())) {
    return write_error(impl_->path, errno);
  }
  return {};
}

Status WavWriter::close() {
  if (impl_->file == nullptr) {
    return {};
  }
  sf_close(impl_->file);
  impl_->file = nullptr;
  Status status;
  const std::string header = wav_header(impl_->format, impl_->frames);
  if (::ftruncate(impl_->descriptor, impl_->end()) != 0 ||
      ::pwrite(impl_->descriptor, header.data(), header.size(), 0) != static_cast<ssize_t>(header.size()) ||
      ::fdatasync(impl_->descriptor) != 0) {
    status = write_error(impl_->path, errno);
  }
  ::close(impl_->descriptor);
  return status;
}

}  // namespace limbwave::acquire
