#include "take/take.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "take/markers.h"
#include "take/signal_file.h"
#include "take/take_json.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kInfoLimit = std::size_t{64} << 20;

Diagnostic finding(Severity severity, const char* code, std::string message, const fs::path& place,
                   std::string remedy = {}) {
  return {severity, code, std::move(message), std::move(remedy), place.string(), -1.0};
}

// A take whose take.json is lost: the samples are what matters, the rig is assumed.
Result<TakeInfo> rebuild_info(const Take& take, Diagnostics& findings) {
  const std::optional<acquire::StreamFormat> format = format_from_header(take.signal_path());
  if (!format) {
    return Error{"is not a take: there is no take.json in it", take.folder.string(),
                 "name the folder of a take, or make one with `limbwave record` or `limbwave import`"};
  }
  Result<body::Rig> rig = body::load_rig("line-in-arm");
  if (!rig) {
    return rig.error();
  }
  Result<body::Skeleton> skeleton = body::load_skeleton(rig->skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  TakeInfo info;
  info.format = *format;
  info.rig = *std::move(rig);
  info.skeleton = *std::move(skeleton);
  findings.push_back(finding(Severity::kError, "take.no-info",
                             "is missing; the samples are there, and the rig is taken to be \"" + info.rig.name + "\"",
                             take.folder / "take.json", "put it back, or run `limbwave recover`"));
  return info;
}

Result<TakeInfo> read_info(const Take& take, Diagnostics& findings) {
  const fs::path path = take.folder / "take.json";
  std::error_code code;
  if (!fs::exists(path, code)) {
    return rebuild_info(take, findings);
  }
  const Result<std::string> text = read_file(path, kInfoLimit);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, path.string());
  if (!json) {
    return json.error();
  }
  Result<TakeInfo> info = info_from_json(*json, path.string());
  if (info && info->calibration) {
    // Everything that computes poses relies on one entry per sensor. The take is usable without this one.
    if (const Status fits = calibrate::check_calibration(*info->calibration, info->rig); !fits) {
      findings.push_back(finding(Severity::kError, "take.calibration", fits.error().message + "; it is not used", path,
                                 fits.error().remedy));
      info->calibration.reset();
    }
  }
  return info;
}

// One event per line that can be read; of lines that cannot, an empty one, so that lines keep their numbers.
std::vector<TakeEvent> read_event_lines(const fs::path& path, Diagnostics& findings) {
  std::vector<TakeEvent> events;
  std::error_code code;
  if (!fs::exists(path, code)) {
    return events;
  }
  const Result<std::string> text = read_file(path);
  if (!text) {
    findings.push_back(finding(Severity::kWarning, "take.events", text.error().message, path, text.error().remedy));
    return events;
  }
  std::size_t begin = 0;
  for (int number = 1; begin < text->size(); ++number) {
    const std::size_t end = text->find('\n', begin);
    const std::string_view line = std::string_view(*text).substr(begin, end - begin);
    const std::string place = fmt::format("{}:{}", path.string(), number);
    Result<TakeEvent> event = event_from_line(line, place);
    events.push_back(event ? *event : TakeEvent{});
    if (event) {
      // Taken above.
    } else if (end == std::string::npos) {
      findings.push_back(finding(Severity::kInfo, "take.event-cut-off", "the last event was cut off", place));
    } else {
      findings.push_back(
          {Severity::kWarning, "take.event", event.error().message, event.error().remedy, event.error().place, -1.0});
    }
    if (end == std::string::npos) {
      break;
    }
    begin = end + 1;
  }
  return events;
}

// How many frames the take has, by what its files agree on.
void settle_frames(Take& take, const SignalFile& signal) {
  const auto seconds = [&](std::int64_t frames) { return take.info.format.rate.seconds(SampleCount{frames}).value; };
  if (!take.info.complete) {
    take.info.frames = signal.frames;
    if (signal.being_written) {
      take.diagnostics.push_back(
          finding(Severity::kInfo, "take.recording", "is being recorded right now", take.folder));
    } else {
      take.diagnostics.push_back(
          finding(Severity::kWarning, "take.not-closed",
                  fmt::format("the recording was not closed properly; {:.2f} s are there", seconds(signal.frames)),
                  take.folder, "run `limbwave recover` to repair it; nothing is lost by that"));
    }
  } else if (signal.frames < take.info.frames) {
    take.diagnostics.push_back(finding(
        Severity::kError, "take.short",
        fmt::format("holds {:.2f} s, but {:.2f} s were recorded", seconds(signal.frames), seconds(take.info.frames)),
        take.signal_path(), "copy the take again"));
    take.info.frames = signal.frames;
  }
  if (!signal.header_readable && signal.file_bytes > 0) {
    take.diagnostics.push_back(finding(Severity::kWarning, "take.header", "the header is damaged", take.signal_path(),
                                       "run `limbwave recover` to repair it"));
  }
}

}  // namespace

TakeSegment TakeInfo::capture() const {
  const auto found = std::find_if(segments.begin(), segments.end(),
                                  [](const TakeSegment& segment) { return segment.name == "capture"; });
  const std::int64_t first = found == segments.end() ? 0 : std::min(found->first.value, frames);
  const std::int64_t count = found == segments.end() ? frames : found->count.value;
  return {"capture", SampleIndex{first}, SampleCount{std::min(count, frames - first)}};
}

Result<Take> open_take(const fs::path& folder) {
  std::error_code code;
  if (!fs::exists(folder, code)) {
    return Error{"does not exist", folder.string(), "check the path"};
  }
  if (!fs::is_directory(folder, code)) {
    return Error{"is a file, not the folder of a take", folder.string(),
                 "make a take of a recording with `limbwave import`"};
  }
  Take take;
  take.folder = folder;
  Result<TakeInfo> info = read_info(take, take.diagnostics);
  if (!info) {
    return info.error();
  }
  take.info = *std::move(info);
  if (take.info.kind == "log") {
    return take;  // readings of other sensors (take/body_log.h): there is no signal
  }
  const Result<SignalFile> signal = inspect_signal(take.signal_path(), take.info.format);
  if (!signal) {
    return signal.error();
  }
  settle_frames(take, *signal);
  take.events = events_in_force(read_event_lines(folder / "events.jsonl", take.diagnostics));
  std::erase_if(take.events, [](const TakeEvent& event) { return event.kind.empty(); });
  return take;
}

Status save_info(const Take& take) {
  // Bytes that are not UTF-8 (from a device's name) are replaced.
  constexpr auto kReplace = nlohmann::json::error_handler_t::replace;
  return write_file(take.folder / "take.json", info_to_json(take.info).dump(2, ' ', false, kReplace) + "\n");
}

Status append_event(const fs::path& folder, const TakeEvent& event) {
  const fs::path path = folder / "events.jsonl";
  std::string line = event_to_line(event) + "\n";
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  const off_t end = file < 0 ? 0 : ::lseek(file, 0, SEEK_END);
  char last = '\n';
  if (end > 0 && ::pread(file, &last, 1, end - 1) == 1 && last != '\n') {
    line.insert(0, 1, '\n');  // a crash cut the line before this one off
  }
  // One write, so that a line is there as a whole or not at all.
  const ssize_t written = file < 0 ? -1 : ::write(file, line.data(), line.size());
  const int reason = errno;
  if (file >= 0) {
    ::close(file);
  }
  if (written != static_cast<ssize_t>(line.size())) {
    return Error{std::string("the event could not be written (") + std::strerror(written < 0 ? reason : ENOSPC) + ")",
                 path.string(), "check that the disk has room"};
  }
  return {};
}

}  // namespace limbwave::take
