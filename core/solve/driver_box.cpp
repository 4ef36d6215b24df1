#include "solve/driver_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <chrono>
#include <map>

#include "base/units.h"
#include "solve/pair_reach.h"
#include "take/take_reader.h"

namespace limbwave::solve {
namespace {

using Eigen::Vector3d;

constexpr double kTemperature = 22.0;
constexpr double kHumidity = 0.5;
constexpr double kReachMargin = 1.05;     // bones longer than the rig's
constexpr double kReachPlacement = 0.02;  // metres
constexpr double kTilted = radians(5.0);  // sources as they are mounted
constexpr double kWander = 3e-3;          // metres per radian, of a source on a segment whose every joint is followed
constexpr double kLooseWander = 12e-3;    // of others
constexpr std::size_t kBlockFrames = 28000;
constexpr double kLiveJoined = 0.0075;  // s: neighbouring words of 140 a second, whose clock may be off by 200 ppm
constexpr double kFilters = 0.003;      // s: low pass and clock of the words, the middle of a pulse, guards between

// Which boards sit beside the sources; boards and microphones of a wire are one piece.
decode::BoxGeometry box_geometry(const body::Rig& rig, const body::Skeleton& skeleton,
                                 const std::vector<body::SegmentPose>& poses, int reference) {
  const body::SegmentPose& frame = poses[static_cast<std::size_t>(reference)];
  decode::BoxGeometry geometry;
  std::map<int, int> wire_on;
  for (std::size_t w = 0; w < rig.microphones.size(); ++w) {
    const bool felt = w < rig.gyroscopes.size() && w < rig.accelerometers.size() &&
                      rig.gyroscopes[w].segment == rig.microphones[w].segment;
    const int segment = skeleton.find(rig.microphones[w].segment);
    geometry.R_CS_rest.emplace_back(body::Quaterniond::Identity());
    if (!felt || segment < 0) {
      continue;
    }
    const body::SegmentPose& pose = poses[static_cast<std::size_t>(segment)];
    geometry.R_CS_rest.back() = frame.R_WL.conjugate() * pose.R_WL * rig.gyroscopes[w].R_LS;
    wire_on.emplace(segment, static_cast<int>(w));
    if (segment == reference && geometry.reference < 0) {
      geometry.reference = static_cast<int>(w);
      geometry.reference_place = rig.microphones[w].p_LS;
    }
  }
  // Ways from the reference segment over joints, all at rest. A segment without a board turns as the next one does.
  const auto to_C = [&](const Vector3d& p_W) { return Vector3d(frame.R_WL.conjugate() * (p_W - frame.p_WL)); };
  const auto way_to = [&](int segment) {
    std::vector<int> up;  // the reference and what it hangs on
    for (int s = reference; s >= 0; s = skeleton.segments[static_cast<std::size_t>(s)].parent) {
      up.push_back(s);
    }
    std::vector<int> down;
    int common = segment;
    while (std::find(up.begin(), up.end(), common) == up.end()) {
      down.push_back(common);
      common = skeleton.segments[static_cast<std::size_t>(common)].parent;
    }
    std::vector<decode::BoxGeometry::Link> way;
    const auto add = [&](int turning, int joint_of) {
      const auto beside = wire_on.find(turning);
      way.push_back(
          {beside != wire_on.end() ? beside->second : -1, to_C(poses[static_cast<std::size_t>(joint_of)].p_WL)});
    };
    for (std::size_t i = 0; i < up.size() && up[i] != common; ++i) {
      add(up[i + 1], up[i]);
    }
    for (std::size_t i = down.size(); i-- > 0;) {
      add(down[i], down[i]);
    }
    geometry.complete.push_back(std::all_of(way.begin(), way.end(), [](const auto& link) { return link.wire >= 0; }));
    for (std::size_t i = way.size(); i-- > 1;) {
      way[i - 1].wire = way[i - 1].wire < 0 ? way[i].wire : way[i - 1].wire;
    }
    return way;
  };
  for (const body::Microphone& microphone : rig.microphones) {
    const int segment = std::max(0, skeleton.find(microphone.segment));
    const body::SegmentPose& pose = poses[static_cast<std::size_t>(segment)];
    geometry.boards.push_back(way_to(segment));
    geometry.complete.clear();
    geometry.board_places.push_back(to_C(pose.p_WL + pose.R_WL * microphone.p_LS));
  }
  for (const body::Source& source : rig.sources) {
    geometry.sources.push_back(way_to(std::max(0, skeleton.find(source.segment))));
  }
  return geometry;
}

// Everything in the frame of one segment.
decode::DriverBoxFormat::Frame frame_of(const body::Rig& rig, const body::Skeleton& skeleton,
                                        const std::vector<body::SegmentPose>& poses, decode::RangingFormat common,
                                        int reference, const calibrate::RangingCalibration& calibration) {
  decode::DriverBoxFormat::Frame in;
  const body::SegmentPose& frame = poses[static_cast<std::size_t>(reference)];
  for (std::size_t s = 0; s < rig.sources.size(); ++s) {
    const body::Source& worn = rig.sources[s];
    const int segment = std::max(0, skeleton.find(worn.segment));
    const body::SegmentPose& pose = poses[static_cast<std::size_t>(segment)];
    decode::RangingSource source;
    source.position = frame.R_WL.conjugate() * Vector3d(pose.p_WL + pose.R_WL * worn.p_LS - frame.p_WL);
    source.normal = frame.R_WL.conjugate() * Vector3d(pose.R_WL * worn.normal_L);
    source.fixed = segment == reference;
    if (s < calibration.sources.size()) {
      source.delay_s = calibration.sources[s].delay_s;
      source.phase = calibration.sources[s].phase;
      source.phase_2 = calibration.sources[s].phase_2;
      source.level = calibration.sources[s].level;
    }
    common.sources.push_back(source);
  }
  in.geometry = box_geometry(rig, skeleton, poses, reference);
  for (std::size_t s = 0; s < rig.sources.size(); ++s) {
    // What a joint does between two segments without a board is not told.
    common.sources[s].wander = in.geometry.complete[s] ? kWander : kLooseWander;
  }
  for (const body::Microphone& microphone : rig.microphones) {
    decode::RangingFormat wire = common;
    const int segment = std::max(0, skeleton.find(microphone.segment));
    const body::SegmentPose& pose = poses[static_cast<std::size_t>(segment)];
    wire.receiver = frame.R_WL.conjugate() * Vector3d(pose.p_WL + pose.R_WL * microphone.p_LS - frame.p_WL);
    for (std::size_t s = 0; s < rig.sources.size(); ++s) {
      const body::Source& worn = rig.sources[s];
      const PairReach reach = pair_reach(skeleton, std::max(0, skeleton.find(worn.segment)), worn.p_LS, worn.normal_L,
                                         segment, microphone.p_LS);
      wire.sources[s].reach = kReachPlacement + kReachMargin * reach.farthest;
      wire.sources[s].foremost = std::max(0.0, reach.foremost - kTilted);
    }
    in.wires.push_back(std::move(wire));
  }
  return in;
}

}  // namespace

decode::DriverBoxParameters live_decoding() {
  decode::DriverBoxParameters parameters;
  parameters.ranging.look_ahead_s = 0.0;
  parameters.words_joined_s = kLiveJoined;
  return parameters;
}

double live_settled_s(const decode::DriverBoxParameters& parameters, double word_rate_hz, double alignment_s) {
  return std::max(parameters.words_joined_s, alignment_s) + 2.0 / word_rate_hz + kFilters;
}

calibrate::RangingCalibration ranging_calibration(const take::TakeInfo& info) {
  if (info.ranging) {
    return *info.ranging;
  }
  calibrate::RangingCalibration nominal;
  nominal.method = "nominal";
  nominal.speed_of_sound = calibrate::speed_of_sound(kTemperature, kHumidity);
  return nominal;
}

decode::DriverBoxFormat driver_box_format(const body::Rig& rig, const body::Skeleton& skeleton,
                                          const calibrate::RangingCalibration& calibration) {
  assert(rig.driver_box);
  const body::DriverBoxSignal& box = *rig.driver_box;
  decode::DriverBoxFormat format;
  format.rate = SampleRate{box.rate_hz};
  format.words.word_rate_hz = box.word_rate_hz;
  format.words.clock_tolerance = box.word_clock_tolerance;
  format.words.gyroscope_range_rad_s = box.gyroscope_range_rad_s;
  format.words.accelerometer_range_m_s2 = box.accelerometer_range_g * kStandardGravity;
  format.words.carrier_hz = box.pulse_hz;

  decode::RangingFormat common;
  common.slot_samples = box.slot_samples;
  common.pulse_hz = box.pulse_hz;
  common.pulse_cycles = box.pulse_cycles;
  common.transducer_q = box.transducer_q;
  common.microphone_bandwidth_hz = box.microphone_bandwidth_hz;
  common.level_m = box.source_level_m;
  common.absorption_db_m = box.absorption_db_m;
  common.radiation = box.radiation;
  common.speed_of_sound = calibration.speed_of_sound;
  const std::vector<body::Quaterniond> rest(skeleton.segments.size(), body::Quaterniond::Identity());
  const auto poses = body::poses_from_joints(skeleton, rest, Vector3d::Zero());
  std::map<int, int> sources_on;
  int reference = 0;
  for (const body::Source& source : rig.sources) {
    const int segment = std::max(0, skeleton.find(source.segment));
    if (++sources_on[segment] > sources_on[reference]) {
      reference = segment;
    }
  }
  const auto in_frame = [&](int segment) { return frame_of(rig, skeleton, poses, common, segment, calibration); };
  decode::DriverBoxFormat::Frame first = in_frame(reference);
  format.wires = std::move(first.wires);
  format.geometry = std::move(first.geometry);
  for (const auto& [segment, count] : sources_on) {
    if (count > 0 && segment != reference && format.geometry.reference >= 0) {
      decode::DriverBoxFormat::Frame other = in_frame(segment);
      if (other.geometry.reference >= 0) {
        format.others.push_back(std::move(other));
      }
    }
  }
  return format;
}

Result<DriverBoxReport> decode_driver_box(const take::Take& take, const decode::DriverBoxParameters& parameters,
                                          const DriverBoxSink& sink, const Progress& progress) {
  const take::TakeInfo& info = take.info;
  if (!info.rig.driver_box || static_cast<std::size_t>(info.format.channels) != info.rig.microphones.size()) {
    return Error{fmt::format("has {} channels, but its rig is not that of a driver box with as many wires",
                             info.format.channels),
                 take.folder.string(), "use a take of a driver box"};
  }
  Result<take::TakeReader> reader = take::TakeReader::open(take);
  if (!reader) {
    return reader.error();
  }
  std::vector<std::pair<std::int64_t, std::int64_t>> gaps;
  for (const take::TakeEvent& event : take.events) {
    if (event.kind == "dropped" && event.count > 0) {
      gaps.emplace_back(event.sample.value, event.sample.value + event.count);
    }
  }
  std::sort(gaps.begin(), gaps.end());
  const auto start = std::chrono::steady_clock::now();
  decode::DriverBoxFormat format = driver_box_format(info.rig, info.skeleton, ranging_calibration(info));
  format.rate = info.format.rate;
  decode::DriverBoxDecoder decoder(format, parameters);
  const auto wires = static_cast<std::size_t>(info.format.channels);
  std::vector<float> block(kBlockFrames * wires);
  const double total = std::max<double>(1.0, static_cast<double>(reader->frames()));
  std::int64_t at = 0;
  std::size_t gap = 0;
  while (true) {
    if (!progress.report(static_cast<double>(at) / total, "decoding")) {
      return cancelled();
    }
    const Result<std::size_t> count = reader->next(block);
    if (!count) {
      return count.error();
    }
    const auto frames = static_cast<std::int64_t>(*count);
    // What was filled up where blocks were lost is not a signal.
    for (std::int64_t done = 0; done < frames;) {
      while (gap < gaps.size() && gaps[gap].second <= at + done) {
        ++gap;
      }
      const std::int64_t begin = gap < gaps.size() ? gaps[gap].first : INT64_MAX;
      const bool inside = begin <= at + done;
      const std::int64_t until = std::min(frames, (inside ? gaps[gap].second : begin) - at);
      if (inside) {
        decoder.gap(SampleCount{until - done});
      } else {
        decoder.push(std::span(block).subspan(static_cast<std::size_t>(done) * wires,
                                              static_cast<std::size_t>(until - done) * wires));
      }
      done = until;
    }
    at += frames;
    if (frames == 0) {
      decoder.finish();
    }
    if (Status status = sink(decoder.take_ranges(), decoder.take_inertial()); !status) {
      return status.error();
    }
    if (frames == 0) {
      break;
    }
  }
  DriverBoxReport report;
  for (std::size_t w = 0; w < wires; ++w) {
    report.words.push_back(decoder.words(static_cast<int>(w)));
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace limbwave::solve
