#include "acquire/recording_file.h"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "acquire/container_layout.h"
#include "acquire/silent_terminal.h"

namespace limbwave::acquire {
namespace fs = std::filesystem;
namespace {

constexpr const char* kKnownKinds = "give a WAV, W64, RF64, FLAC or AIFF file";

// How libsndfile's types come out: exactly where they can.
struct Mapping {
  SampleType type = SampleType::kInt16;
  std::string converted = {};  // what was converted; empty: exact
  bool is_double = false;      // 64-bit floats
  bool is_lossy = false;       // the file is a lossy compression
};

Mapping map_type(int format) {
  switch (format & SF_FORMAT_SUBMASK) {
    case SF_FORMAT_PCM_16:
    case SF_FORMAT_ALAC_16:
    case SF_FORMAT_DPCM_16:
      return {.type = SampleType::kInt16};
    case SF_FORMAT_PCM_24:
    case SF_FORMAT_ALAC_24:
      return {.type = SampleType::kInt24};
    case SF_FORMAT_ALAC_20:
      return {.type = SampleType::kInt24, .converted = "20-bit samples were stored in 24 bits, exactly"};
    case SF_FORMAT_PCM_32:
    case SF_FORMAT_ALAC_32:
      return {.type = SampleType::kInt32};
    case SF_FORMAT_FLOAT:
      return {.type = SampleType::kFloat32};
    case SF_FORMAT_DOUBLE:
      return {.type = SampleType::kFloat32,
              .converted = "64-bit float samples were rounded to 32-bit floats",
              .is_double = true};
    case SF_FORMAT_PCM_S8:
    case SF_FORMAT_PCM_U8:
    case SF_FORMAT_DPCM_8:
      return {.type = SampleType::kInt16,
              .converted = "8-bit samples were stored in 16 bits, exactly; 8 bits are coarse: record 16 or more"};
    case SF_FORMAT_VORBIS:
    case SF_FORMAT_OPUS:
    case SF_FORMAT_MPEG_LAYER_I:
    case SF_FORMAT_MPEG_LAYER_II:
    case SF_FORMAT_MPEG_LAYER_III:
      return {
          .type = SampleType::kFloat32, .converted = "samples were decompressed to 32-bit floats", .is_lossy = true};
    default:  // µ-law, ADPCM and other compressions of telephones and dictaphones
      return {.type = SampleType::kInt16, .converted = "samples were decompressed to 16 bits", .is_lossy = true};
  }
}

// Lossless compressions state exactly how many frames there are; MP3 headers may only estimate.
bool count_is_exact(int format) {
  const int container = format & SF_FORMAT_TYPEMASK;
  return container == SF_FORMAT_FLAC || container == SF_FORMAT_CAF;
}

Error error_at(const fs::path& path, std::string message, std::string remedy) {
  return {std::move(message), path.string(), std::move(remedy)};
}

std::string seconds_text(std::uint64_t bytes, const ContainerLayout& layout) {
  const std::uint64_t frames = bytes / static_cast<std::uint64_t>(layout.bytes_per_frame);
  const double seconds = static_cast<double>(frames) / layout.rate_hz;
  return seconds < 0.1 ? fmt::format("{} samples", frames) : fmt::format("{:.1f} s", seconds);
}

// libsndfile's reason within a line of ours.
std::string library_reason() {
  std::string reason = sf_strerror(nullptr);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  reason.erase(reason.find_last_not_of(" .") + 1);
  return reason;
}

// Whether libsndfile may take the file for MPEG audio: by what it is not.
bool may_be_mpeg(const fs::path& path) {
  char head[4] = {};
  std::ifstream(path, std::ios::binary).read(head, sizeof head);
  const std::string_view marker(head, sizeof head);
  for (const std::string_view other : {"RF64", "BW64", "riff", "FORM", "fLaC", "OggS", "caff", ".snd"}) {
    if (marker == other) {
      return false;
    }
  }
  return true;  // RIFF too: a WAV file may hold MPEG
}

std::optional<Error> check_file(const fs::path& path) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (!fs::exists(status)) {
    return error_at(path, "does not exist", "check the path");
  }
  if (fs::is_directory(status)) {
    return error_at(path, "is a folder, not a recording", kKnownKinds);
  }
  if (!fs::is_regular_file(status)) {
    return error_at(path, "is not a file that can be read twice", kKnownKinds);
  }
  const auto size = fs::file_size(path, code);
  if (!code && size == 0) {
    return error_at(path, "is empty (0 bytes)", "copy it again from the recorder");
  }
  return std::nullopt;
}

std::optional<Error> check_format(const fs::path& path, int channels, double rate, const RecordingOptions& options) {
  if (channels < 1) {
    return error_at(path, "the header says that there are no channels", "copy it again from the recorder");
  }
  if (channels < options.minimum_channels) {
    return channels == 1 ? error_at(path, "the recording has one channel", "record in stereo")
                         : error_at(path, fmt::format("the recording has {} channels", channels),
                                    fmt::format("record {} channels", options.minimum_channels));
  }
  if (!(rate >= kLowestRateHz && rate <= kHighestRateHz)) {
    return error_at(
        path, fmt::format("the header says {:.0f} samples per second", rate),
        fmt::format("record at 44100 to 192000; {:.0f} to {:.0f} can be read", kLowestRateHz, kHighestRateHz));
  }
  return std::nullopt;
}

}  // namespace

