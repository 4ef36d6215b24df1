#include "simulate/recorded_forces.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>

#include "base/folder.h"
#include "geometry/so3.h"
#include "simulate/jets.h"

namespace limbwave::simulate {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kSizeLimit = std::size_t{1} << 29U;
constexpr double kWrapBlend = 0.5;  // seconds

// The whole file, unpacked if it is gzip.
Result<std::string> read_unpacked(const fs::path& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) {
    return Error{"cannot be read", path.string(), "check the name and the permissions"};
  }
  std::string text;
  std::array<char, 65536> buffer{};
  int count = 0;
  while ((count = gzread(file, buffer.data(), buffer.size())) > 0 && text.size() <= kSizeLimit) {
    text.append(buffer.data(), static_cast<std::size_t>(count));
  }
  const bool whole = gzclose_r(file) == Z_OK && count == 0;
  if (text.size() > kSizeLimit) {
    return Error{"is larger than 512 MB unpacked", path.string(), "cut it into shorter logs"};
  }
  if (!whole) {
    return Error{"is damaged or cut short", path.string(), "copy it again"};
  }
  return text;
}

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \r\n\t");
  return first == std::string_view::npos ? std::string_view{}
                                         : text.substr(first, text.find_last_not_of(" \r\n\t") - first + 1);
}

std::vector<std::string_view> split(std::string_view line, char separator) {
  std::vector<std::string_view> cells;
  while (true) {
    const std::size_t end = line.find(separator);
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == std::string_view::npos) {
      return cells;
    }
    line.remove_prefix(end + 1);
  }
}

// Number, empty cell or nonsense.
enum class Cell { kNumber, kEmpty, kBad };
Cell parse_cell(const std::vector<std::string_view>& cells, std::ptrdiff_t column, double& value) {
  if (column < 0 || column >= std::ssize(cells) || cells[static_cast<std::size_t>(column)].empty()) {
    return Cell::kEmpty;
  }
  const std::string_view cell = cells[static_cast<std::size_t>(column)];
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return error == std::errc{} && end == cell.data() + cell.size() && std::isfinite(value) ? Cell::kNumber : Cell::kBad;
}

// Several columns that belong together: all numbers, or empty when any is.
Cell parse_cells(const std::vector<std::string_view>& cells, const std::vector<std::ptrdiff_t>& columns,
                 std::vector<double>& values) {
  values.assign(columns.size(), 0.0);
  Cell result = Cell::kNumber;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Cell cell = parse_cell(cells, columns[i], values[i]);
    if (cell == Cell::kBad) {
      return cell;
    }
    result = cell == Cell::kEmpty ? cell : result;
  }
  return result;
}

// Which columns of a file mean what; -1 where there is none.
struct Layout {
  char separator = ',';
  std::vector<std::ptrdiff_t> time, force, truth;
  std::ptrdiff_t sensor = -1;
  bool truth_is_matrix = false;
  double rate_hz = 0.0;  // of a packet counter; 0 when the time column is in seconds
};

Result<Layout> layout_of(const std::vector<std::string_view>& header, char separator, double rate_hz,
                         const std::string& place) {
  Layout layout;
  layout.separator = separator;
  const auto column = [&](std::string_view name) {
    const auto found = std::find(header.begin(), header.end(), name);
    return found == header.end() ? std::ptrdiff_t{-1} : found - header.begin();
  };
  const auto columns = [&](std::initializer_list<const char*> names) {
    std::vector<std::ptrdiff_t> list;
    for (const char* name : names) {
      list.push_back(column(name));
    }
    return list;
  };
  if (column("PacketCounter") >= 0) {
    layout.time = columns({"PacketCounter"});
    layout.force = columns({"Acc_X", "Acc_Y", "Acc_Z"});
    layout.truth = columns({"Mat[1][1]", "Mat[1][2]", "Mat[1][3]", "Mat[2][1]", "Mat[2][2]", "Mat[2][3]", "Mat[3][1]",
                            "Mat[3][2]", "Mat[3][3]"});
    layout.truth_is_matrix = true;
    layout.rate_hz = rate_hz;
    if (rate_hz <= 0.0) {
      return Error{"has a PacketCounter but no line \"// Update Rate: ...Hz\"", place,
                   "export it again with its header"};
    }
  } else {
    layout.time = columns({"time_s"});
    layout.sensor = column("sensor");
    layout.force = columns({"ax_m_s2", "ay_m_s2", "az_m_s2"});
    layout.truth = columns({"truth_qw", "truth_qx", "truth_qy", "truth_qz"});
  }
  if (layout.time[0] < 0 || std::count(layout.force.begin(), layout.force.end(), -1) > 0) {
    return Error{"has no columns time_s, ax_m_s2, ay_m_s2, az_m_s2 (nor PacketCounter, Acc_X, Acc_Y, Acc_Z)", place,
                 "name the columns in its first line"};
  }
  return layout;
}

