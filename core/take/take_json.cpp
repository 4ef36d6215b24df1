#include "take/take_json.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "base/json_reader.h"

namespace limbwave::take {
namespace {

constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;

acquire::StreamFormat read_format(const JsonReader& reader) {
  reader.allow({"rate_hz", "channels", "type"});
  acquire::StreamFormat format;
  format.rate = SampleRate{reader.at("rate_hz").number(1.0, 1e9)};
  format.channels = static_cast<int>(reader.at("channels").integer(1, 1024));
  const std::optional<acquire::SampleType> type = acquire::sample_type(reader.at("type").string());
  if (!type) {
    reader.at("type").fail("is not a known sample type", "int16, int24, int32 or float32");
  }
  format.type = type.value_or(acquire::SampleType::kInt16);
  return format;
}

TakeSegment read_segment(const JsonReader& reader) {
  reader.allow({"name", "first", "count"});
  return {reader.at("name").string(), SampleIndex{reader.at("first").integer(0, kMost)},
          SampleCount{reader.at("count").integer(0, kMost)}};
}

}  // namespace

Result<TakeInfo> info_from_json(const nlohmann::json& json, const std::string& place) {
  JsonReader::State state{place, {}};
  const JsonReader reader(json, "", state);
  TakeInfo info;
  if (reader.has("schema") && reader.at("schema").integer(1, std::numeric_limits<int>::max()) > 1) {
    return Error{"was written by a newer version of Limbwave", place, "open it with that version"};
  }
  reader.allow({"schema", "kind", "created", "subject", "source", "format", "complete", "frames", "samples_crc32",
                "rig", "skeleton", "calibration", "ranging", "segments"});
  info.schema = static_cast<int>(reader.at("schema").integer(1, 1));
  info.kind = reader.at("kind").string();
  if (info.kind != "line-in" && info.kind != "driver-box" && info.kind != "log") {
    reader.at("kind").fail("is \"" + info.kind + "\"", "this version reads \"line-in\", \"driver-box\" and \"log\"");
  }
  info.created = reader.string_or("created", "");
  info.subject = reader.string_or("subject", "");
  info.source = reader.string_or("source", "");
  info.format = read_format(reader.at("format"));
  info.complete = reader.at("complete").boolean();
  info.frames = reader.at("frames").integer(0, kMost);
  if (reader.has("samples_crc32")) {
    info.samples_crc32 =
        static_cast<std::uint32_t>(reader.at("samples_crc32").integer(0, std::numeric_limits<std::uint32_t>::max()));
  }
  if (reader.has("segments")) {
    for (const JsonReader& entry : reader.at("segments").items()) {
      info.segments.push_back(read_segment(entry));
    }
  }
  const nlohmann::json& rig_json = reader.at("rig").raw();
  const nlohmann::json& skeleton_json = reader.at("skeleton").raw();
  if (state.error) {
    return *state.error;
  }
  Result<body::Rig> rig = body::rig_from_json(rig_json, place + ": /rig");
  if (!rig) {
    return rig.error();
  }
  info.rig = *std::move(rig);
  Result<body::Skeleton> skeleton = body::skeleton_from_json(skeleton_json, place + ": /skeleton");
  if (!skeleton) {
    return skeleton.error();
  }
  info.skeleton = *std::move(skeleton);
  if (reader.has("calibration")) {
    Result<calibrate::RigCalibration> calibration =
        calibrate::calibration_from_json(reader.at("calibration").raw(), place + ": /calibration");
    if (!calibration) {
      return calibration.error();
    }
    info.calibration = *std::move(calibration);
  }
  if (reader.has("ranging")) {
    Result<calibrate::RangingCalibration> ranging =
        calibrate::ranging_calibration_from_json(reader.at("ranging").raw(), place + ": /ranging");
    if (!ranging) {
      return ranging.error();
    }
    info.ranging = *std::move(ranging);
  }
  return info;
}

nlohmann::json info_to_json(const TakeInfo& info) {
  nlohmann::json segments = nlohmann::json::array();
  for (const TakeSegment& segment : info.segments) {
    segments.push_back({{"name", segment.name}, {"first", segment.first.value}, {"count", segment.count.value}});
  }
  nlohmann::json json = {{"schema", info.schema},
                         {"kind", info.kind},
                         {"created", info.created},
                         {"subject", info.subject},
                         {"source", info.source},
                         {"format",
                          {{"rate_hz", info.format.rate.hz},
                           {"channels", info.format.channels},
                           {"type", acquire::name(info.format.type)}}},
                         {"complete", info.complete},
                         {"frames", info.frames},
                         {"segments", std::move(segments)},
                         {"rig", body::rig_to_json(info.rig)},
                         {"skeleton", body::skeleton_to_json(info.skeleton)}};
  if (info.samples_crc32) {
    json["samples_crc32"] = *info.samples_crc32;
  }
  if (info.calibration) {
    json["calibration"] = calibrate::calibration_to_json(*info.calibration);
  }
  if (info.ranging) {
    json["ranging"] = calibrate::ranging_calibration_to_json(*info.ranging);
  }
  return json;
}

Result<TakeEvent> event_from_line(std::string_view line, const std::string& place) {
  const Result<nlohmann::json> json = parse_json(line, place);
  if (!json) {
    return Error{json.error().message, place, json.error().remedy};
  }
  JsonReader::State state{place, {}};
  const JsonReader reader(*json, "", state);
  reader.allow({"sample", "kind", "text", "count"});
  TakeEvent event;
  event.sample = SampleIndex{reader.at("sample").integer(0, kMost)};
  event.kind = reader.at("kind").string();
  event.text = reader.string_or("text", "");
  event.count = reader.has("count") ? reader.at("count").integer(-kMost, kMost) : 0;
  if (state.error) {
    return *state.error;
  }
  return event;
}

std::string event_to_line(const TakeEvent& event) {
  const nlohmann::ordered_json json = {
      {"sample", event.sample.value}, {"kind", event.kind}, {"text", event.text}, {"count", event.count}};
  // Bytes that are not UTF-8 (from a device's name) are replaced: an event must never be lost to its spelling.
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace limbwave::take
