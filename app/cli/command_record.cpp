#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "acquire/box_ports.h"
#include "acquire/sound_card.h"
#include "commands.h"
#include "simulate/simulate.h"
#include "solve/live_body_session.h"
#include "solve/live_session.h"
#include "solve/take_calibration.h"
#include "take/board_book.h"
#include "take/box_opening.h"
#include "take/driver_box_recording.h"

namespace limbwave::cli {
namespace {

constexpr std::string_view kSimulator = "simulator:";
constexpr const char* kLineInRig = "line-in-arm";
constexpr const char* kBoxRig = "driver-box-body";

struct Options {
  std::string take, device = "default", driver_box, rig, subject, type = "int16", errors = "paper";
  double rate = 48000.0, seconds = 0.0, temperature = 22.0, humidity = 50.0, height = 0.0;
  std::string json;
  // Of a driver box.
  bool live = false;
  std::string root = "contacts", sensors = "AGD", ranging;
  double pose_rate = 60.0;
};

std::unique_ptr<acquire::LiveSource> open_source(const Options& options, Console& console) {
  acquire::StreamFormat format{SampleRate{options.rate}, 2, acquire::SampleType::kInt16};
  for (const auto type : {acquire::SampleType::kInt16, acquire::SampleType::kInt24, acquire::SampleType::kInt32,
                          acquire::SampleType::kFloat32}) {
    if (acquire::name(type) == options.type) {
      format.type = type;
    }
  }
  if (options.device.starts_with(kSimulator)) {
    simulate::SimulateSettings settings;
    settings.motion = options.device.substr(kSimulator.size());
    settings.rig = options.rig.empty() ? kLineInRig : options.rig;
    settings.errors_name = options.errors;
    settings.errors = console.check(simulate::load_errors(options.errors));
    settings.prologue = false;  // like a device: what it shows begins at once
    settings.format = format;
    return console.check(simulate::open_simulator(settings));
  }
  return console.check(acquire::open_sound_card(options.device, format));
}

void record(const Options& options, bool as_json, Console& console) {
  solve::LiveSettings settings;
  settings.rig = console.check(body::load_rig(options.rig.empty() ? kLineInRig : options.rig));
  settings.skeleton = console.check(body::load_skeleton(settings.rig.skeleton));
  // Calibrations are kept per physical sensor: which ones these are depends on the device.
  settings.rig = options.device.starts_with(kSimulator)
                     ? simulate::simulated_rig(std::move(settings.rig), simulate::SimulateSettings().seed)
                     : take::rig_on_device(std::move(settings.rig), options.device);
  const solve::RecordingCalibration calibration = solve::calibration_for_recording(settings.rig, options.subject);
  settings.calibration = calibration.calibration;
  solve::LiveSession session(open_source(options, console), settings);
  // Before the device, so that its first sample is the take's.
  console.check(session.start_recording(options.take, options.subject));
  if (const Status started = session.start(); !started) {
    (void)session.stop_recording();
    std::error_code ignored;
    std::filesystem::remove_all(options.take, ignored);  // made just now, and empty
    console.check(started);
  }
  const Progress progress = console.progress();
  Diagnostics shown;
  while (!Console::interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto now = session.snapshot();
    const std::string what = fmt::format("{:.1f} s, disk lasts {:.0f} min, {}", now->recorded_s,
                                         now->disk_left_s / 60.0, now->line.locked ? "in sync" : "no sync yet");
    if (options.seconds > 0.0) {
      (void)progress.report(now->recorded_s / options.seconds, what);
    } else {
      console.status("recording " + what + "; Ctrl-C stops");
    }
    if (!now->recording_error.empty() || !now->source_alive ||
        (options.seconds > 0.0 && now->recorded_s >= options.seconds)) {
      break;
    }
  }
  session.stop();
  const auto last = session.snapshot();
  const take::Take take = console.check(session.stop_recording());
  const double seconds = static_cast<double>(take.info.frames) / take.info.format.rate.hz;
  if (as_json) {
    console.print_json({{"take", options.take},
                        {"seconds", seconds},
                        {"frames", take.info.frames},
                        {"latency_mean_s", last->latency_mean_s},
                        {"latency_max_s", last->latency_max_s},
                        {"device_latency_s", last->device_latency_s},
                        {"calibration", calibration.explanation},
                        {"diagnostics", diagnostics_to_json(last->diagnostics)}},
                       options.json);
  } else {
    console.print(fmt::format(
        "{}: {:.2f} s recorded; capture to pose {:.0f} ms mean, {:.0f} ms at most, beyond the device's {:.0f} ms",
        options.take, seconds, 1e3 * last->latency_mean_s, 1e3 * last->latency_max_s, 1e3 * last->device_latency_s));
    console.print(calibration.explanation);
    console.print(calibration.diagnostics);
    console.print(last->diagnostics);
  }
  if (!last->recording_error.empty()) {
    console.fail({last->recording_error, "", ""});  // it names the place and what to do
  }
  if (!last->source_alive) {
    console.fail({"the device stopped giving samples", options.device, "what was recorded is kept; check the cable"});
  }
}

// What the live filter has to say at the end.
nlohmann::json live_json(const solve::LiveBodySnapshot& live, double solved_s) {
  const solve::LatencyFigures& latency = live.latency.of(solve::LatencyStage::kTotal);
  return {{"poses", live.poses},
          {"poses_hz", solved_s > 0.0 ? static_cast<double>(live.poses) / solved_s : 0.0},
          {"words", live.words},
          {"ranges", live.ranges},
          {"latency_mean_s", latency.mean_s},
          {"latency_p95_s", latency.p95_s},
          {"latency_max_s", latency.max_s},
          {"joint_sigma_deg", live.joint_sigma_deg},
          {"root_sigma_m", {live.root_sigma.x(), live.root_sigma.y(), live.root_sigma.z()}},
          {"late_readings", live.late},
          {"skipped_s", live.skipped_s},
          {"error", live.error},
          {"diagnostics", diagnostics_to_json(live.diagnostics)}};
}

std::string live_text(const solve::LiveBodySnapshot& live) {
  if (!live.error.empty()) {
    return "no poses: " + live.error;
  }
  if (!live.started) {
    return "the filter waits for a second of readings";
  }
  const solve::LatencyFigures& latency = live.latency.of(solve::LatencyStage::kTotal);
  return fmt::format("{:.0f} poses/s, {:.0f} ms behind, {:.1f}° (1 σ)", live.poses_hz, 1e3 * latency.mean_s,
                     live.joint_sigma_deg);
}

std::string box_text(double seconds, double disk_left_s, bool connected, const acquire::BoxCounters& counters) {
  return fmt::format("{:.1f} s, disk lasts {:.0f} min, {}", seconds, disk_left_s / 60.0,
                     connected ? fmt::format("{} gaps", counters.gaps) : "waiting for the box");
}

// What a recording from a box ends in.
struct BoxOutcome {
  take::Take take;
  acquire::BoxCounters counters;
  acquire::BoxStatus status;
  std::shared_ptr<const solve::LiveBodySnapshot> live;  // null without
};

BoxOutcome record_live(const Options& options, std::unique_ptr<acquire::BoxSource> box,
                       solve::LiveBodySettings settings, Console& console) {
  solve::LiveBodySession session(std::move(box), std::move(settings));
  console.check(session.start(options.take, options.subject));
  const Progress bar = console.progress();
  while (!Console::interrupted()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    const auto now = session.snapshot();
    (void)bar.report(
        options.seconds > 0.0 ? now->recorded_s / options.seconds : 0.0,
        box_text(now->recorded_s, now->disk_left_s, now->connected, now->counters) + "; " + live_text(*now));
    if (!now->recording_error.empty() || (options.seconds > 0.0 && now->recorded_s >= options.seconds)) {
      break;
    }
  }
  BoxOutcome outcome;
  outcome.take = console.check(session.stop());
  console.end_progress();
  outcome.live = session.snapshot();
  outcome.counters = outcome.live->counters;
  outcome.status = outcome.live->status;
  if (!outcome.live->recording_error.empty()) {
    console.fail({outcome.live->recording_error, "", ""});  // it names the place and what to do
  }
  return outcome;
}

BoxOutcome record_raw(const Options& options, acquire::BoxSource& box, const solve::LiveBodySettings& settings,
                      Console& console) {
  const Progress bar = console.progress();
  BoxOutcome outcome;
  outcome.take = console.check(take::record_driver_box(
      options.take, box, settings.rig, settings.skeleton, options.subject, settings.ranging,
      [&](const take::DriverBoxProgress& now) {
        (void)bar.report(options.seconds > 0.0 ? now.seconds / options.seconds : 0.0,
                         box_text(now.seconds, now.disk_left_s, now.connected, now.counters));
        return !Console::interrupted() && (options.seconds <= 0.0 || now.seconds < options.seconds);
      }));
  console.end_progress();
  outcome.counters = box.counters();
  outcome.status = box.status();
  return outcome;
}

// What was said on the command line, not left to us.
struct Given {
  bool rate = false, air = false;
};

void record_box(const Options& options, Given given, bool as_json, Console& console) {
  solve::LiveBodySettings settings;
  settings.rig = console.check(body::load_rig(options.rig.empty() ? kBoxRig : options.rig));
  settings.skeleton = console.check(body::load_skeleton(settings.rig.skeleton));
  if (options.height > 0.0 && settings.skeleton.height > 0.0) {
    settings.rig = body::scaled(std::move(settings.rig), options.height / settings.skeleton.height);
    settings.skeleton = body::scaled_to_height(settings.skeleton, options.height);
  }
  settings.solve.root = options.root;
  settings.solve.sensors = options.sensors;
  settings.solve.rate_hz = options.pose_rate;
  settings.ranging.method = "nominal";
  settings.ranging.speed_of_sound = calibrate::speed_of_sound(options.temperature, options.humidity / 100.0);
  if (!options.ranging.empty()) {
    const double speed_of_sound = settings.ranging.speed_of_sound;
    settings.ranging = console.check(take::ranging_of(options.ranging, settings.rig));
    if (given.air) {
      settings.ranging.speed_of_sound = speed_of_sound;  // Delays belong to the sources, this to the day.
    }
  }
  auto box = console.check(take::open_box(options.driver_box, given.rate ? options.rate : 0.0, settings.rig));
  const BoxOutcome outcome = options.live ? record_live(options, std::move(box), settings, console)
                                          : record_raw(options, *box, settings, console);
  const acquire::BoxCounters& counters = outcome.counters;
  const take::Take& take = outcome.take;
  const double seconds = static_cast<double>(take.info.frames) / take.info.format.rate.hz;
  if (as_json) {
    nlohmann::json json{{"take", options.take},
                        {"seconds", seconds},
                        {"frames", take.info.frames},
                        {"lost_frames", counters.lost_frames},
                        {"gaps", counters.gaps},
                        {"duplicates", counters.duplicates},
                        {"reordered", counters.reordered},
                        {"bad_packets", counters.bad_packets},
                        {"stalls", counters.stalls},
                        {"reconnects", counters.reconnects},
                        {"battery_volts", outcome.status.battery_volts}};
    if (outcome.live) {
      json["live"] = live_json(*outcome.live, seconds);
    }
    console.print_json(json, options.json);
    return;
  }
  console.print(fmt::format("{}: {:.2f} s recorded; {} samples lost in {} gaps, {} reconnections, {} stalls",
                            options.take, seconds, counters.lost_frames, counters.gaps, counters.reconnects,
                            counters.stalls));
  if (outcome.live) {
    const solve::LiveBodySnapshot& live = *outcome.live;
    const solve::LatencyFigures& latency = live.latency.of(solve::LatencyStage::kTotal);
    console.print(
        live.error.empty()
            ? fmt::format("live: {} poses from {} words and {} ranges, {:.1f} a second; board to pose {:.0f} ms mean, "
                          "{:.0f} ms at most; joints {:.1f}° (1 σ) at the end",
                          live.poses, live.words, live.ranges,
                          seconds > 0.0 ? static_cast<double>(live.poses) / seconds : 0.0, 1e3 * latency.mean_s,
                          1e3 * latency.max_s, live.joint_sigma_deg)
            : "live: no poses: " + live.error);
    console.print(live.diagnostics);
  }
}

}  // namespace

void add_record(CLI::App& app, Console& console) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("record", "Record a take from a sound card, a driver box or the simulator");
  command->add_option("TAKE", options->take, "Folder to make")->required();
  command->add_option("--device", options->device, "As `limbwave devices` lists it, \"default\", or simulator:MOTION")
      ->capture_default_str();
  command
      ->add_option(
          "--driver-box", options->driver_box,
          "Serial port of a driver box, or a sound card that serves as one: microphones on its inputs, sources "
          "on its outputs, and a cable from the output after the last source to the input after the last "
          "microphone")
      ->excludes("--device");
  command->add_option("--rig", options->rig,
                      "Rig: a name or a file; line-in-arm or, with a driver box, driver-box-body");
  command->add_option("--subject", options->subject, "Who wears it");
  command->add_option("--seconds", options->seconds, "Stop after this time; 0: at Ctrl-C")
      ->check(within(0.0, 864000.0))
      ->capture_default_str();
  command->add_option("--rate", options->rate, "Samples a second; of a sound card as a driver box 192000 unless given")
      ->check(within(44100.0, 192000.0))
      ->capture_default_str();
  command
      ->add_option("--height", options->height, "Of the wearer of a driver box, metres; 0: as the skeleton's file says")
      ->check(CLI::Range(0.0, 2.6));
  command->add_option("--temperature", options->temperature, "Of the air, °C: the speed of sound of a driver box")
      ->check(within(-30.0, 60.0))
      ->capture_default_str();
  command->add_option("--humidity", options->humidity, "Relative, of the air, per cent")
      ->check(within(0.0, 100.0))
      ->capture_default_str();
  command->add_flag("--live", options->live, "Of a driver box: run the body filter meanwhile, and tell how it does");
  command->add_option("--root", options->root, "Of the live filter")
      ->check(CLI::IsMember({"contacts", "free", "fixed"}))
      ->capture_default_str();
  command->add_option("--sensors", options->sensors, "Of the live filter: A, G, D and every combination")
      ->check(CLI::IsMember({"A", "G", "D", "AG", "AD", "GD", "AGD"}))
      ->capture_default_str();
  command->add_option("--pose-rate", options->pose_rate, "Poses a second of the live filter at most")
      ->check(within(1.0, 140.0))
      ->capture_default_str();
  command->add_option(
      "--ranging", options->ranging,
      "A take of the same driver box whose calibration of sources is taken over, with its speed of sound "
      "unless --temperature or --humidity say another");
  command->add_option("--type", options->type, "Sample type")
      ->check(CLI::IsMember({"int16", "int24", "int32", "float32"}))
      ->capture_default_str();
  command->add_option("--errors", options->errors, "Error profile of the simulator")->capture_default_str();
  command->footer(
      "Example: limbwave record walk.take --device default --seconds 60\n"
      "         limbwave record walk.take --driver-box /dev/ttyACM0 --live");
  add_json_option(*command, options->json, "Write what was recorded as JSON");
  command->callback([options, command, &console] {
    const bool as_json = command->count("--json") > 0;
    // As `limbwave devices` lists it, or its port alone.
    if (options->device.starts_with(acquire::kBoxPrefix)) {
      options->driver_box = options->device;
    }
    options->driver_box = acquire::box_port(options->driver_box);
    if (options->driver_box.empty() && (options->live || !options->ranging.empty())) {
      console.fail({"is for driver boxes", options->live ? "--live" : "--ranging", "give --driver-box PORT"});
    }
    options->driver_box.empty()
        ? record(*options, as_json, console)
        : record_box(*options,
                     {command->count("--rate") > 0, command->count("--temperature") + command->count("--humidity") > 0},
                     as_json, console);
  });
}

}  // namespace limbwave::cli
