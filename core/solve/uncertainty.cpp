#include "solve/uncertainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/units.h"

namespace limbwave::solve {
namespace {

constexpr double kStep_s = 0.1;
constexpr std::string_view kHead = "time_s,segment,joint_sigma_deg,point_sigma_mm";

std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\n") == std::string::npos) {
    return name;
  }
  std::string text = "\"";
  for (const char c : name) {
    text += c == '"' ? "\"\"" : std::string(1, c);
  }
  return text + "\"";
}

bool number(std::string_view text, double& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && std::isfinite(value);
}

}  // namespace

std::string uncertainty_to_csv(const Solve::Uncertainty& uncertainty, const body::Skeleton& skeleton) {
  std::string text(kHead);
  text += '\n';
  double next = -1e300;
  const std::size_t times = std::min({uncertainty.times.size(), uncertainty.joint.size(), uncertainty.point.size()});
  for (std::size_t i = 0; i < times; ++i) {
    if (uncertainty.times[i] < next || uncertainty.joint[i].size() != skeleton.segments.size() ||
        uncertainty.point[i].size() != skeleton.segments.size()) {
      continue;
    }
    next = uncertainty.times[i] + kStep_s - 1e-6;
    for (std::size_t s = 0; s < skeleton.segments.size(); ++s) {
      text += fmt::format("{:.4f},{},{:.4g},{:.4g}\n", uncertainty.times[i], quoted(skeleton.segments[s].name),
                          degrees(static_cast<double>(uncertainty.joint[i][s])),
                          1e3 * static_cast<double>(uncertainty.point[i][s]));
    }
  }
  return text;
}

Result<Solve::Uncertainty> uncertainty_from_csv(std::string_view text, const body::Skeleton& skeleton,
                                                const std::string& place) {
  Solve::Uncertainty result;
  const std::size_t segments = skeleton.segments.size();
  std::size_t line_number = 0, rows = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (++line_number == 1) {
      continue;
    }
    // Names may hold commas; numbers do not.
    const std::size_t first = line.find(','), last = line.rfind(',');
    const std::size_t middle = last == std::string_view::npos || last == 0 ? last : line.rfind(',', last - 1);
    double time = 0.0, joint = 0.0, point = 0.0;
    if (first == std::string_view::npos || middle == std::string_view::npos || middle <= first ||
        !number(line.substr(0, first), time) || !number(line.substr(middle + 1, last - middle - 1), joint) ||
        !number(line.substr(last + 1), point)) {
      return Error{"is no time, name and two numbers", fmt::format("{}:{}", place, line_number),
                   "solve the take again"};
    }
    if (rows % segments == 0) {
      result.times.push_back(time);
      result.joint.emplace_back();
      result.point.emplace_back();
    }
    result.joint.back().push_back(static_cast<float>(radians(joint)));
    result.point.back().push_back(static_cast<float>(1e-3 * point));
    ++rows;
  }
  if (segments == 0 || rows % segments != 0 || !std::is_sorted(result.times.begin(), result.times.end())) {
    return Error{"does not name every segment at every time", place, "solve the take again"};
  }
  return result;
}

double joint_sigma_deg(const Solve::Uncertainty& uncertainty, std::size_t segment, double time_s) {
  const auto& times = uncertainty.times;
  if (times.empty()) {
    return 0.0;
  }
  auto at = std::lower_bound(times.begin(), times.end(), time_s);
  if (at == times.end() || (at != times.begin() && time_s - *(at - 1) < *at - time_s)) {
    --at;
  }
  const auto& row = uncertainty.joint[static_cast<std::size_t>(at - times.begin())];
  return segment < row.size() ? degrees(static_cast<double>(row[segment])) : 0.0;
}

}  // namespace limbwave::solve