struct RecordingFile::Impl {
  fs::path path;
  SNDFILE* file = nullptr;
  StreamFormat format;
  Mapping mapping;
  bool count_exact = false;
  bool is_raw = false;
  bool noisy = false;  // libsndfile may write to the terminal while reading it
  bool accept_truncated = false;
  std::optional<std::int64_t> frames;
  std::int64_t done = 0;
  Diagnostics findings;
  std::int64_t not_numbers = 0;
  double first_not_number_s = 0.0;
  std::vector<double> scratch;  // aligned for every type

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (file != nullptr) {
      sf_close(file);
    }
  }

  void note(Severity severity, const char* code, std::string message, std::string remedy = {}) {
    findings.push_back({severity, code, std::move(message), std::move(remedy), path.string(), -1.0});
  }

  std::optional<Error> check_layout(const ContainerLayout& layout);
  void reopen_as_raw(SF_INFO info, const ContainerLayout& layout);
  sf_count_t read_frames(std::span<std::byte> out, sf_count_t wanted);
  void count_not_numbers(std::span<const std::byte> bytes);
};

// What the header promises against what the file holds; the channels and the rate are known to be sound.
std::optional<Error> RecordingFile::Impl::check_layout(const ContainerLayout& layout) {
  if (!layout.data_bytes) {
    note(Severity::kWarning, "recording.not-closed", "the recorder never closed this file; it was read to its end",
         "check its last second");
  }
  if (layout.bytes_per_frame < 1) {
    return std::nullopt;
  }
  const auto frame = static_cast<std::uint64_t>(layout.bytes_per_frame);
  const std::uint64_t there = layout.bytes_there();
  if (layout.data_bytes && *layout.data_bytes >= there + frame) {
    const std::string message = fmt::format("the recording is cut off: its header promises {}, but {} are there",
                                            seconds_text(*layout.data_bytes, layout), seconds_text(there, layout));
    if (!accept_truncated) {
      return error_at(path, message, kBreaksOffRemedy);
    }
    note(Severity::kWarning, "recording.truncated", message, "copy it again from the recorder if that has more");
  }
  if (there % frame != 0) {
    note(Severity::kWarning, "recording.partial-frame",
         fmt::format("the last {} of {} bytes are only part of a frame and were left out", there % frame, frame));
  }
  return std::nullopt;
}

