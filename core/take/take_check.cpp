// Verifying a take, and repairing one that a crash left open.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "acquire/wav_writer.h"
#include "base/files.h"
#include "base/folder.h"
#include "base/json_reader.h"
#include "take/signal_file.h"
#include "take/take.h"
#include "take/take_reader.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

void add(Diagnostics& list, Severity severity, const char* code, std::string message, const fs::path& place,
         std::string remedy = {}) {
  list.push_back({severity, code, std::move(message), std::move(remedy), place.string(), -1.0});
}

bool has_finding(const Take& take, std::string_view code) {
  return std::any_of(take.diagnostics.begin(), take.diagnostics.end(),
                     [&](const Diagnostic& finding) { return finding.code == code; });
}

void check_header(const Take& take, const SignalFile& signal, Diagnostics& findings) {
  if (!signal.header_readable) {
    return;  // opening has said so
  }
  if (signal.header_frames != take.info.frames) {
    add(findings, take.info.complete ? Severity::kError : Severity::kWarning, "verify.header",
        fmt::format("the header says {} frames, but the take has {}", signal.header_frames, take.info.frames),
        take.signal_path(), "run `limbwave recover` to repair it");
  }
  if (signal.partial_bytes != 0 || (take.info.complete && signal.frames > take.info.frames)) {
    add(findings, Severity::kWarning, "verify.trailing",
        fmt::format("{} bytes follow the last frame of the take",
                    static_cast<std::uint64_t>(std::max<std::int64_t>(signal.frames - take.info.frames, 0)) *
                            take.info.format.bytes_per_frame() +
                        signal.partial_bytes),
        take.signal_path(), "run `limbwave recover` to repair it");
  }
}

void check_segments(const Take& take, Diagnostics& findings) {
  for (const TakeSegment& segment : take.info.segments) {
    if (segment.first.value + segment.count.value > take.info.frames) {
      add(findings, Severity::kError, "verify.segment",
          fmt::format("segment \"{}\" reaches beyond the end of the take", segment.name), take.folder / "take.json",
          "shorten it there");
    }
  }
  const auto late = std::count_if(take.events.begin(), take.events.end(),
                                  [&](const TakeEvent& event) { return event.sample.value > take.info.frames; });
  if (late > 0) {
    add(findings, Severity::kWarning, "verify.event", fmt::format("{} events lie beyond the end of the take", late),
        take.folder / "events.jsonl");
  }
}

void check_rig(const TakeInfo& info, const fs::path& place, Diagnostics& findings) {
  if (info.rig.skeleton != info.skeleton.name) {
    add(findings, Severity::kError, "verify.skeleton",
        fmt::format("the rig is worn by skeleton \"{}\", but the snapshot is of \"{}\"", info.rig.skeleton,
                    info.skeleton.name),
        place);
  }
  for (const body::Accelerometer& sensor : info.rig.accelerometers) {
    if (info.skeleton.find(sensor.segment) < 0) {
      add(findings, Severity::kError, "verify.rig",
          fmt::format("sensor \"{}\" sits on \"{}\", which is no segment of the skeleton", sensor.name, sensor.segment),
          place);
    }
  }
}

// Every sample is read, so that a disk that fails shows now and not later.
void check_samples(const Take& take, Diagnostics& findings) {
  Result<TakeReader> reader = TakeReader::open(take);
  if (!reader) {
    add(findings, Severity::kError, "verify.samples", reader.error().message, reader.error().place,
        reader.error().remedy);
    return;
  }
  std::vector<float> block(std::size_t{65536} * static_cast<std::size_t>(take.info.format.channels));
  std::int64_t not_numbers = 0;
  for (;;) {
    const Result<std::size_t> got = reader->next(block);
    if (!got) {
      add(findings, Severity::kError, "verify.samples", got.error().message, got.error().place, got.error().remedy);
      return;
    }
    if (*got == 0) {
      break;
    }
    const auto end = block.begin() + static_cast<std::ptrdiff_t>(*got) * take.info.format.channels;
    not_numbers += std::count_if(block.begin(), end, [](float sample) { return !std::isfinite(sample); });
  }
  if (not_numbers > 0) {
    add(findings, Severity::kError, "verify.not-a-number", fmt::format("{} samples are not numbers", not_numbers),
        take.signal_path(), "record again; they count as loss of signal");
  }
}

