#include "take/import.h"

#include <fmt/format.h>

#include <algorithm>

#include "acquire/recording_file.h"
#include "take/recorder.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBlockFrames = 32768;

std::string describe(const acquire::StreamFormat& format) {
  return fmt::format("{} channels at {:.0f} Hz, {}", format.channels, format.rate.hz, acquire::name(format.type));
}

// All files before the first sample is copied, so that a wrong one is noticed at once. They are opened again to be
// read: there may be more parts than a process may have files open.
Result<std::vector<std::int64_t>> check_files(const std::vector<fs::path>& files,
                                              const acquire::RecordingOptions& reading, acquire::StreamFormat& format) {
  std::vector<std::int64_t> frames;
  for (const fs::path& path : files) {
    const Result<acquire::RecordingFile> file = acquire::RecordingFile::open(path, reading);
    if (!file) {
      return file.error();
    }
    if (file->format().channels != 2) {
      return Error{fmt::format("the recording has {} channels", file->format().channels), path.string(),
                   "export the two that carry the signal as a stereo file"};
    }
    if (frames.empty()) {
      format = file->format();
    } else if (file->format().rate != format.rate || file->format().channels != format.channels ||
               file->format().type != format.type) {
      return Error{fmt::format("has {}, but {} has {}", describe(file->format()), files.front().filename().string(),
                               describe(format)),
                   path.string(), "parts of one recording have the same format; import others into their own takes"};
    }
    frames.push_back(file->frames().value_or(0));
  }
  return frames;
}

Status copy(acquire::RecordingFile& file, Recorder& recorder, std::int64_t expected, const Progress& progress) {
  std::vector<std::byte> block(kBlockFrames * file.format().bytes_per_frame());
  const std::int64_t start = recorder.frames();
  for (;;) {
    const Result<std::size_t> got = file.read(block);
    if (!got) {
      return got.error();
    }
    if (*got == 0) {
      break;
    }
    if (Status status = recorder.write(std::span(block).first(*got)); !status) {
      return status;
    }
    const auto done = static_cast<double>(recorder.frames() - start);
    if (!progress.report(expected > 0 ? std::min(1.0, done / static_cast<double>(expected)) : 0.5, "importing")) {
      return cancelled();
    }
  }
  for (const Diagnostic& finding : file.diagnostics()) {
    if (finding.severity == Severity::kError) {
      return Error{finding.message, finding.place, finding.remedy};
    }
  }
  return {};
}

Status note_findings(const Diagnostics& findings, std::int64_t first_frame, Recorder& recorder) {
  for (const Diagnostic& finding : findings) {
    const std::string text = fs::path(finding.place).filename().string() + ": " + finding.message;
    if (Status status = recorder.add_event({SampleIndex{first_frame}, "import", text, 0}); !status) {
      return status;
    }
  }
  return {};
}

}  // namespace

Result<Take> import_recordings(const fs::path& folder, const std::vector<fs::path>& files, const body::Rig& rig,
                               const Progress& progress, const std::string& subject,
                               const acquire::RecordingOptions& reading) {
  if (files.empty()) {
    return Error{"there is no recording to import", folder.string(), "name at least one file"};
  }
  TakeInfo info;
  const Result<std::vector<std::int64_t>> lengths = check_files(files, reading, info.format);
  if (!lengths) {
    return lengths.error();
  }
  Result<body::Skeleton> skeleton = body::load_skeleton(rig.skeleton);
  if (!skeleton) {
    return skeleton.error();
  }
  info.rig = rig;
  info.skeleton = *std::move(skeleton);
  info.subject = subject;
  for (const fs::path& path : files) {
    info.source += (info.source.empty() ? "" : ", ") + path.filename().string();
  }
  RecorderSettings settings;
  settings.publish_at_close = true;  // the recorder's end discards everything unless it was closed
  Result<std::unique_ptr<Recorder>> recorder = Recorder::create(folder, std::move(info), settings);
  if (!recorder) {
    return recorder.error();
  }
  double total = 0.0;
  for (const std::int64_t length : *lengths) {
    total += static_cast<double>(std::max<std::int64_t>(length, 1));
  }
  Diagnostics findings;
  double before = 0.0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const double after = before + static_cast<double>(std::max<std::int64_t>((*lengths)[i], 1)) / total;
    Result<acquire::RecordingFile> file = acquire::RecordingFile::open(files[i], reading);
    if (!file) {
      return file.error();
    }
    const std::int64_t first_frame = (*recorder)->frames();
    if (Status status = copy(*file, **recorder, (*lengths)[i], progress.part(before, after)); !status) {
      return status.error();
    }
    const Diagnostics noticed = file->diagnostics();
    if (Status status = note_findings(noticed, first_frame, **recorder); !status) {
      return status.error();
    }
    findings.insert(findings.end(), noticed.begin(), noticed.end());
    before = after;
  }
  Result<Take> take = (*recorder)->close();
  if (take) {
    take->diagnostics.insert(take->diagnostics.end(), findings.begin(), findings.end());
  }
  return take;
}

}  // namespace limbwave::take
