#include "solve/report_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"

namespace limbwave::solve {
namespace {

constexpr const char* kPolarityNames[] = {"auto", "normal", "inverted"};

decode::Polarity polarity_from(const JsonReader& reader) {
  const std::string text = reader.string();
  for (int i = 0; i < 3; ++i) {
    if (text == kPolarityNames[i]) {
      return static_cast<decode::Polarity>(i);
    }
  }
  reader.fail("is \"" + text + "\"", "use auto, normal or inverted");
  return decode::Polarity::kAuto;
}

Smoothing smoothing_from(const JsonReader& reader) {
  const std::string text = reader.string();
  const std::optional<Smoothing> known = smoothing_named(text);
  if (!known) {
    reader.fail("is \"" + text + "\"", "use chain, adaptive, bridging or none");
  }
  return known.value_or(Smoothing::kAdaptive);
}

std::vector<std::vector<HeadingKey>> headings_from(const JsonReader& reader) {
  std::vector<std::vector<HeadingKey>> headings;
  for (const JsonReader& segment : reader.items()) {
    std::vector<HeadingKey> keys;
    for (const JsonReader& key : segment.items()) {
      const std::vector<double> pair = key.numbers(2);
      if (!keys.empty() && pair[0] <= keys.back().time_s) {
        key.fail("is not later than the key before");
      }
      keys.push_back({pair[0], pair[1]});
    }
    headings.push_back(std::move(keys));
  }
  return headings;
}

}  // namespace

std::string_view name(Smoothing smoothing) {
  switch (smoothing) {
    case Smoothing::kNone:
      return "none";
    case Smoothing::kAdaptive:
      return "adaptive";
    case Smoothing::kBridging:
      return "bridging";
    case Smoothing::kChain:
      return "chain";
  }
  return "unknown";
}

std::optional<Smoothing> smoothing_named(std::string_view wanted) {
  const auto found = std::find_if(kSmoothings.begin(), kSmoothings.end(),
                                  [&](Smoothing smoothing) { return name(smoothing) == wanted; });
  return found == kSmoothings.end() ? std::nullopt : std::optional<Smoothing>(*found);
}

std::vector<std::string> report_lines(const Solve& solve) {
  const QualityReport& report = solve.report;
  std::vector<std::string> lines;
  lines.push_back(fmt::format("{:.1f} s solved in {:.2f} s (decoding {:.2f} s, estimating {:.2f} s)",
                              report.take_seconds, report.decode_seconds + report.solve_seconds, report.decode_seconds,
                              report.solve_seconds));
  lines.push_back("calibration: " + report.calibration);
  if (report.line.cycles > 0) {
    lines.push_back(fmt::format(
        "line: {:.2f} cycles/s, jitter {:.3f} %, coupling {:.2f} ± {:.2f} Hz, noise {:.1f} dB, {} cycles, {} lost",
        report.line.cycle_rate_hz, 100.0 * report.line.clock_jitter, report.line.left_coupling_hz,
        report.line.coupling_sd_hz, 20.0 * std::log10(std::max(report.line.noise, 1e-12)), report.line.cycles,
        report.line.lost_cycles));
  }
  for (const SensorQuality& sensor : report.sensors) {
    lines.push_back(fmt::format(
        "{:<12} usable {:5.1f} %, gravity explains {:5.1f} %, {}", sensor.sensor, 100.0 * sensor.usable,
        100.0 * sensor.trusted,
        sensor.mean_norm_g > 0.0 ? fmt::format("{:.3f} g at rest", sensor.mean_norm_g) : std::string("never at rest")));
  }
  return lines;
}

nlohmann::json report_to_json(const Solve& solve) {
  const QualityReport& report = solve.report;
  nlohmann::json sensors = nlohmann::json::array();
  for (const SensorQuality& sensor : report.sensors) {
    sensors.push_back({{"sensor", sensor.sensor},
                       {"usable", sensor.usable},
                       {"trusted", sensor.trusted},
                       {"mean_norm_g", sensor.mean_norm_g}});
  }
  nlohmann::json diagnostics = nlohmann::json::array();
  for (const Diagnostic& diagnostic : report.diagnostics) {
    diagnostics.push_back({{"severity", name(diagnostic.severity)},
                           {"code", diagnostic.code},
                           {"message", diagnostic.message},
                           {"remedy", diagnostic.remedy},
                           {"place", diagnostic.place},
                           {"time_s", diagnostic.time_s}});
  }
  const decode::LineInStatus& line = report.line;
  nlohmann::json json = {
      {"calibration", report.calibration},
      {"sensors", sensors},
      {"line",
       {{"cycle_rate_hz", line.cycle_rate_hz},
        {"clock_jitter", line.clock_jitter},
        {"left_coupling_hz", line.left_coupling_hz},
        {"right_coupling_hz", line.right_coupling_hz},
        {"coupling_sd_hz", line.coupling_sd_hz},
        {"noise", line.noise},
        {"left_inverted", line.left_inverted},
        {"right_inverted", line.right_inverted},
        {"swapped", line.swapped},
        {"left_peak", line.left_peak},
        {"right_peak", line.right_peak},
        {"cycles", line.cycles},
        {"lost_cycles", line.lost_cycles},
        {"clipped_slots", line.clipped_slots}}},
      {"diagnostics", diagnostics},
      {"seconds", {{"take", report.take_seconds}, {"decode", report.decode_seconds}, {"solve", report.solve_seconds}}}};
  if (report.used_calibration) {
    json["used_calibration"] = calibrate::calibration_to_json(*report.used_calibration);
  }
  return json;
}

QualityReport report_from_json(const nlohmann::json& json) {
  QualityReport report;
  report.calibration = json.value("calibration", "");
  if (const auto used = json.find("used_calibration"); used != json.end()) {
    if (Result<calibrate::RigCalibration> read = calibrate::calibration_from_json(*used, "report"); read) {
      report.used_calibration = std::move(read).value();
    }
  }
  for (const nlohmann::json& entry : json.value("sensors", nlohmann::json::array())) {
    report.sensors.push_back({entry.value("sensor", ""), entry.value("usable", 0.0), entry.value("trusted", 0.0),
                              entry.value("mean_norm_g", 0.0)});
  }
  const nlohmann::json line = json.value("line", nlohmann::json::object());
  report.line.decided = report.line.locked = true;
  report.line.cycle_rate_hz = line.value("cycle_rate_hz", 0.0);
  report.line.clock_jitter = line.value("clock_jitter", 0.0);
  report.line.left_coupling_hz = line.value("left_coupling_hz", 0.0);
  report.line.right_coupling_hz = line.value("right_coupling_hz", 0.0);
  report.line.coupling_sd_hz = line.value("coupling_sd_hz", 0.0);
  report.line.noise = line.value("noise", 0.0);
  report.line.left_inverted = line.value("left_inverted", false);
  report.line.right_inverted = line.value("right_inverted", false);
  report.line.swapped = line.value("swapped", false);
  report.line.left_peak = line.value("left_peak", 0.0);
  report.line.right_peak = line.value("right_peak", 0.0);
  report.line.cycles = line.value("cycles", std::int64_t{0});
  report.line.lost_cycles = line.value("lost_cycles", std::int64_t{0});
  report.line.clipped_slots = line.value("clipped_slots", std::int64_t{0});
  for (const nlohmann::json& entry : json.value("diagnostics", nlohmann::json::array())) {
    const std::string severity = entry.value("severity", "warning");
    report.diagnostics.push_back({severity == "error"  ? Severity::kError
                                  : severity == "info" ? Severity::kInfo
                                                       : Severity::kWarning,
                                  entry.value("code", ""), entry.value("message", ""), entry.value("remedy", ""),
                                  entry.value("place", ""), entry.value("time_s", -1.0)});
  }
  const nlohmann::json seconds = json.value("seconds", nlohmann::json::object());
  report.take_seconds = seconds.value("take", 0.0);
  report.decode_seconds = seconds.value("decode", 0.0);
  report.solve_seconds = seconds.value("solve", 0.0);
  return report;
}

namespace {

BodyChoice body_choice_from(const JsonReader& reader, const std::string& method) {
  BodyChoice choice;
  if (method != "filter" && method != "smoother" && method != "batch") {
    reader.at("method").fail("must be inclination, filter, smoother or batch");
  }
  choice.method = method;
  choice.sensors = reader.string_or("sensors", choice.sensors);
  if (choice.sensors.empty() || choice.sensors.find_first_not_of("AGD") != std::string::npos) {
    reader.at("sensors").fail("must name some of A, G and D");
  }
  choice.root = reader.string_or("root", "");
  if (reader.has("tune")) {
    choice.tune = reader.at("tune").boolean();
  }
  return choice;
}

}  // namespace

nlohmann::json settings_to_json(const SolveSettings& settings) {
  nlohmann::json headings = nlohmann::json::array();
  for (const std::vector<HeadingKey>& keys : settings.headings) {
    nlohmann::json list = nlohmann::json::array();
    for (const HeadingKey& key : keys) {
      list.push_back({key.time_s, key.heading});
    }
    headings.push_back(std::move(list));
  }
  nlohmann::json line = {{"left", kPolarityNames[static_cast<int>(settings.line_in.left)]},
                         {"right", kPolarityNames[static_cast<int>(settings.line_in.right)]}};
  if (settings.line_in.swapped) {
    line["swapped"] = *settings.line_in.swapped;
  }
  if (settings.line_in.coupling_hz) {
    line["coupling_hz"] = *settings.line_in.coupling_hz;
  }
  nlohmann::json json = {{"schema", 1},
                         {"method", "inclination"},
                         {"smoothing", name(settings.smoothing)},
                         {"smoothing_s", settings.smoothing_s},
                         {"calibration", settings.calibration},
                         {"line_in", line},
                         {"headings_s_rad", headings}};
  if (const auto& body = settings.body) {
    json["method"] = body->method;
    json["sensors"] = body->sensors;
    json["root"] = body->root;
    json["tune"] = body->tune;
  }
  return json;
}

Result<SolveSettings> settings_from_json(const nlohmann::json& json, const std::string& place) {
  JsonReader::State state{place, {}};
  const JsonReader reader(json, "", state);
  reader.allow({"schema", "method", "smoothing", "smoothing_s", "calibration", "line_in", "headings_s_rad", "sensors",
                "root", "tune"});
  reader.at("schema").integer(1, 1);
  SolveSettings settings;
  if (const std::string method = reader.string_or("method", "inclination"); method != "inclination") {
    settings.body = body_choice_from(reader, method);
  }
  if (reader.has("smoothing")) {
    settings.smoothing = smoothing_from(reader.at("smoothing"));
  }
  settings.smoothing_s = reader.number_or("smoothing_s", settings.smoothing_s, estimate::kLeastSmoothing_s, 10.0);
  settings.calibration = reader.string_or("calibration", "auto");
  if (reader.has("line_in")) {
    const JsonReader line = reader.at("line_in");
    line.allow({"left", "right", "swapped", "coupling_hz"});
    settings.line_in.left = polarity_from(line.at("left"));
    settings.line_in.right = polarity_from(line.at("right"));
    if (line.has("swapped")) {
      settings.line_in.swapped = line.at("swapped").boolean();
    }
    if (line.has("coupling_hz")) {
      settings.line_in.coupling_hz = line.at("coupling_hz").number(0.0, 100.0);
    }
  }
  if (reader.has("headings_s_rad")) {
    settings.headings = headings_from(reader.at("headings_s_rad"));
  }
  if (state.error) {
    return *state.error;
  }
  return settings;
}

}  // namespace limbwave::solve