void check_json_file(const fs::path& path, Diagnostics& findings) {
  const Result<std::string> text = read_file(path);
  const Result<nlohmann::json> json = text ? parse_json(*text, path.string()) : Result<nlohmann::json>(text.error());
  if (!json) {
    add(findings, Severity::kError, "verify.file", json.error().message, json.error().place,
        "make it again: solve or simulate the take again");
  }
}

// `path` and everything in it, apart from what opening the take has read.
void check_json_files(const fs::path& path, const fs::path& known, Diagnostics& findings) {
  std::error_code code;
  if (!fs::is_directory(path, code)) {
    const std::string extension = path.extension().string();
    if (path != known && fs::is_regular_file(path, code) && (extension == ".json" || extension == ".gltf")) {
      check_json_file(path, findings);
    }
    return;
  }
  const Result<std::vector<fs::path>> entries = list_folder(path);
  if (!entries) {
    add(findings, Severity::kError, "verify.folder", entries.error().message, path, entries.error().remedy);
    return;
  }
  for (const fs::path& entry : *entries) {
    if (!fs::is_symlink(entry, code) || !fs::is_directory(entry, code)) {  // a link may lead round in a circle
      check_json_files(entry, known, findings);
    }
  }
}

// Exactly the header for `frames`, and nothing behind the last one.
Status repair_signal(const fs::path& path, const acquire::StreamFormat& format, const SignalFile& signal) {
  const std::string header = acquire::wav_header(format, signal.frames);
  const auto fail = [&](const std::string& what) {
    return Error{what, path.string(), "check that you may write there and that the disk has room"};
  };
  if (signal.data_offset != header.size()) {
    return Error{"was not written by Limbwave, so that its header is left alone", path.string(),
                 "import the file into a new take"};
  }
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) {
    return fail(std::string("cannot be written (") + std::strerror(errno) + ")");
  }
  const auto end =
      static_cast<off_t>(header.size() + static_cast<std::uint64_t>(signal.frames) * format.bytes_per_frame());
  const bool ok = ::pwrite(file, header.data(), header.size(), 0) == static_cast<ssize_t>(header.size()) &&
                  ::ftruncate(file, end) == 0 && ::fsync(file) == 0;
  const int reason = errno;
  ::close(file);
  return ok ? Status{} : fail(std::string("writing failed (") + std::strerror(reason) + ")");
}

// What `write_file` leaves when it is killed.
void remove_parts(const fs::path& folder) {
  std::error_code code;
  for (const fs::path& entry : entries_of(folder)) {
    const std::string name = entry.filename().string();
    if (name.starts_with("take.json.part") || name.starts_with("events.jsonl.part")) {
      fs::remove(entry, code);
    }
  }
}

// What saving a solve leaves when it is killed: ".NAME.part" is half of a new one, ".NAME.old" a whole old one.
void settle_solves(const fs::path& solves, Diagnostics& done) {
  constexpr std::string_view kPart = ".part";
  constexpr std::string_view kOld = ".old";
  std::error_code code;
  for (const fs::path& entry : entries_of(solves)) {
    const std::string name = entry.filename().string();
    if (!name.starts_with('.')) {
      continue;
    }
    if (name.ends_with(kPart)) {
      fs::remove_all(entry, code);
    } else if (name.ends_with(kOld)) {
      const fs::path target = solves / name.substr(1, name.size() - 1 - kOld.size());
      if (fs::exists(target, code)) {
        fs::remove_all(entry, code);
        continue;
      }
      fs::rename(entry, target, code);
      if (!code) {
        add(done, Severity::kInfo, "recover.solve", "was being replaced and was put back", target);
      }
    }
  }
}

// Cuts a last line off that is not whole; anything else stays.
Status repair_events(const fs::path& path, Diagnostics& done) {
  std::error_code code;
  if (!fs::exists(path, code)) {
    return write_file(path, "");
  }
  const Result<std::string> text = read_file(path);
  if (!text) {
    return text.error();
  }
  if (text->empty() || text->back() == '\n') {
    return {};
  }
  const std::size_t newline = text->rfind('\n');
  const std::size_t begin = newline == std::string::npos ? 0 : newline + 1;
  if (parse_json(std::string_view(*text).substr(begin), path.string())) {
    return write_file(path, *text + "\n");
  }
  add(done, Severity::kInfo, "recover.events", "the last event had been cut off and was removed", path);
  return write_file(path, text->substr(0, begin));
}

}  // namespace

