#include "take/recorder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>

#include "acquire/wav_writer.h"
#include "base/files.h"
#include "base/folder.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

constexpr auto kHeaderInterval = milliseconds(200);
constexpr auto kDiskInterval = milliseconds(1000);
constexpr std::uint64_t kDiskCheckBytes = std::uint64_t{16} << 20;  // for writers that are faster than real time

std::uint64_t free_bytes_of(const fs::path& folder) {
  struct statvfs disk {};
  if (::statvfs(folder.c_str(), &disk) != 0) {
    return UINT64_MAX;  // unknown is no reason to refuse; a full disk then shows when writing
  }
  return static_cast<std::uint64_t>(disk.f_bavail) * disk.f_frsize;
}

std::string now_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  ::gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string part_prefix(const fs::path& folder) {
  return "." + folder.filename().string() + ".part";
}

// What programs that were killed in the middle of making this very take have left.
void remove_stale_parts(const fs::path& folder) {
  const std::string prefix = part_prefix(folder);
  std::error_code code;
  for (const fs::path& entry : entries_of(folder.parent_path())) {
    const std::string name = entry.filename().string();
    if (name.size() <= prefix.size() || !name.starts_with(prefix)) {
      continue;
    }
    pid_t process = 0;
    const char* end = name.data() + name.size();
    const auto [parsed, failure] = std::from_chars(name.data() + prefix.size(), end, process);
    if (failure == std::errc() && parsed == end && process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) {
      fs::remove_all(entry, code);
    }
  }
}

// Like rename, but never onto something that is there.
Status publish(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) {
    return {};
  }
  if (errno == EINVAL || errno == ENOSYS) {  // a file system without it
    std::error_code code;
    if (!fs::exists(to, code)) {
      fs::rename(from, to, code);
      if (!code) {
        return {};
      }
      errno = code.value();
    } else {
      errno = EEXIST;
    }
  }
  if (errno == EEXIST) {
    return Error{"exists already", to.string(), "choose another name, or move it away"};
  }
  return Error{std::string("cannot be made (") + std::strerror(errno) + ")", to.string(),
               "check that you may write there"};
}

}  // namespace

struct Recorder::Impl {
  fs::path folder;  // as it is called once published
  Take take;        // its folder is where the files are now
  RecorderSettings settings;
  std::unique_ptr<acquire::WavWriter> signal;
  bool published = false;
  std::optional<Error> stopped;
  Clock::time_point header_time = Clock::now();
  Clock::time_point disk_time = Clock::now();
  std::uint64_t bytes_since_check = 0;
  std::uint64_t free = 0;

  [[nodiscard]] std::uint64_t spare_bytes() const {
    return free > settings.keep_free_bytes ? free - settings.keep_free_bytes : 0;
  }
  void look_at_disk();
  std::optional<Error> check_disk(std::size_t coming);
  Status save() { return published ? save_info(take) : Status{}; }
  Status set_up();
};

void Recorder::Impl::look_at_disk() {
  free = settings.free_bytes ? settings.free_bytes(take.folder) : free_bytes_of(take.folder);
  disk_time = Clock::now();
  bytes_since_check = 0;
}

// Before the disk is full: what is left is needed to close everything properly.
std::optional<Error> Recorder::Impl::check_disk(std::size_t coming) {
  if (Clock::now() - disk_time >= kDiskInterval || bytes_since_check + coming > kDiskCheckBytes) {
    look_at_disk();
  }
  if (spare_bytes() >= bytes_since_check + coming) {
    return std::nullopt;
  }
  return Error{fmt::format("recording stopped because the disk is nearly full ({} MB left)", free >> 20),
               folder.string(), "everything up to here is kept; make room, or record to another disk"};
}

Status Recorder::Impl::set_up() {
  look_at_disk();
  if (spare_bytes() == 0) {
    return Error{fmt::format("cannot be recorded to: the disk is nearly full ({} MB left)", free >> 20),
                 folder.string(), "make room, or record to another disk"};
  }
  Result<std::unique_ptr<acquire::WavWriter>> file = acquire::WavWriter::create(take.signal_path(), take.info.format);
  if (!file) {
    return file.error();
  }
  signal = *std::move(file);
  if (Status status = write_file(take.folder / "events.jsonl", ""); !status) {
    return status;
  }
  return save_info(take);
}

