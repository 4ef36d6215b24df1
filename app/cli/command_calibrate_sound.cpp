#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "calibrate/sound_speed.h"
#include "commands.h"
#include "solve/driver_box.h"
#include "solve/take_sound_speed.h"
#include "take/take.h"

namespace limbwave::cli {
namespace {

struct Options {
  std::string take, json;
  double temperature = 22.0, humidity = 50.0;
};

// The speed of sound of a take: as the weather says, or from its own ranges on rigid segments.
void calibrate_sound(const Options& options, bool entered, const std::string* json_file, Console& console) {
  take::Take take = console.check(take::open_take(options.take));
  if (!take.info.rig.driver_box) {
    console.fail({"has no driver box", options.take, "use a take that was recorded with --driver-box"});
  }
  calibrate::RangingCalibration ranging = solve::ranging_calibration(take.info);
  const double before = ranging.speed_of_sound;
  nlohmann::json json{{"procedure", "sound"}, {"before_m_s", before}};
  std::string text;
  if (entered) {
    ranging.speed_of_sound = calibrate::speed_of_sound(options.temperature, options.humidity / 100.0);
    text = fmt::format("{:.2f} m/s at {:g} °C and {:g} % humidity", ranging.speed_of_sound, options.temperature,
                       options.humidity);
  } else {
    const calibrate::SoundSpeed found = console.check(solve::speed_of_sound_from(take, console.progress()));
    console.end_progress();
    ranging.speed_of_sound = found.speed;
    text = found.text();
    json["sd_m_s"] = found.sd;
    json["pairs"] = found.pairs;
  }
  json["speed_of_sound_m_s"] = ranging.speed_of_sound;
  take.info.ranging = ranging;
  console.check(take::save_info(take));
  if (json_file != nullptr) {
    console.print_json(json, *json_file);
    return;
  }
  console.print("speed of sound: " + text);
  console.print(fmt::format("  {:+.2f} % from what the take had ({:.2f} m/s)",
                            100.0 * (ranging.speed_of_sound / before - 1.0), before));
}

}  // namespace

void add_calibrate_sound(CLI::App& calibrate, Console& console) {
  auto options = std::make_shared<Options>();
  CLI::App* command =
      calibrate.add_subcommand("sound", "Speed of sound of a driver box's take: from its own ranges, or the weather");
  command->add_option("TAKE", options->take, "Folder of the take")->required();
  CLI::Option* temperature =
      command->add_option("--temperature", options->temperature, "Of the air, °C, instead of ranges")
          ->check(CLI::Range(-30.0, 60.0));
  command->add_option("--humidity", options->humidity, "Relative, per cent; 50 unless given")
      ->check(CLI::Range(0.0, 100.0))
      ->needs(temperature);
  add_json_option(*command, options->json, "Write the report as JSON");
  command->footer("Example: limbwave calibrate sound walk.take");
  command->callback([options, command, temperature, &console] {
    calibrate_sound(*options, temperature->count() > 0, command->count("--json") > 0 ? &options->json : nullptr,
                    console);
  });
}

}  // namespace limbwave::cli