// libsndfile finds nothing in a file whose header says zero; the samples are there all the same.
void RecordingFile::Impl::reopen_as_raw(SF_INFO info, const ContainerLayout& layout) {
  const bool is_big = (info.format & SF_FORMAT_TYPEMASK) == SF_FORMAT_AIFF;
  info.format = SF_FORMAT_RAW | (info.format & SF_FORMAT_SUBMASK) | (is_big ? SF_ENDIAN_BIG : SF_ENDIAN_LITTLE);
  SNDFILE* raw = sf_open(path.c_str(), SFM_READ, &info);
  if (raw == nullptr) {
    return;
  }
  sf_close(file);
  file = raw;
  is_raw = true;
  auto offset = static_cast<sf_count_t>(layout.data_offset);
  sf_command(file, SFC_SET_RAW_START_OFFSET, &offset, sizeof offset);
  sf_seek(file, 0, SEEK_SET);  // the command alone does not move
  frames = static_cast<std::int64_t>(layout.bytes_there() / static_cast<std::uint64_t>(layout.bytes_per_frame));
}

Result<RecordingFile> RecordingFile::open(const fs::path& path, const RecordingOptions& options) {
  if (std::optional<Error> error = check_file(path)) {
    return *std::move(error);
  }
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->accept_truncated = options.accept_truncated;
  // Before libsndfile, which refuses what it does not like without saying where, and mends the rest without a word.
  const std::optional<ContainerLayout> layout = read_layout(path);
  if (layout) {
    if (std::optional<Error> error = check_format(path, layout->channels, layout->rate_hz, options)) {
      return *std::move(error);
    }
  }
  SF_INFO info{};
  impl->noisy = may_be_mpeg(path) && !(layout && layout->bytes_per_frame > 0);
  {
    const SilentTerminal silence(impl->noisy);
    impl->file = sf_open(path.c_str(), SFM_READ, &info);
  }
  if (impl->file == nullptr) {
    const int reason = sf_error(nullptr);
    return reason == SF_ERR_UNRECOGNISED_FORMAT
               ? error_at(path, "is not an audio file that can be read", kKnownKinds)
               : error_at(path, fmt::format("is damaged, or of a kind that cannot be read ({})", library_reason()),
                          "copy it again from the recorder, or export it as WAV");
  }
  if (std::optional<Error> error = check_format(path, info.channels, info.samplerate, options)) {
    return *std::move(error);
  }
  impl->mapping = map_type(info.format);
  impl->format = {SampleRate{static_cast<double>(info.samplerate)}, info.channels, impl->mapping.type};
  impl->count_exact = count_is_exact(info.format);
  if (info.frames < std::numeric_limits<sf_count_t>::max() / 2) {
    impl->frames = info.frames;
  }
  if (layout) {
    if (std::optional<Error> error = impl->check_layout(*layout)) {
      return *std::move(error);
    }
  }
  if (impl->frames == 0 && layout && !layout->data_bytes && layout->bytes_per_frame > 0) {
    impl->reopen_as_raw(info, *layout);
  }
  if (impl->frames == 0) {
    return error_at(path, "the recording has no samples", "check that the recorder was running");
  }
  if (!impl->mapping.converted.empty()) {
    impl->note(Severity::kInfo, "recording.converted", impl->mapping.converted);
  }
  if (impl->mapping.is_lossy) {
    impl->note(Severity::kWarning, "recording.lossy", "the recording was compressed with loss, which blurs the signal",
               "set the recorder to WAV or FLAC");
  }
  return RecordingFile(std::move(impl));
}