Recorder::Recorder(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

Result<std::unique_ptr<Recorder>> Recorder::create(const fs::path& folder, TakeInfo info, RecorderSettings settings) {
  auto impl = std::make_unique<Impl>();
  std::error_code code;
  // Without a trailing slash, so that the last part is the name.
  impl->folder = fs::absolute(folder).lexically_normal();
  if (!impl->folder.has_filename()) {
    impl->folder = impl->folder.parent_path();
  }
  if (fs::exists(fs::symlink_status(impl->folder, code))) {
    return Error{"exists already", folder.string(), "choose another name, or move it away"};
  }
  fs::create_directories(impl->folder.parent_path(), code);
  remove_stale_parts(impl->folder);
  impl->take.folder =
      impl->folder.parent_path() / (part_prefix(impl->folder) + std::to_string(static_cast<long>(::getpid())));
  fs::remove_all(impl->take.folder, code);
  if (!fs::create_directory(impl->take.folder, code)) {
    return Error{"cannot be made (" + code.message() + ")", folder.string(),
                 "check that the folder above it exists and that you may write there"};
  }
  impl->settings = std::move(settings);
  impl->take.info = std::move(info);
  impl->take.info.complete = false;
  impl->take.info.frames = 0;
  if (impl->take.info.created.empty()) {
    impl->take.info.created = now_text();
  }
  Status status = impl->set_up();
  if (status && !impl->settings.publish_at_close) {
    // The folder appears with everything in it, so that a crash leaves a take or none, never half of one.
    status = publish(impl->take.folder, impl->folder);
    impl->published = status.ok();
  }
  if (!status) {
    impl->signal.reset();
    fs::remove_all(impl->take.folder, code);
    return status.error();
  }
  if (impl->published) {
    impl->take.folder = impl->folder;
  }
  return std::unique_ptr<Recorder>(new Recorder(std::move(impl)));
}

Recorder::~Recorder() {
  if (impl_->signal == nullptr) {
    return;
  }
  if (impl_->settings.publish_at_close) {
    discard();
  } else {
    (void)close();
  }
}

Status Recorder::write(std::span<const std::byte> frames) {
  Impl& self = *impl_;
  if (!self.stopped && self.signal == nullptr) {
    self.stopped = Error{"the recording is closed", self.folder.string(), ""};
  }
  if (!self.stopped) {
    self.stopped = self.check_disk(frames.size());
  }
  if (self.stopped) {
    return *self.stopped;
  }
  Status status = self.signal->write(frames);
  self.bytes_since_check += frames.size();
  self.take.info.frames = self.signal->frames();
  if (!status) {
    self.stopped = status.error();
    return status;
  }
  if (const Clock::time_point now = Clock::now(); now - self.header_time >= kHeaderInterval) {
    self.header_time = now;
    return self.signal->update_header();
  }
  return {};
}

Status Recorder::add_event(const TakeEvent& event) {
  return append_event(impl_->take.folder, event);
}

Status Recorder::add_segment(const TakeSegment& segment) {
  impl_->take.info.segments.push_back(segment);
  return impl_->save();
}

Status Recorder::set_calibration(const calibrate::RigCalibration& calibration) {
  impl_->take.info.calibration = calibration;
  return impl_->save();
}

std::int64_t Recorder::frames() const {
  return impl_->take.info.frames;
}

double Recorder::seconds() const {
  return impl_->take.info.format.rate.seconds(SampleCount{frames()}).value;
}

double Recorder::disk_left_s() const {
  const acquire::StreamFormat& format = impl_->take.info.format;
  const std::uint64_t spare = impl_->spare_bytes() - std::min(impl_->spare_bytes(), impl_->bytes_since_check);
  return static_cast<double>(spare) / (static_cast<double>(format.bytes_per_frame()) * format.rate.hz);
}

const std::optional<Error>& Recorder::stopped() const {
  return impl_->stopped;
}
const TakeInfo& Recorder::info() const {
  return impl_->take.info;
}
const fs::path& Recorder::working_folder() const {
  return impl_->take.folder;
}

Result<Take> Recorder::close() {
  Impl& self = *impl_;
  if (self.signal == nullptr) {
    return Error{"the recording is closed", self.folder.string(), ""};
  }
  const Status closed = self.signal->close();
  self.signal.reset();
  self.take.info.complete = true;
  Status status = closed ? save_info(self.take) : closed;
  if (status && !self.published) {
    status = publish(self.take.folder, self.folder);
  }
  if (!status) {
    std::error_code code;
    if (!self.published) {
      fs::remove_all(self.take.folder, code);
    }
    return status.error();
  }
  self.published = true;
  self.take.folder = self.folder;
  return open_take(self.folder);
}

void Recorder::discard() {
  impl_->signal.reset();
  std::error_code code;
  fs::remove_all(impl_->take.folder, code);
}

}  // namespace limbwave::take
