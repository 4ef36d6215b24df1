#include "evaluate/radio_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/files.h"

namespace limbwave::evaluate {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kLargest = std::size_t{1} << 30U;
constexpr double kOutlier = 0.5;      // metres
constexpr double kMostBetween = 0.1;  // seconds between two poses that still give one in between
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string_view trimmed(std::string_view text) {
  const auto space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && space(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && space(text.back())) {
    text.remove_suffix(1);
  }
  return text;
}

std::optional<double> number(std::string_view text) {
  text = trimmed(text);
  double value = 0.0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t at = line.find(separator);
    parts.push_back(line.substr(0, at));
    if (at == std::string_view::npos) {
      return parts;
    }
    line.remove_prefix(at + 1);
  }
}

// "2022-08-15 9:37:27.039": seconds since midnight of the day.
std::optional<double> clock_time(std::string_view text) {
  const std::size_t space = text.find(' ');
  if (space == std::string_view::npos) {
    return std::nullopt;
  }
  const auto parts = split(text.substr(space + 1), ':');
  if (parts.size() != 3) {
    return std::nullopt;
  }
  const auto hours = number(parts[0]);
  const auto minutes = number(parts[1]);
  const auto seconds = number(parts[2]);
  return hours && minutes && seconds ? std::optional(3600.0 * *hours + 60.0 * *minutes + *seconds) : std::nullopt;
}

struct TimedRow {
  double time_s = 0.0;
  std::vector<double> values;
};

