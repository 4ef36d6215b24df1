#include "solve/body_solve.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "base/units.h"
#include "estimate/body_batch.h"
#include "estimate/body_tuning.h"
#include "estimate/exact_rig.h"
#include "estimate/moving_start.h"
#include "estimate/sensor_mixup.h"
#include "solve/compose.h"
#include "solve/driver_box.h"
#include "solve/word_alignment.h"
#include "take/body_log.h"

namespace limbwave::solve {
namespace {

// The first segment's poses of a simulated take.
Result<std::vector<estimate::RootReading>> root_of_truth(const take::Take& take) {
  std::error_code code;
  if (std::filesystem::exists(take.folder / "truth.csv", code)) {
    return take::read_root_of_truth(take.folder / "truth.csv", take.info.skeleton.segments.front().name);
  }
  const std::filesystem::path file = take.folder / "truth.json";
  const Result<std::string> text = read_file(file, std::size_t{1} << 30);
  if (!text) {
    return Error{"has no truth", take.folder.string(), "give the root's path as a CSV file"};
  }
  const Result<nlohmann::json> json = parse_json(*text, file.string());
  if (!json) {
    return json.error();
  }
  std::vector<estimate::RootReading> path;
  try {
    const double rate = json->at("rate_hz").get<double>();
    const nlohmann::json& root = json->at("segments").at(0);
    const nlohmann::json& q = root.at("q_WL");
    const nlohmann::json& p = root.at("p_WL");
    for (std::size_t i = 0; i < q.size() && i < p.size(); ++i) {
      if (!q[i].is_null() && !p[i].is_null()) {
        path.push_back({static_cast<double>(i) / rate,
                        Eigen::Quaterniond(q[i].at(0).get<double>(), q[i].at(1).get<double>(), q[i].at(2).get<double>(),
                                           q[i].at(3).get<double>())
                            .normalized(),
                        Eigen::Vector3d(p[i].at(0).get<double>(), p[i].at(1).get<double>(), p[i].at(2).get<double>())});
      }
    }
  } catch (const nlohmann::json::exception&) {
    path.clear();
  }
  if (path.size() < 2) {
    return Error{"does not tell where the root was", file.string(), "give the root's path as a CSV file"};
  }
  return path;
}

void report_counts(const std::string& what, const std::string& name, const estimate::ReadingCount& count,
                   Diagnostics& diagnostics) {
  const std::int64_t all = count.used + count.gated + count.clipped + count.not_finite;
  const auto share = [&](std::int64_t part) { return 100.0 * static_cast<double>(part) / static_cast<double>(all); };
  if (all > 0 && share(count.gated) > 5.0) {
    diagnostics.push_back(
        {Severity::kWarning, "body." + what + "-rejected",
         fmt::format("{:.0f} % of {} readings of \"{}\" contradict all others", share(count.gated), what, name),
         "check where it is worn, and its calibration", name});
  }
  if (all > 0 && share(count.clipped) > 1.0) {
    diagnostics.push_back(
        {Severity::kWarning, "body." + what + "-clipped",
         fmt::format("{:.1f} % of {} readings of \"{}\" are beyond its range", share(count.clipped), what, name),
         "such movements need sensors of a wider range", name});
  }
}

}  // namespace

estimate::BodyFilterParameters body_parameters(const estimate::BodyModel& model, const BodySolveSettings& settings) {
  estimate::BodyFilterParameters p;
  const auto uses = [&](char sensor) { return settings.sensors.find(sensor) != std::string::npos; };
  p.use_accelerometers = uses('A');
  p.use_gyroscopes = uses('G');
  p.use_ranges = uses('D');
  const bool free = settings.root == "free" || settings.root == "contacts";
  p.root = settings.root == "fixed" ? estimate::RootMode::kFixed
           : free                   ? estimate::RootMode::kFree
                                    : estimate::RootMode::kGiven;
  if (model.skeleton.segments.size() == 1) {
    // A single thing in somebody's hand: where its sensor sits on it is all that is known, and it stays in reach.
    p.mount_rotation = p.mount_place = p.bone_scale = p.tissue_angle = p.acceleration_time = 0.0;
    p.root_speed = 0.3;
    p.root_reach = 0.15;
    p.acceleration_walk = 20000.0;
    p.root_acceleration_walk = 300.0;
    p.gyroscope_noise = p.gyroscope_relative = 0.005;
    p.gyroscope_bias = 0.01;
    p.gyroscope_bias_walk = 2e-4;
    p.accelerometer_noise = 0.05;
    p.accelerometer_relative = 0.01;
    p.accelerometer_bias = 0.05;
    p.accelerometer_bias_walk = 1e-4;
    p.gate_probability = 0.0;  // there is nothing that could contradict it
  }
  return p;
}

std::string usual_root(const take::Take& take) {
  return estimate::find_soles(estimate::body_model(take.info.rig, take.info.skeleton)).empty() ? "free" : "contacts";
}

estimate::BodyWatchParameters watch_parameters(const estimate::BodyModel& model, const BodySolveSettings& settings) {
  estimate::BodyWatchParameters watch;
  watch.rest.mode = settings.start;
  watch.contacts.feet = settings.root == "contacts";
  watch.stillness = model.skeleton.segments.size() > 1;  // a thing in a hand moves slowly without being still
  return watch;
}

namespace {

struct Ran {
  estimate::BodyRun run;
  Diagnostics found;
  std::vector<int> suspects;
};

// Once through the readings.
Result<Ran> run_once(const estimate::BodyModel& model, const estimate::BodyFilterParameters& parameters,
                     const estimate::BodyReadings& readings, const BodySolveSettings& settings,
                     const std::optional<estimate::BodyState>& near, const Progress& progress) {
  estimate::BodyWatch watch(model, watch_parameters(model, settings));
  if (near) {
    watch.start_near(*near);
  }
  if (!settings.resume.empty()) {
    const Result<std::string> text = read_file(settings.resume, std::size_t{1} << 28);
    if (!text) {
      return text.error();
    }
    Result<estimate::BodyMind> mind = estimate::mind_from_text(*text, settings.resume);
    if (!mind) {
      return mind.error();
    }
    watch.resume_from(*std::move(mind));
  }
  if (settings.optimise) {
    Result<estimate::BodyOptimum> optimum =
        estimate::optimise_body(model, parameters, readings, settings.rate_hz, progress, &watch);
    if (!optimum) {
      return optimum.error();
    }
    std::vector<int> suspects = estimate::suspicious_boards(model, optimum->run, watch);
    Diagnostics found = watch.findings();
    found.push_back(
        {Severity::kInfo, "body.optimised",
         fmt::format("the cost of the whole take fell by {:.2f} % in {} rounds",
                     100.0 * (1.0 - optimum->costs[optimum->best] / optimum->costs.front()), optimum->costs.size()),
         "", ""});
    return Ran{std::move(optimum->run), std::move(found), std::move(suspects)};
  }
  Result<estimate::BodyRun> run =
      settings.smooth ? estimate::smooth_body(model, parameters, readings, settings.rate_hz, progress, 1.5, &watch)
                      : estimate::filter_body(model, parameters, readings, settings.rate_hz, progress, &watch);
  if (!run) {
    Error error = run.error();
    error.place = error.place.empty() && !is_cancelled(error) ? settings.resume : error.place;
    return error;
  }
  if (!settings.save_state.empty() && watch.last_mind()) {
    if (Status saved = write_file(settings.save_state, estimate::mind_to_text(*watch.last_mind())); !saved) {
      return saved.error();
    }
  }
  std::vector<int> suspects = estimate::suspicious_boards(model, *run, watch);
  return Ran{*std::move(run), watch.findings(), std::move(suspects)};
}

// The same; and again, where two sensors are exchanged or one is turned.
Result<Ran> run_and_put_right(const estimate::BodyModel& model, const estimate::BodyFilterParameters& parameters,
                              estimate::BodyReadings& readings, const BodySolveSettings& settings,
                              const Progress& progress) {
  std::optional<estimate::BodyState> near;
  if (settings.smooth && settings.resume.empty()) {
    Result<std::optional<estimate::BodyState>> found = estimate::find_moving_start(
        model, parameters, watch_parameters(model, settings), readings, progress.part(0.0, 0.2));
    if (!found) {
      return found.error();
    }
    near = *std::move(found);
  }
  Result<Ran> ran = run_once(model, parameters, readings, settings, near, progress.part(0.2, 0.6));
  constexpr int kMost = 2;
  Diagnostics told;
  for (int i = 0; ran && i < kMost && !ran->suspects.empty() && settings.resume.empty() && model.boards.size() > 1;
       ++i) {
    const Result<std::optional<estimate::Mixup>> mixup = estimate::find_mixup(
        model, parameters, watch_parameters(model, settings), readings, ran->suspects, progress.part(0.6, 0.8));
    if (!mixup) {
      return mixup.error();
    }
    if (!mixup->has_value()) {
      break;
    }
    told.push_back(estimate::tell(**mixup, model));
    estimate::undo_mixup(**mixup, readings);
    near.reset();  // It was found with boards mixed up.
    ran = run_once(model, parameters, readings, settings, near, progress.part(0.8, 1.0));
  }
  if (ran) {
    if (near) {
      told.push_back({Severity::kInfo, "body.start-found",
                      "the pose in which the take begins was found from its first seconds", "", ""});
    }
    ran->found.insert(ran->found.begin(), told.begin(), told.end());
  }
  return ran;
}

Diagnostic tell(const estimate::BodyTuning& tuning) {
  std::string factors;
  bool at_end = false;
  for (const estimate::TunedNoise& noise : tuning.noises) {
    factors += fmt::format("{}{} × {:.2f}", factors.empty() ? "" : ", ", noise.what, noise.factor);
    at_end = at_end || std::abs(std::log2(noise.factor)) > 0.95 * std::log2(estimate::BodyTuningSettings{}.most);
  }
  return {
      Severity::kInfo, "body.tuned",
      fmt::format("noises by the likelihood of the first {:.0f} s: {}; its logarithm rose by {:.0f}", tuning.seconds,
                  factors, tuning.after - tuning.before),
      at_end ? "a factor at the end of its range says that the errors are not noise: compare with a solve without" : "",
      ""};
}

// What the root's place rests on, and how far it may be off in the end: said, not hidden.
void report_root(const estimate::BodyTrack& track, const std::string& root, Diagnostics& diagnostics) {
  const bool drifts = root == "free" || root == "contacts";
  std::string text = root == "fixed"      ? "root fixed: it stays at its place"
                     : root == "contacts" ? "root by the feet that stand (contacts)"
                     : root == "free"     ? "root free: by its own acceleration alone"
                                          : "root given: " + root;
  if (drifts && !track.root_sigma.empty()) {
    const Eigen::Vector3d& sigma = track.root_sigma.back();
    text += fmt::format("; its place is uncertain by {:.2f} m along the ground and {:.2f} m in height at the end (1 σ)",
                        std::hypot(sigma.x(), sigma.y()), sigma.z());
  }
  diagnostics.push_back(
      {Severity::kInfo, drifts ? "body.root-drift" : "body.root", text,
       root == "free" ? "choose --root contacts for somebody who stands or walks, or give its path" : "", ""});
}

}  // namespace

Result<Solve> solve_body(const take::Take& take, estimate::BodyReadings readings, const BodySolveSettings& settings,
                         const Progress& progress) {
  const auto start = std::chrono::steady_clock::now();
  const estimate::BodyModel model = estimate::body_model(take.info.rig, take.info.skeleton);
  if (const std::string& root = settings.root; root == "truth" || root.find('.') != std::string::npos) {
    Result<std::vector<estimate::RootReading>> path = root == "truth" ? root_of_truth(take) : take::read_root(root);
    if (!path) {
      return path.error();
    }
    readings.root = *std::move(path);
  }
  estimate::BodyFilterParameters parameters = body_parameters(model, settings);
  if (model.boards.size() == 1 && readings.inertial.size() > 100) {
    // As in strapdown integration, a reading is the mean over the interval that ends with it.
    const auto& inertial = readings.inertial;
    parameters.reading_delay_s =
        0.5 * (inertial.back().time_s - inertial.front().time_s) / static_cast<double>(inertial.size() - 1);
  }
  if (settings.smooth && !settings.resume.empty()) {
    return Error{"a smoother looks to both sides and cannot resume", settings.resume, "choose the filter"};
  }
  const bool exact = settings.resume.empty() && estimate::rig_is_exact(model, parameters, readings);
  if (exact) {
    parameters = estimate::exact_parameters(parameters);
  }
  Diagnostics tuned;
  if (settings.tune && !exact) {
    const auto watch = [&] { return std::make_unique<estimate::BodyWatch>(model, watch_parameters(model, settings)); };
    const Result<estimate::BodyTuning> tuning =
        estimate::tune_body(model, parameters, readings, {}, progress.part(0.0, 0.5), watch);
    if (!tuning) {
      return tuning.error();
    }
    parameters = tuning->parameters;
    tuned.push_back(tell(*tuning));
  }
  Result<Ran> ran =
      run_and_put_right(model, parameters, readings, settings, settings.tune ? progress.part(0.5, 1.0) : progress);
  if (!ran) {
    Error error = ran.error();
    error.place = error.place.empty() && !is_cancelled(error) ? take.folder.string() : error.place;
    return error;
  }
  const estimate::BodyRun* run = &ran->run;
  Solve solve;
  solve.settings.name = settings.name;
  solve.settings.smoothing = Smoothing::kNone;
  solve.settings.body = BodyChoice{settings.optimise ? "batch"
                                   : settings.smooth ? "smoother"
                                                     : "filter",
                                   settings.sensors, settings.root, settings.tune};
  const body::Skeleton& skeleton = take.info.skeleton;
  motion::Clip& clip = solve.clip;
  clip.name = settings.name;
  clip.skeleton = skeleton;
  clip.frame_rate_hz = settings.rate_hz;
  clip.joints.resize(skeleton.segments.size());
  const estimate::BodyTrack& track = run->track;
  for (std::size_t s = 0; s < skeleton.segments.size(); ++s) {
    motion::RotationTrack& rotation = clip.joints[s].rotation;
    rotation.times = track.times;
    rotation.values.reserve(track.times.size());
    for (const auto& R_joint : track.R_joint) {
      rotation.values.push_back((skeleton.segments[s].R_PL_rest * R_joint[s]).normalized());
    }
  }
  clip.root_position.times = track.times;
  clip.root_position.values = track.root_p_W;
  solve.uncertainty = {track.times, track.sigma, track.point_sigma};
  solve.report.diagnostics = run->diagnostics;
  solve.report.diagnostics.insert(solve.report.diagnostics.end(), tuned.begin(), tuned.end());
  solve.report.diagnostics.insert(solve.report.diagnostics.end(), ran->found.begin(), ran->found.end());
  report_root(track, settings.root, solve.report.diagnostics);
  for (std::size_t b = 0; b < model.boards.size(); ++b) {
    report_counts("gyroscope", model.boards[b].name, run->gyroscopes[b], solve.report.diagnostics);
    report_counts("accelerometer", model.boards[b].name, run->accelerometers[b], solve.report.diagnostics);
  }
  for (std::size_t s = 0; s < model.sources.size(); ++s) {
    report_counts("range", model.sources[s].name, run->ranges[s], solve.report.diagnostics);
  }
  solve.report.calibration = "as read";
  solve.report.take_seconds = track.times.empty() ? 0.0 : track.times.back() - track.times.front();
  solve.report.solve_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return solve;
}

Result<estimate::BodyReadings> driver_box_readings(const take::Take& take, const estimate::BodyModel& model,
                                                   const Progress& progress, bool by_past, bool align) {
  const body::Rig& rig = take.info.rig;
  if (!rig.driver_box) {
    return Error{"has no driver box in its rig", take.folder.string(), "give it the rig it was recorded with"};
  }
  std::vector<int> board_of_chip;
  for (const body::Gyroscope& gyroscope : rig.gyroscopes) {
    board_of_chip.push_back(model.find_board(gyroscope.name));
  }
  std::vector<int> board_of_microphone;
  for (const body::Microphone& microphone : rig.microphones) {
    board_of_microphone.push_back(model.find_board(microphone.name));
  }
  std::vector<int> source_of;
  for (const body::Source& source : rig.sources) {
    source_of.push_back(model.find_source(source.name));
  }
  estimate::BodyReadings readings;
  WordAligner aligner(model, rig.driver_box->word_rate_hz);
  const auto keep = [&](std::span<const decode::RangeReading> ranges,
                        std::span<const decode::InertialReading> inertial) -> Status {
    for (const decode::RangeReading& heard : ranges) {
      if (heard.verdict == decode::RangeVerdict::kAccepted) {
        readings.ranges.push_back({heard.emission_time.value, source_of.at(static_cast<std::size_t>(heard.source)),
                                   board_of_microphone.at(static_cast<std::size_t>(heard.receiver)), heard.range,
                                   heard.confidence(), heard.variance});
      }
    }
    std::vector<estimate::InertialReading> words;
    for (const decode::InertialReading& word : inertial) {
      if (word.valid) {
        words.push_back(
            {word.time.value, board_of_chip.at(static_cast<std::size_t>(word.board)), word.w_WS_S, word.f_S});
      }
    }
    words = align ? aligner.push(words) : std::move(words);
    readings.inertial.insert(readings.inertial.end(), words.begin(), words.end());
    return {};
  };
  const decode::DriverBoxParameters parameters = by_past ? live_decoding() : decode::DriverBoxParameters();
  const Result<DriverBoxReport> decoded = decode_driver_box(take, parameters, keep, progress);
  if (!decoded) {
    return decoded.error();
  }
  std::ranges::stable_sort(readings.inertial, {}, &estimate::InertialReading::time_s);
  std::ranges::stable_sort(readings.ranges, {}, &estimate::RangeReading::time_s);
  return readings;
}

Result<Solve> solve_sensors(const take::Take& take, const BodySolveSettings& settings, const Progress& progress) {
  const estimate::BodyModel model = estimate::body_model(take.info.rig, take.info.skeleton);
  Result<estimate::BodyReadings> readings =
      take.info.kind == "driver-box"
          ? driver_box_readings(take, model, progress.part(0.0, 0.5), settings.by_past, settings.align_words)
          : take::read_logs_of(take, model);
  if (!readings) {
    return readings.error();
  }
  return solve_body(take, *std::move(readings), settings, progress.part(0.5, 1.0));
}

Result<Solve> solve_as_chosen(const take::Take& take, const SolveSettings& settings, const Progress& progress) {
  const BodyChoice choice = settings.body.value_or(BodyChoice());
  BodySolveSettings body;
  body.name = settings.name;
  body.sensors = choice.sensors;
  body.optimise = choice.method == "batch";
  body.smooth = choice.method != "filter";
  body.root = choice.root.empty() ? usual_root(take) : choice.root;
  body.tune = choice.tune;
  Result<Solve> solve = solve_sensors(take, body, progress);
  if (solve && !settings.headings.empty()) {
    apply_headings(*solve, sensor_segments(take.info.rig, solve->clip.skeleton), settings.headings);
  }
  return solve;
}

}  // namespace limbwave::solve