RecordingFile::RecordingFile(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RecordingFile::~RecordingFile() = default;
RecordingFile::RecordingFile(RecordingFile&&) noexcept = default;
RecordingFile& RecordingFile::operator=(RecordingFile&&) noexcept = default;

const StreamFormat& RecordingFile::format() const {
  return impl_->format;
}
std::optional<std::int64_t> RecordingFile::frames() const {
  return impl_->frames;
}
const fs::path& RecordingFile::path() const {
  return impl_->path;
}

sf_count_t RecordingFile::Impl::read_frames(std::span<std::byte> out, sf_count_t wanted) {
  scratch.resize(static_cast<std::size_t>(wanted) * static_cast<std::size_t>(format.channels));
  const auto samples = [&](sf_count_t got) {
    return static_cast<std::size_t>(std::max<sf_count_t>(got, 0) * format.channels);
  };
  sf_count_t got = 0;
  switch (format.type) {
    case SampleType::kInt16:
      got = sf_readf_short(file, reinterpret_cast<short*>(scratch.data()), wanted);
      break;
    case SampleType::kInt32:
      got = sf_readf_int(file, reinterpret_cast<int*>(scratch.data()), wanted);
      break;
    case SampleType::kInt24: {
      got = sf_readf_int(file, reinterpret_cast<int*>(scratch.data()), wanted);  // in the upper three bytes
      const auto* bytes = reinterpret_cast<const std::byte*>(scratch.data());
      for (std::size_t i = 0; i < samples(got); ++i) {
        std::memcpy(out.data() + 3 * i, bytes + 4 * i + 1, 3);
      }
      return got;
    }
    case SampleType::kFloat32:
      if (mapping.is_double) {
        got = sf_readf_double(file, scratch.data(), wanted);
        for (std::size_t i = 0; i < samples(got); ++i) {
          const auto value = static_cast<float>(scratch[i]);
          std::memcpy(out.data() + 4 * i, &value, 4);
        }
        return got;
      }
      got = sf_readf_float(file, reinterpret_cast<float*>(scratch.data()), wanted);
      break;
  }
  std::memcpy(out.data(), scratch.data(), samples(got) * bytes_per_sample(format.type));
  return got;
}

void RecordingFile::Impl::count_not_numbers(std::span<const std::byte> bytes) {
  constexpr std::uint32_t kExponent = 0x7F800000U;  // all ones: infinite or NaN
  for (std::size_t i = 0; i + 4 <= bytes.size(); i += 4) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, bytes.data() + i, 4);
    if ((bits & kExponent) == kExponent) {
      if (not_numbers++ == 0) {
        const auto frame = done + static_cast<std::int64_t>(i / format.bytes_per_frame());
        first_not_number_s = static_cast<double>(frame) / format.rate.hz;
      }
    }
  }
}

Result<std::size_t> RecordingFile::read(std::span<std::byte> out) {
  Impl& self = *impl_;
  const std::size_t frame = self.format.bytes_per_frame();
  auto wanted = static_cast<sf_count_t>(out.size() / frame);
  if (self.is_raw) {  // libsndfile counts the header as samples there
    wanted = std::min<sf_count_t>(wanted, *self.frames - self.done);
  }
  sf_count_t got = 0;
  {
    const SilentTerminal silence(self.noisy);
    got = std::max<sf_count_t>(self.read_frames(out, wanted), 0);
  }
  const std::size_t bytes = static_cast<std::size_t>(got) * frame;
  if (self.format.type == SampleType::kFloat32) {
    self.count_not_numbers(out.first(bytes));
  }
  self.done += got;
  if (got < wanted) {
    const bool is_short = self.count_exact && self.frames && self.done < *self.frames;
    if ((is_short || sf_error(self.file) != SF_ERR_NO_ERROR) && !self.accept_truncated) {
      return error_at(self.path,
                      fmt::format("the recording breaks off or is damaged after {:.1f} s",
                                  static_cast<double>(self.done) / self.format.rate.hz),
                      kBreaksOffRemedy);
    }
    if (is_short) {
      self.note(
          Severity::kWarning, "recording.truncated",
          fmt::format("the recording breaks off after {:.1f} s", static_cast<double>(self.done) / self.format.rate.hz),
          "copy it again from the recorder if that has more");
      self.frames = self.done;
    }
  }
  return bytes;
}

Diagnostics RecordingFile::diagnostics() const {
  Diagnostics all = impl_->findings;
  if (impl_->not_numbers > 0) {
    all.push_back(
        {Severity::kError, "recording.not-a-number",
         fmt::format("{} of {} samples are not numbers", impl_->not_numbers, impl_->done * impl_->format.channels),
         "export it again from the audio program, as 16 or 24 bit", impl_->path.string(), impl_->first_not_number_s});
  }
  return all;
}

}  // namespace limbwave::acquire
