#include "simulate/truth.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/json_text.h"
#include "simulate/text_file.h"

namespace limbwave::simulate {
namespace {

std::string text(const std::string& value) {
  return json_text(value);
}

const char* comma(bool first) {
  return first ? "" : ",";
}

}  // namespace

Status write_truth(const std::filesystem::path& path, const Simulation& simulation, const SimulateSettings& settings,
                   std::int64_t frames, const std::vector<double>& cycle_starts, const Progress& progress) {
  const Wearer& wearer = *simulation.wearer;
  const LineInStream& stream = *simulation.stream;
  const double rate = settings.format.rate.hz;
  const auto samples = static_cast<std::int64_t>(std::ceil(static_cast<double>(frames) / rate * kTruthRateHz));
  const std::size_t segments = simulation.skeleton.segments.size();
  const auto real_time = [&](std::int64_t i) { return stream.real_time(static_cast<double>(i) / kTruthRateHz * rate); };

  // Evaluated once for all segments; the file holds one list per segment.
  std::vector<std::vector<std::optional<Quaterniond>>> q(segments);
  std::vector<std::vector<Vector3d>> p(segments);
  for (std::int64_t i = 0; i < samples; ++i) {
    const double t = real_time(i);
    const auto poses = wearer.poses(t);
    for (std::size_t s = 0; s < segments; ++s) {
      q[s].push_back(wearer.orientation(static_cast<int>(s), t));
      p[s].push_back(poses[s].p_WL);
    }
    if (i % 1024 == 0 &&
        !progress.report(0.5 * static_cast<double>(i) / static_cast<double>(samples), "writing the truth")) {
      return cancelled();
    }
  }

  TextFile file(path);
  file.add("{{\"schema\":1,\"rate_hz\":{},\n\"segments\":[", kTruthRateHz);
  for (std::size_t s = 0; s < segments; ++s) {
    file.add("{}\n{{\"name\":{},\"q_WL\":[", comma(s == 0), text(simulation.skeleton.segments[s].name));
    for (std::size_t i = 0; i < q[s].size(); ++i) {
      if (const auto& R = q[s][i]) {
        file.add("{}[{:.8f},{:.8f},{:.8f},{:.8f}]", comma(i == 0), R->w(), R->x(), R->y(), R->z());
      } else {
        file.add("{}null", comma(i == 0));
      }
    }
    file.add("],\n\"p_WL\":[");
    for (std::size_t i = 0; i < p[s].size(); ++i) {
      file.add("{}[{:.6f},{:.6f},{:.6f}]", comma(i == 0), p[s][i].x(), p[s][i].y(), p[s][i].z());
    }
    file.add("]}}");
  }
  file.add("],\n\"sensors\":[");
  for (std::size_t s = 0; s < wearer.sensors().size(); ++s) {
    const ActualSensor& sensor = wearer.sensors()[s];
    const Matrix3d& M = sensor.M;
    file.add("{}\n{{\"name\":{},\"serial\":{},\"segment\":{},", comma(s == 0), text(sensor.name), text(sensor.serial),
             text(simulation.skeleton.segments[static_cast<std::size_t>(sensor.segment)].name));
    file.add("\"offset_g\":[{:.9f},{:.9f},{:.9f}],", sensor.offset_g.x(), sensor.offset_g.y(), sensor.offset_g.z());
    file.add("\"M\":[[{:.9f},{:.9f},{:.9f}],[{:.9f},{:.9f},{:.9f}],[{:.9f},{:.9f},{:.9f}]],", M(0, 0), M(0, 1), M(0, 2),
             M(1, 0), M(1, 1), M(1, 2), M(2, 0), M(2, 1), M(2, 2));
    file.add("\"R_LS\":[{:.9f},{:.9f},{:.9f},{:.9f}],\"p_LS\":[{:.6f},{:.6f},{:.6f}],\n\"f_S_m_s2\":[", sensor.R_LS.w(),
             sensor.R_LS.x(), sensor.R_LS.y(), sensor.R_LS.z(), sensor.p_LS.x(), sensor.p_LS.y(), sensor.p_LS.z());
    for (std::int64_t i = 0; i < samples; ++i) {
      const Vector3d f = wearer.specific_force(static_cast<int>(s), real_time(i));
      file.add("{}[{:.6f},{:.6f},{:.6f}]", comma(i == 0), f.x(), f.y(), f.z());
    }
    file.add("]}}");
    if (!progress.report(0.5 + 0.5 * static_cast<double>(s + 1) / static_cast<double>(wearer.sensors().size()),
                         "writing the truth")) {
      return cancelled();
    }
  }
  file.add("],\n\"cycles\":{{\"start_s\":[");
  bool first = true;
  for (const double start : cycle_starts) {
    const double frame = stream.frame_at(start);
    if (frame >= 0.0 && frame < static_cast<double>(frames)) {
      file.add("{}{:.9f}", comma(first), frame / rate);
      first = false;
    }
  }
  nlohmann::json errors = errors_to_json(settings.errors);
  errors["name"] = settings.errors_name;
  file.add("]}},\n\"motion\":{},\"seed\":{},\n\"errors\":{}}}\n", text(settings.motion), settings.seed,
           json_text(errors));
  if (!file.close()) {
    return Error{"cannot be written", path.string(), "check the space on the disk"};
  }
  return {};
}

}  // namespace limbwave::simulate