// Rows of a time and numbers; a first line that does not begin with a time is a heading.
Result<std::vector<TimedRow>> load_rows(const std::filesystem::path& file, std::size_t columns) {
  const Result<std::string> text = read_file(file, kLargest);
  if (!text) {
    return text.error();
  }
  std::vector<TimedRow> rows;
  int line_number = 0;
  for (const std::string_view line : split(*text, '\n')) {
    ++line_number;
    if (trimmed(line).empty()) {
      continue;
    }
    const auto cells = split(line, ',');
    const auto time = clock_time(trimmed(cells[0]));
    if (!time && line_number == 1) {
      continue;
    }
    if (!time || cells.size() < columns + 1 || (!rows.empty() && *time < rows.back().time_s)) {
      return Error{fmt::format("is not a time that goes on and {} numbers", columns),
                   fmt::format("{}:{}", file.string(), line_number), "correct the line"};
    }
    TimedRow row{*time, {}};
    for (std::size_t i = 1; i <= columns; ++i) {
      row.values.push_back(number(cells[i]).value_or(kNone));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

// Rows "| Tag 0 | x | y | z |" of the tables.
std::vector<Vector3d> table(std::string_view text, std::string_view what) {
  std::vector<Vector3d> places;
  for (const std::string_view line : split(text, '\n')) {
    const auto cells = split(line, '|');
    if (cells.size() < 5 || !trimmed(cells[1]).starts_with(what)) {
      continue;
    }
    const auto x = number(cells[2]);
    const auto y = number(cells[3]);
    const auto z = number(cells[4]);
    if (x && y && z) {
      places.emplace_back(*x, *y, *z);
    }
  }
  return places;
}

std::optional<RadioRecording::Pose> pose_at(const RadioRecording& recording, double time_s) {
  const auto after = std::upper_bound(recording.poses.begin(), recording.poses.end(), time_s,
                                      [](double t, const auto& pose) { return t < pose.time_s; });
  if (after == recording.poses.begin() || after == recording.poses.end()) {
    return std::nullopt;
  }
  const auto before = after - 1;
  const double length = after->time_s - before->time_s;
  if (length > kMostBetween || length <= 0.0) {
    return std::nullopt;
  }
  const double u = (time_s - before->time_s) / length;
  return RadioRecording::Pose{time_s, (1.0 - u) * before->p_WB + u * after->p_WB, before->R_WB.slerp(u, after->R_WB)};
}

double at_fraction(std::vector<double>& sorted, double fraction) {
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(fraction * static_cast<double>(sorted.size() - 1))];
}

struct Errors {
  double median = 0, mean = 0, sd = 0, p95 = 0, max = 0;  // millimetres
  explicit Errors(const std::vector<double>& errors) {
    if (errors.empty()) {
      return;
    }
    std::vector<double> absolute;
    double sum = 0.0;
    double square = 0.0;
    double total = 0.0;
    for (const double error : errors) {
      absolute.push_back(std::abs(error));
      sum += error;
      square += error * error;
      total += std::abs(error);
    }
    std::sort(absolute.begin(), absolute.end());
    const auto n = static_cast<double>(errors.size());
    median = 1e3 * at_fraction(absolute, 0.5);
    mean = 1e3 * total / n;
    sd = 1e3 * std::sqrt(std::max(0.0, square / n - (sum / n) * (sum / n)));
    p95 = 1e3 * at_fraction(absolute, 0.95);
    max = 1e3 * absolute.back();
  }
};

}  // namespace

Result<std::vector<RadioRecording>> load_radio_recordings(const std::filesystem::path& folder) {
  const std::filesystem::path readme = folder / "README.upstream.md";
  const Result<std::string> text = read_file(readme, std::size_t{1} << 24U);
  if (!text) {
    return text.error();
  }
  const std::vector<Vector3d> anchors = table(*text, "Anchor");
  std::vector<Vector3d> tags = table(*text, "Tag");
  if (anchors.empty() || tags.empty()) {
    return Error{"has no tables of anchors and tags", readme.string(), "use the folder with the recordings"};
  }
  for (Vector3d& tag : tags) {
    tag = {tag.x(), -tag.y(), -tag.z()};
  }
  std::vector<std::filesystem::path> files;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(folder, code); !code && entry != std::filesystem::directory_iterator();
       entry.increment(code)) {
    const std::string name = entry->path().filename().string();
    if (name.starts_with("UWB_") && name.ends_with(".csv")) {
      files.push_back(entry->path());
    }
  }
  std::sort(files.begin(), files.end());
  std::vector<RadioRecording> recordings;
  for (const std::filesystem::path& file : files) {
    RadioRecording recording;
    recording.name = file.stem().string().substr(4);
    recording.anchors_W = anchors;
    recording.tags_B = tags;
    const auto ranges = load_rows(file, anchors.size() * tags.size());
    if (!ranges) {
      return ranges.error();
    }
    const auto poses = load_rows(folder / ("motion_capture_" + recording.name + ".csv"), 7);
    if (!poses) {
      return poses.error();
    }
    if (ranges->empty()) {
      return Error{"has no ranges", file.string(), "use another one"};
    }
    const double start = ranges->front().time_s;
    for (const TimedRow& row : *ranges) {
      recording.rows.push_back({row.time_s - start, row.values});
    }
    for (const TimedRow& row : *poses) {
      const std::vector<double>& v = row.values;
      if (std::all_of(v.begin(), v.end(), [](double value) { return std::isfinite(value); })) {
        recording.poses.push_back(
            {row.time_s - start, {v[0], v[1], v[2]}, Eigen::Quaterniond(v[3], v[4], v[5], v[6]).normalized()});
      }
    }
    recordings.push_back(std::move(recording));
  }
  if (recordings.empty()) {
    return Error{"has no files UWB_*.csv", folder.string(), "use the folder with the recordings"};
  }
  return recordings;
}

decode::RangeGateParameters radio_parameters(const RadioRecording& recording) {
  decode::RangeGateParameters parameters;
  Vector3d low = recording.anchors_W.front();
  Vector3d high = low;
  Vector3d sum = Vector3d::Zero();
  for (const Vector3d& anchor : recording.anchors_W) {
    low = low.cwiseMin(anchor);
    high = high.cwiseMax(anchor);
    sum += anchor;
  }
  // Reflections in a room put ultra-wideband ranges off by a decimetre for some seconds; a trolley or a walker is slow.
  parameters.wander_sd = 0.10;
  parameters.wander_s = 4.0;
  parameters.acceleration = 1.0;
  parameters.place = sum / static_cast<double>(recording.anchors_W.size());
  parameters.place_sd = (high - low).cwiseMax(Vector3d::Constant(0.3));
  return parameters;
}

