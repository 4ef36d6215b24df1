#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "base/files.h"
#include "base/json_reader.h"
#include "evaluate/evaluate.h"
#include "interchange/text_scan.h"

namespace limbwave::evaluate {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

// Quaternions in files are unit to the digits they are written with.
constexpr double kUnitTolerance = 0.01;

const Vector3d kUnknown = Vector3d::Constant(NAN);

// `count` finite numbers of a JSON array.
bool read_numbers(const nlohmann::json& json, std::size_t count, double* numbers) {
  if (!json.is_array() || json.size() != count) {
    return false;
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!json[i].is_number()) {
      return false;
    }
    numbers[i] = json[i].get<double>();
    if (!std::isfinite(numbers[i])) {
      return false;
    }
  }
  return true;
}

bool is_unit(const Quaterniond& q) {
  return std::abs(q.norm() - 1.0) <= kUnitTolerance;
}

void read_segment(const JsonReader& reader, double rate_hz, Truth& truth) {
  Truth::SegmentTruth segment;
  segment.name = reader.at("name").string();
  const JsonReader q = reader.at("q_WL");
  if (!q.raw().is_array()) {
    q.fail("is not a list");
    return;
  }
  const nlohmann::json none = nlohmann::json::array();
  const nlohmann::json& positions = reader.has("p_WL") ? reader.raw()["p_WL"] : none;
  if (!positions.is_array() || (reader.has("p_WL") && positions.size() != q.raw().size())) {
    reader.at("p_WL").fail("does not have as many samples as q_WL");
    return;
  }
  for (std::size_t i = 0; i < q.raw().size(); ++i) {
    const nlohmann::json& sample = q.raw()[i];
    if (sample.is_null()) {
      continue;
    }
    std::array<double, 4> n{};
    const bool read = read_numbers(sample, 4, n.data());
    const Quaterniond R(n[0], n[1], n[2], n[3]);
    if (!read || !is_unit(R)) {
      q.fail(fmt::format("sample {} is neither a unit quaternion [w, x, y, z] nor null", i));
      return;
    }
    Vector3d p = kUnknown;
    if (i < positions.size() && !positions[i].is_null() && !read_numbers(positions[i], 3, p.data())) {
      reader.at("p_WL").fail(fmt::format("sample {} is neither [x, y, z] nor null", i));
      return;
    }
    segment.times.push_back(static_cast<double>(i) / rate_hz);
    segment.R_WL.push_back(R.normalized());
    segment.p_WL.push_back(p);
  }
  truth.segments.push_back(std::move(segment));
}

// The cells of one line; quotes may enclose commas and doubled quotes.
void split(std::string_view line, std::vector<std::string>& cells) {
  std::size_t n = 0;
  const auto next = [&]() -> std::string& {
    if (n == cells.size()) {
      cells.emplace_back();
    }
    cells[n].clear();
    return cells[n++];
  };
  std::string* cell = &next();
  bool inside = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') {
      if (inside && i + 1 < line.size() && line[i + 1] == '"') {
        *cell += '"';
        ++i;
      } else {
        inside = !inside;
      }
    } else if (line[i] == ',' && !inside) {
      cell = &next();
    } else {
      *cell += line[i];
    }
  }
  cells.resize(n);
}