std::optional<Quaterniond> orientation_of(const std::vector<double>& v, bool matrix) {
  if (matrix) {
    Eigen::Matrix3d R;
    R << v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8];
    return std::abs(R.determinant() - 1.0) < 0.05 ? std::optional(Quaterniond(geometry::nearest_rotation(R)))
                                                  : std::nullopt;
  }
  const Quaterniond q(v[0], v[1], v[2], v[3]);
  return std::abs(q.norm() - 1.0) < 0.05 ? std::optional(q.normalized()) : std::nullopt;
}

// Takes a file apart line by line.
class LogParser {
 public:
  explicit LogParser(std::string file) : file_(std::move(file)) {}

  Status line(std::string_view line) {
    ++number_;
    if (trimmed(line).empty()) {
      return {};
    }
    if (line.starts_with("//")) {
      if (const std::size_t at = line.find("Update Rate:"); at != std::string_view::npos) {
        const std::string_view value = trimmed(line.substr(at + 12));
        std::from_chars(value.data(), value.data() + value.size(), rate_hz_);
      }
      return {};
    }
    if (!layout_) {
      const char separator = line.find('\t') != std::string_view::npos ? '\t' : ',';
      const Result<Layout> found = layout_of(split(line, separator), separator, rate_hz_, place());
      if (!found) {
        return found.error();
      }
      layout_ = *found;
      return {};
    }
    return row(split(line, layout_->separator));
  }

  Result<std::vector<ForceLog>> finish() {
    for (const ForceLog& log : logs_) {
      if (log.times.size() < 16 || log.duration() < 4.0 * kWrapBlend) {
        return Error{"holds less than two seconds of accelerations" + (log.name.empty() ? "" : " of " + log.name),
                     file_, "use a longer log"};
      }
    }
    if (logs_.empty()) {
      return Error{"holds no accelerations", file_, "use another log"};
    }
    return std::move(logs_);
  }

 private:
  [[nodiscard]] std::string place() const { return fmt::format("{}:{}", file_, number_); }

  Status row(const std::vector<std::string_view>& cells) {
    double time = 0.0;
    if (parse_cell(cells, layout_->time[0], time) != Cell::kNumber) {
      return Error{"has no time", place(), "correct or remove the line"};
    }
    if (layout_->rate_hz > 0.0) {  // the counter has 16 bits
      counter_turns_ += time < last_counter_ - 32768.0 ? 65536.0 : 0.0;
      last_counter_ = time;
      time = (time + counter_turns_) / layout_->rate_hz;
    }
    const Cell force = parse_cells(cells, layout_->force, values_);
    if (force == Cell::kBad) {
      return Error{"has an acceleration that is no number", place(), "correct or remove the line"};
    }
    if (force == Cell::kEmpty) {
      return {};
    }
    ForceLog& log = log_of(layout_->sensor < std::ssize(cells) && layout_->sensor >= 0
                               ? cells[static_cast<std::size_t>(layout_->sensor)]
                               : std::string_view{});
    if (!log.times.empty() && time <= log.times.back()) {
      return Error{"goes back in time", place(), "sort the rows by time"};
    }
    log.times.push_back(time);
    log.f_S.emplace_back(values_[0], values_[1], values_[2]);
    const Cell truth = parse_cells(cells, layout_->truth, values_);
    if (truth == Cell::kBad) {
      return Error{"has an orientation that is no number", place(), "correct it or leave it empty"};
    }
    log.R_WS.push_back(truth == Cell::kNumber ? orientation_of(values_, layout_->truth_is_matrix) : std::nullopt);
    return {};
  }

  ForceLog& log_of(std::string_view name) {
    const auto found = std::find_if(logs_.begin(), logs_.end(), [&](const ForceLog& log) { return log.name == name; });
    if (found != logs_.end()) {
      return *found;
    }
    logs_.emplace_back().name = std::string(name);
    return logs_.back();
  }

  std::string file_;
  int number_ = 0;
  std::optional<Layout> layout_;
  double rate_hz_ = 0.0;
  double counter_turns_ = 0.0;
  double last_counter_ = -1.0;
  std::vector<double> values_;
  std::vector<ForceLog> logs_;
};

}  // namespace

Result<std::vector<ForceLog>> read_force_file(const fs::path& path) {
  const Result<std::string> text = read_unpacked(path);
  if (!text) {
    return text.error();
  }
  LogParser parser(path.string());
  std::string_view rest = *text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (Status parsed = parser.line(rest.substr(0, end)); !parsed) {
      return parsed.error();
    }
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return parser.finish();
}

