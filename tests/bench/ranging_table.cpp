// Ranging on takes of a simulated driver box against their truth.
// ranging_table [--method paper|envelope|carrier] [--look-ahead S] [--wires] TAKE...; prints, never decides.
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "base/units.h"
#include "evaluate/driver_box_evaluation.h"
#include "solve/driver_box.h"
#include "take/take.h"

namespace {

using namespace limbwave;

template <typename T>
T need(Result<T> result) {
  if (!result) {
    fmt::print(stderr, "{}\n", result.error().text());
    std::exit(1);
  }
  return std::move(result).value();
}

void row(const std::string& name, const evaluate::RangeStatistics& r) {
  const auto clear = static_cast<double>(std::max<std::int64_t>(1, r.clear));
  fmt::print("| {} | {} | {} | {:.1f} | {:.3f} | {:.3f} | {:.1e} | {:.1e} | {:.2f} | {:.2f} | {:.2f} | {:.1e} |\n",
             name, r.clear, r.accepted, 100.0 * static_cast<double>(r.clear_accepted) / clear, r.median_mm, r.p95_mm,
             r.slips, r.wrong, 100.0 * r.missed_occlusions, 100.0 * r.false_occlusions, r.nis, r.beyond_3_sd);
}

}  // namespace

int main(int argc, char** argv) {
  decode::DriverBoxParameters parameters;
  bool wires = false;
  std::vector<std::string> takes;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--wires") {
      wires = true;
    } else if (word == "--method" && i + 1 < argc) {
      const std::string method = argv[++i];
      parameters.ranging.method = method == "paper"      ? decode::RangingMethod::kPaper
                                  : method == "envelope" ? decode::RangingMethod::kEnvelope
                                                         : decode::RangingMethod::kCarrier;
    } else if (word == "--look-ahead" && i + 1 < argc) {
      parameters.ranging.look_ahead_s = std::atof(argv[++i]);
    } else {
      takes.push_back(word);
    }
  }
  fmt::print(
      "| take | clear pairs | accepted | of clear, % | median, mm | 95 %, mm | slips | off by > 20 mm | occluded "
      "missed, "
      "% | clear flagged, % | error² / variance | beyond 3 σ |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- "
      "| --- | --- | --- |\n");
  for (const std::string& name : takes) {
    const take::Take take = need(take::open_take(name));
    const evaluate::DriverBoxTruth truth = need(evaluate::load_driver_box_truth(take.folder / "truth.json"));
    const body::DriverBoxSignal& box = take.info.rig.driver_box.value();
    const evaluate::DriverBoxComparison fresh(truth, take.info.format.rate.hz, box.pulse_hz,
                                              solve::ranging_calibration(take.info).speed_of_sound,
                                              box.gyroscope_range_rad_s, box.accelerometer_range_g * kStandardGravity);
    std::vector<evaluate::DriverBoxComparison> each(1 + take.info.rig.microphones.size(), fresh);
    const auto report = need(solve::decode_driver_box(
        take, parameters,
        [&](std::span<const decode::RangeReading> ranges, std::span<const decode::InertialReading>) -> Status {
          for (const decode::RangeReading& reading : ranges) {
            each.front().add(reading);
            if (wires) {
              each[1 + static_cast<std::size_t>(reading.receiver)].add(reading);
            }
          }
          return {};
        },
        {}));
    row(take.folder.stem().string(), each.front().ranges());
    if (wires) {
      for (std::size_t w = 0; w < take.info.rig.microphones.size(); ++w) {
        row("- " + take.info.rig.microphones[w].name, each[1 + w].ranges());
      }
    }
    fmt::print(stderr, "{:.1f} s in {:.2f} s\n", static_cast<double>(take.info.frames) / take.info.format.rate.hz,
               report.seconds);
  }
  return 0;
}