Result<VerifyReport> verify_take(const fs::path& folder) {
  const Result<Take> take = open_take(folder);
  if (!take) {
    return take.error();
  }
  VerifyReport report{take->diagnostics};
  const Result<SignalFile> signal = inspect_signal(take->signal_path(), take->info.format);
  if (!signal) {
    return signal.error();
  }
  std::error_code code;
  if (!fs::exists(folder / "events.jsonl", code)) {
    add(report.findings, Severity::kWarning, "verify.events", "is missing", folder / "events.jsonl",
        "run `limbwave recover` to make an empty one");
  }
  check_header(*take, *signal, report.findings);
  check_segments(*take, report.findings);
  check_rig(take->info, folder / "take.json", report.findings);
  check_samples(*take, report.findings);
  check_json_files(folder, folder / "take.json", report.findings);
  return report;
}

Result<Diagnostics> recover_take(const fs::path& folder) {
  std::error_code code;
  Result<Take> take = open_take(folder);
  if (!take && fs::exists(folder / "take.json", code) && fs::exists(folder / "signal.wav", code) &&
      take.error().place.find("take.json") != std::string::npos) {
    // A damaged take.json: kept for whoever can read it, and made again from the header of the samples.
    fs::rename(folder / "take.json", folder / "take.json.damaged", code);
    const Error damage = take.error();
    take = open_take(folder);
    if (!take) {
      fs::rename(folder / "take.json.damaged", folder / "take.json", code);
      return damage;
    }
  }
  if (!take) {
    return take.error();
  }
  Diagnostics done;
  const bool lost_info = has_finding(*take, "take.no-info");
  const Result<SignalFile> signal = inspect_signal(take->signal_path(), take->info.format);
  if (!signal) {
    return signal.error();
  }
  if (signal->being_written) {
    return Error{"is being recorded right now", folder.string(), "stop the recording first"};
  }
  remove_parts(folder);
  settle_solves(folder / "solves", done);
  if (signal->header_frames != signal->frames || signal->partial_bytes != 0 || !signal->header_readable) {
    if (Status status = repair_signal(take->signal_path(), take->info.format, *signal); !status) {
      return status.error();
    }
    add(done, Severity::kInfo, "recover.header",
        fmt::format("the header now says {} frames instead of {}", signal->frames, signal->header_frames),
        take->signal_path());
  }
  if (Status status = repair_events(folder / "events.jsonl", done); !status) {
    return status.error();
  }
  if (!take->info.complete || take->info.frames != signal->frames || lost_info ||
      worst(take->diagnostics) == Severity::kError) {
    take->info.complete = true;
    take->info.frames = signal->frames;
    for (TakeSegment& segment : take->info.segments) {
      if (segment.first.value + segment.count.value > signal->frames) {
        add(done, Severity::kWarning, "recover.segment",
            fmt::format("segment \"{}\" reached beyond the end of the take and was shortened", segment.name),
            folder / "take.json");
      }
      segment.first.value = std::min(segment.first.value, signal->frames);
      segment.count.value = std::min(segment.count.value, signal->frames - segment.first.value);
    }
    if (Status status = save_info(*take); !status) {
      return status.error();
    }
    add(done, Severity::kInfo, "recover.closed",
        fmt::format("the take is closed with {:.2f} s",
                    take->info.format.rate.seconds(SampleCount{signal->frames}).value),
        folder);
    if (has_finding(*take, "take.calibration")) {
      add(done, Severity::kWarning, "recover.calibration", "the calibration was not of this rig and was removed",
          folder / "take.json", "calibrate again");
    }
    if (lost_info) {
      add(done, Severity::kWarning, "recover.rig",
          "take.json was made again: the rig is taken to be \"" + take->info.rig.name + "\"", folder / "take.json",
          "correct it there when another one was worn");
    }
  }
  return done;
}

}  // namespace limbwave::take