std::string trimmed(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

constexpr std::array<const char*, 9> kColumns = {"time_s", "segment", "qw", "qx", "qy", "qz", "px_m", "py_m", "pz_m"};

class CsvTruth {
 public:
  explicit CsvTruth(std::string place) : place_(std::move(place)) {}

  Result<Truth> read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) {
      text.remove_prefix(3);
    }
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      split(text.substr(0, end), cells_);
      text.remove_prefix(std::min(end + 1, text.size()));
      ++line_;
      const bool blank = cells_.size() == 1 && trimmed(cells_[0]).empty();
      Status status;
      if (!has_header_) {
        status = header();
      } else if (!blank) {
        status = row();
      }
      if (!status) {
        return status.error();
      }
    }
    if (!has_header_) {
      return error("is empty", "start with the line time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m");
    }
    return std::move(truth_);
  }

 private:
  [[nodiscard]] Error error(std::string message, std::string remedy) const {
    return {std::move(message), fmt::format("{}:{}", place_, std::max<std::size_t>(line_, 1)), std::move(remedy)};
  }

  Status header() {
    has_header_ = true;
    where_.fill(-1);
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const auto* const found = std::find(kColumns.begin(), kColumns.end(), trimmed(cells_[c]));
      if (found != kColumns.end()) {
        where_[static_cast<std::size_t>(found - kColumns.begin())] = static_cast<int>(c);
      }
    }
    for (std::size_t c = 0; c < 6; ++c) {
      if (where_[c] < 0) {
        return error(fmt::format("has no column {}", kColumns[c]),
                     "start with the line time_s,segment,qw,qx,qy,qz,px_m,py_m,pz_m");
      }
    }
    return {};
  }

  // A number; NaN for an empty or missing cell.
  Status number(std::size_t column, double& value) const {
    value = NAN;
    const int at = where_[column];
    if (at < 0 || static_cast<std::size_t>(at) >= cells_.size()) {
      return {};
    }
    const std::string cell = trimmed(cells_[static_cast<std::size_t>(at)]);
    const char* p = cell.data();
    const char* const end = p + cell.size();
    if (cell.empty() || (interchange::scan_number(p, end, value) && p == end)) {
      return {};
    }
    return error(fmt::format("{} is \"{}\", which is not a number", kColumns[column], cell),
                 "write numbers with a decimal point");
  }

  Status row() {
    std::array<double, 9> v{};
    for (std::size_t c = 0; c < v.size(); ++c) {
      if (c == 1) {
        continue;
      }
      if (Status status = number(c, v[c]); !status) {
        return status;
      }
    }
    if (std::isnan(v[0])) {
      return error("has no time", "fill in time_s");
    }
    const auto name_at = static_cast<std::size_t>(where_[1]);
    const std::string name = name_at < cells_.size() ? trimmed(cells_[name_at]) : "";
    if (name.empty()) {
      return error("has no segment", "fill in the segment's name");
    }
    const Quaterniond R(v[2], v[3], v[4], v[5]);
    if (!R.coeffs().allFinite()) {
      return {};  // not known at this time
    }
    if (!is_unit(R)) {
      return error(fmt::format("the quaternion has length {:.3f} instead of 1", R.norm()), "write qw,qx,qy,qz");
    }
    const auto [found, added] = index_.try_emplace(name, truth_.segments.size());
    if (added) {
      truth_.segments.emplace_back().name = name;
    }
    Truth::SegmentTruth& segment = truth_.segments[found->second];
    if (!segment.times.empty() && v[0] <= segment.times.back()) {
      return error(fmt::format("the time of \"{}\" does not increase", name), "sort the rows by time");
    }
    const Vector3d p(v[6], v[7], v[8]);
    segment.times.push_back(v[0]);
    segment.R_WL.push_back(R.normalized());
    segment.p_WL.push_back(p.allFinite() ? p : kUnknown);
    return {};
  }

  std::string place_;
  Truth truth_;
  std::vector<std::string> cells_;
  std::array<int, 9> where_{};
  std::unordered_map<std::string, std::size_t> index_;
  std::size_t line_ = 0;
  bool has_header_ = false;
};

}  // namespace

Result<Truth> truth_from_json(std::string_view text, const std::string& place) {
  const Result<nlohmann::json> json = parse_json(text, place);
  if (!json) {
    return json.error();
  }
  JsonReader::State state{place, {}};
  const JsonReader reader(*json, "", state);
  reader.at("schema").integer(1, 1);
  const double rate_hz = reader.at("rate_hz").number(1e-3, 1e6);
  Truth truth;
  for (const JsonReader& segment : reader.at("segments").items()) {
    if (!state.error) {
      read_segment(segment, rate_hz, truth);
    }
  }
  if (state.error) {
    return *state.error;
  }
  return truth;
}

Result<Truth> truth_from_csv(std::string_view text, const std::string& place) {
  return CsvTruth(place).read(text);
}

Result<Truth> load_truth(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file);
  if (!text) {
    return text.error();
  }
  return truth_from_json(*text, file.string());
}

Result<Truth> load_truth_csv(const std::filesystem::path& file) {
  const Result<std::string> text = read_file(file);
  if (!text) {
    return text.error();
  }
  return truth_from_csv(*text, file.string());
}

}  // namespace limbwave::evaluate
