#include "take/take_reader.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "take/signal_file.h"

namespace limbwave::take {
namespace {

constexpr std::size_t kBlockBytes = std::size_t{256} << 10;

}  // namespace

struct TakeReader::Impl {
  std::string path;
  acquire::StreamFormat format;
  std::int64_t frames = 0;
  std::uint64_t data_offset = 0;
  std::int64_t position = 0;
  int descriptor = -1;
  std::vector<std::byte> block;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (descriptor >= 0) {
      ::close(descriptor);
    }
  }

  [[nodiscard]] std::size_t frames_from(SampleIndex first, std::size_t wanted) const {
    if (first.value < 0 || first.value >= frames) {
      return 0;
    }
    return static_cast<std::size_t>(std::min<std::uint64_t>(wanted, static_cast<std::uint64_t>(frames - first.value)));
  }
};

TakeReader::TakeReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
TakeReader::~TakeReader() = default;
TakeReader::TakeReader(TakeReader&&) noexcept = default;
TakeReader& TakeReader::operator=(TakeReader&&) noexcept = default;

Result<TakeReader> TakeReader::open(const Take& take) {
  const Result<SignalFile> signal = inspect_signal(take.signal_path(), take.info.format);
  if (!signal) {
    return signal.error();
  }
  auto impl = std::make_unique<Impl>();
  impl->path = take.signal_path().string();
  impl->format = take.info.format;
  impl->frames = take.info.complete ? std::min(take.info.frames, signal->frames) : signal->frames;
  impl->data_offset = signal->data_offset;
  impl->descriptor = ::open(impl->path.c_str(), O_RDONLY | O_CLOEXEC);
  if (impl->descriptor < 0) {
    return Error{std::string("cannot be read (") + std::strerror(errno) + ")", impl->path, "check its permissions"};
  }
  return TakeReader(std::move(impl));
}

const acquire::StreamFormat& TakeReader::format() const {
  return impl_->format;
}
std::int64_t TakeReader::frames() const {
  return impl_->frames;
}

Result<std::size_t> TakeReader::read_raw(SampleIndex first, std::span<std::byte> out) {
  const std::size_t frame = impl_->format.bytes_per_frame();
  const std::size_t count = impl_->frames_from(first, out.size() / frame);
  std::size_t done = 0;
  while (done < count * frame) {
    const auto offset = static_cast<off_t>(impl_->data_offset + static_cast<std::uint64_t>(first.value) * frame + done);
    const ssize_t got = ::pread(impl_->descriptor, out.data() + done, count * frame - done, offset);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      return Error{got < 0 ? std::string("reading failed (") + std::strerror(errno) + ")" : "became shorter meanwhile",
                   impl_->path, "check the disk"};
    }
    done += static_cast<std::size_t>(got);
  }
  return count;
}

Result<std::size_t> TakeReader::read(SampleIndex first, std::span<float> out) {
  const std::size_t frame = impl_->format.bytes_per_frame();
  const auto channels = static_cast<std::size_t>(impl_->format.channels);
  const std::size_t count = impl_->frames_from(first, out.size() / channels);
  const std::size_t at_once = std::max<std::size_t>(kBlockBytes / frame, 1);
  std::size_t done = 0;
  while (done < count) {
    const std::size_t part = std::min(at_once, count - done);
    impl_->block.resize(part * frame);
    const Result<std::size_t> got = read_raw(first + SampleCount{static_cast<std::int64_t>(done)}, impl_->block);
    if (!got) {
      return got.error();
    }
    acquire::to_float(impl_->format.type, impl_->block, out.subspan(done * channels, part * channels));
    done += part;
  }
  return count;
}

Result<std::size_t> TakeReader::next(std::span<float> out) {
  Result<std::size_t> got = read(position(), out);
  if (got) {
    impl_->position += static_cast<std::int64_t>(*got);
  }
  return got;
}

SampleIndex TakeReader::position() const {
  return {impl_->position};
}
void TakeReader::seek(SampleIndex position) {
  impl_->position = std::max<std::int64_t>(position.value, 0);
}

}  // namespace limbwave::take