RecordedForces::RecordedForces(std::vector<ForceLog> logs, int sensors) : logs_(std::move(logs)) {
  const auto count = static_cast<int>(logs_.size());
  const int shares = (sensors + count - 1) / count;
  duration_ = logs_.front().duration();
  for (const ForceLog& log : logs_) {
    duration_ = std::min(duration_, log.duration());
  }
  for (int s = 0; s < sensors; ++s) {
    const ForceLog& log = logs_[static_cast<std::size_t>(s % count)];
    const int share = s / count;
    starts_.push_back(log.duration() * share / shares);
  }
}

RecordedForces::Place RecordedForces::place(int sensor, double time_s) const {
  const ForceLog& log = logs_[static_cast<std::size_t>(sensor) % logs_.size()];
  const double length = log.duration();
  const double t = std::fmod(starts_[static_cast<std::size_t>(sensor)] + time_s, length);
  return {&log, log.times.front() + (t < 0.0 ? t + length : t)};
}

Vector3d RecordedForces::force(int sensor, double time_s) const {
  const auto [log, t] = place(sensor, time_s);
  const auto& times = log->times;
  const auto& f = log->f_S;
  const auto last = times.size() - 1;
  const auto next = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
  const std::size_t b = std::clamp<std::size_t>(next, 1, last);
  const std::size_t a = b - 1;
  // Cubic Hermite with the slopes of the neighbours' chord.
  const auto slope = [&](std::size_t i) -> Vector3d {
    const std::size_t before = i == 0 ? 0 : i - 1;
    const std::size_t after = std::min(i + 1, last);
    return (f[after] - f[before]) / (times[after] - times[before]);
  };
  const double h = times[b] - times[a];
  const double u = std::clamp((t - times[a]) / h, 0.0, 1.0);
  const double v = 1.0 - u;
  Vector3d force =
      v * v * (1.0 + 2.0 * u) * f[a] + u * u * (3.0 - 2.0 * u) * f[b] + u * v * h * (v * slope(a) - u * slope(b));
  const double to_end = times.back() - t;
  if (to_end < kWrapBlend) {
    const double s = smooth_step(1.0 - to_end / kWrapBlend).v;
    force = (1.0 - s) * force + s * f.front();
  }
  return force;
}

std::optional<Quaterniond> RecordedForces::orientation(int sensor, double time_s) const {
  const auto [log, t] = place(sensor, time_s);
  const auto& times = log->times;
  if (times.back() - t < kWrapBlend) {
    return std::nullopt;
  }
  const auto next = static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
  const std::size_t b = std::clamp<std::size_t>(next, 1, times.size() - 1);
  const auto& before = log->R_WS[b - 1];
  const auto& after = log->R_WS[b];
  // Across lost packets the truth is not known either.
  if (!before || !after || times[b] - times[b - 1] > 0.05) {
    return std::nullopt;
  }
  return before->slerp((t - times[b - 1]) / (times[b] - times[b - 1]), *after);
}

Result<std::vector<ForceLog>> read_force_logs(const std::string& source, int sensors) {
  std::vector<fs::path> files;
  std::error_code ignored;
  if (fs::is_directory(source, ignored)) {
    const Result<std::vector<fs::path>> entries = list_folder(source);
    if (!entries) {
      return entries.error();
    }
    for (const fs::path& entry : *entries) {
      const std::string name = entry.filename().string();
      if (name.ends_with(".csv") || name.ends_with(".csv.gz") ||
          (name.ends_with(".txt") && !name.starts_with("LICENSE") && !name.starts_with("README"))) {
        files.push_back(entry);
      }
    }
    if (files.empty()) {
      return Error{"holds no .csv, .csv.gz or .txt logs", source, "name the folder with the logs"};
    }
  } else {
    for (const std::string_view part : split(source, ';')) {
      files.emplace_back(part);
    }
  }
  std::vector<ForceLog> logs;
  for (const fs::path& file : files) {
    if (logs.size() >= static_cast<std::size_t>(sensors)) {
      break;
    }
    Result<std::vector<ForceLog>> read = read_force_file(file);
    if (!read) {
      return read.error();
    }
    std::move(read->begin(), read->end(), std::back_inserter(logs));
  }
  logs.resize(std::min(logs.size(), static_cast<std::size_t>(sensors)));
  // Logs of one recording share a clock: start them all where the last one starts.
  double start = logs.front().times.front();
  for (const ForceLog& log : logs) {
    start = std::max(start, log.times.front());
  }
  for (ForceLog& log : logs) {
    const auto skip = std::lower_bound(log.times.begin(), log.times.end(), start) - log.times.begin();
    if (skip < std::ssize(log.times) / 2) {  // else they have nothing to do with each other
      log.times.erase(log.times.begin(), log.times.begin() + skip);
      log.f_S.erase(log.f_S.begin(), log.f_S.begin() + skip);
      log.R_WS.erase(log.R_WS.begin(), log.R_WS.begin() + skip);
    }
  }
  return logs;
}

}  // namespace limbwave::simulate