RadioStatistics evaluate_radio(const RadioRecording& recording, const decode::RangeGateParameters& parameters,
                               std::size_t first, std::size_t last) {
  std::vector<decode::RangeGate> gates;
  for (std::size_t tag = 0; tag < recording.tags_B.size(); ++tag) {
    gates.emplace_back(recording.anchors_W, static_cast<int>(tag), parameters);
  }
  RadioStatistics statistics;
  struct Raw {
    double error;
    bool accepted;
  };
  std::vector<std::vector<Raw>> by_pair(recording.anchors_W.size() * gates.size());
  std::vector<double> raw;
  std::vector<double> accepted;
  std::vector<double> places;
  double normalised = 0.0;
  const std::size_t tags = gates.size();
  for (std::size_t r = first; r < std::min(last, recording.rows.size()); ++r) {
    const RadioRecording::Row& row = recording.rows[r];
    const auto pose = pose_at(recording, row.time_s);
    for (std::size_t i = 0; i < row.ranges.size(); ++i) {
      const std::size_t anchor = i / tags;
      const std::size_t tag = i % tags;
      const decode::RangeReading reading =
          gates[tag].push(static_cast<int>(anchor), Seconds{row.time_s}, row.ranges[i]);
      if (!pose || reading.verdict == decode::RangeVerdict::kNothingHeard) {
        continue;
      }
      const Vector3d p_W = pose->p_WB + pose->R_WB * recording.tags_B[tag];
      const double truth = (p_W - recording.anchors_W[anchor]).norm();
      const bool believed = reading.verdict == decode::RangeVerdict::kAccepted;
      raw.push_back(row.ranges[i] - truth);
      by_pair[i].push_back({raw.back(), believed});
      if (!believed) {
        continue;
      }
      const double error = reading.range - truth;
      accepted.push_back(error);
      normalised += error * error / reading.variance;
    }
    for (std::size_t tag = 0; tag < tags && pose; ++tag) {
      if (gates[tag].running()) {
        const Vector3d p_W = pose->p_WB + pose->R_WB * recording.tags_B[tag];
        places.push_back((gates[tag].place() - p_W).head<2>().norm());
      }
    }
  }
  for (std::vector<Raw>& pair : by_pair) {
    if (pair.empty()) {
      continue;
    }
    std::vector<Raw> sorted = pair;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end(),
                     [](const Raw& a, const Raw& b) { return a.error < b.error; });
    for (const Raw& range : pair) {
      const bool outlier = std::abs(range.error - middle->error) > kOutlier;
      statistics.outliers += outlier ? 1 : 0;
      statistics.outliers_accepted += outlier && range.accepted ? 1 : 0;
    }
  }
  const Errors of_raw(raw);
  const Errors of_accepted(accepted);
  statistics.count = static_cast<std::int64_t>(raw.size());
  statistics.accepted = static_cast<std::int64_t>(accepted.size());
  statistics.raw_median_mm = of_raw.median;
  statistics.raw_sd_mm = of_raw.sd;
  statistics.raw_p95_mm = of_raw.p95;
  statistics.raw_max_mm = of_raw.max;
  statistics.median_mm = of_accepted.median;
  statistics.mean_mm = of_accepted.mean;
  statistics.sd_mm = of_accepted.sd;
  statistics.p95_mm = of_accepted.p95;
  statistics.max_mm = of_accepted.max;
  statistics.normalised_rms = accepted.empty() ? 0.0 : std::sqrt(normalised / static_cast<double>(accepted.size()));
  std::sort(places.begin(), places.end());
  statistics.place_median_mm = 1e3 * at_fraction(places, 0.5);
  return statistics;
}

nlohmann::json radio_to_json(const RadioStatistics& s) {
  return {{"count", s.count},
          {"accepted", s.accepted},
          {"raw_median_mm", s.raw_median_mm},
          {"raw_sd_mm", s.raw_sd_mm},
          {"raw_p95_mm", s.raw_p95_mm},
          {"raw_max_mm", s.raw_max_mm},
          {"median_mm", s.median_mm},
          {"mean_mm", s.mean_mm},
          {"sd_mm", s.sd_mm},
          {"p95_mm", s.p95_mm},
          {"max_mm", s.max_mm},
          {"normalised_rms", s.normalised_rms},
          {"outliers", s.outliers},
          {"outliers_accepted", s.outliers_accepted},
          {"place_median_mm", s.place_median_mm}};
}

}  // namespace limbwave::evaluate
