// Ranging on takes of a simulated driver box against their truth.
// ranging_table [--method paper|envelope|carrier] [--look-ahead S] [--wires] [--why] [--csv FILE] TAKE...; prints,
// never decides. --why: what became of clear pairs by circumstances, and claimed against seen failures.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/ranging_take.h"

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

double percent(std::int64_t part, std::int64_t whole) {
  return whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

void row(const std::string& name, const evaluate::RangeStatistics& r, const evaluate::RangeGroup& bar) {
  fmt::print(
      "| {} | {} | {} | {:.1f} | {} | {:.1f} | {:.3f} | {:.3f} | {:.1e} | {:.1e} | {:.2f} | {:.2f} | {:.2f} | {:.1e} "
      "|\n",
      name, r.clear, r.accepted, percent(r.clear_accepted, r.clear), bar.clear, percent(bar.accepted(), bar.clear),
      r.median_mm, r.p95_mm, r.slips, r.wrong, 100.0 * r.missed_occlusions, 100.0 * r.false_occlusions, r.nis,
      r.beyond_3_sd);
}

void why_row(const std::string& name, const evaluate::RangeGroup& g) {
  const auto share = [&](decode::RangeVerdict verdict) {
    return percent(g.by_verdict[static_cast<std::size_t>(verdict)], g.clear);
  };
  fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {} | {:.1f} |\n", name, g.clear,
             share(decode::RangeVerdict::kAccepted), share(decode::RangeVerdict::kAmbiguous),
             share(decode::RangeVerdict::kNothingHeard) + share(decode::RangeVerdict::kDisturbed),
             share(decode::RangeVerdict::kTooWeak), share(decode::RangeVerdict::kInconsistent), g.slips, g.claimed);
}

void why(const evaluate::RangeBreakdown& breakdown) {
  fmt::print(
      "\n| clear pairs | number | accepted, % | ambiguous, % | nothing heard, % | too weak, % | inconsistent, % | "
      "slips | claimed slips |\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  why_row("all", breakdown.all());
  why_row("25 dB and more in band, 3 m/s and less", breakdown.at_bar());
  for (const auto& [kind, classes] : breakdown.groups()) {
    for (const auto& [name, group] : classes) {
      why_row(kind + ": " + name, group);
    }
  }
  fmt::print("\n| claimed failure | likeliest numbers | mean claimed | seen wrong |\n| --- | --- | --- | --- |\n");
  for (std::size_t i = 0; i < breakdown.claims().size(); ++i) {
    const evaluate::RangeBreakdown::Claim& claim = breakdown.claims()[i];
    const auto count = static_cast<double>(std::max<std::int64_t>(1, claim.count));
    fmt::print("| 1e-{} {} | {} | {:.1e} | {:.1e} |\n", i,
               i + 1 < breakdown.claims().size() ? "and less" : "and all below", claim.count, claim.claimed / count,
               static_cast<double>(claim.wrong) / count);
  }
  fmt::print("\n");
}

// One line per reading, beside its truth.
void csv_line(std::FILE* out, const testing_support::RangingTake& take, const decode::RangeReading& r) {
  const evaluate::DriverBoxTruth& truth = take.truth;
  const double rate_hz = take.take.info.format.rate.hz;
  const double scale = truth.speed_of_sound / solve::ranging_calibration(take.take.info).speed_of_sound;
  const auto pulse = std::lower_bound(truth.pulses.begin(), truth.pulses.end(), r.emission.value,
                                      [](const auto& p, std::int64_t emission) { return p.emission < emission; });
  if (pulse == truth.pulses.end() || pulse->emission != r.emission.value) {
    return;
  }
  const evaluate::DriverBoxTruth::Pair& pair = pulse->pairs[static_cast<std::size_t>(r.receiver)];
  const double range =
      (pair.range + (r.emission_time.value - static_cast<double>(pulse->emission) / rate_hz) * pair.rate) / scale;
  fmt::print(
      out,
      "{:.6f},{},{},{},{:.6f},{:.3f},{:.1f},{:.0f},{:.2f},{:.6f},{:.3e},{:.6f},{:.3e},{:.6f},{:.3e},{:.6f},{:.3e}\n",
      r.emission_time.value, r.source, r.receiver, decode::name(r.verdict), range, pair.rate, pair.loss_db,
      pair.off_axis_deg, r.snr_db, r.envelope_range, r.envelope_variance, r.carrier_range, r.failure, r.range,
      r.variance, r.expected, r.expected_variance);
}

}  // namespace

int main(int argc, char** argv) {
  decode::DriverBoxParameters parameters;
  bool wires = false;
  bool explain = false;
  std::FILE* csv = nullptr;
  std::vector<std::string> takes;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "--wires") {
      wires = true;
    } else if (word == "--why") {
      explain = true;
    } else if (word == "--csv" && i + 1 < argc) {
      csv = std::fopen(argv[++i], "w");
      fmt::print(csv,
                 "time_s,source,receiver,verdict,true_m,rate_m_s,loss_db,off_deg,snr_db,envelope_m,envelope_variance,"
                 "carrier_m,failure,range_m,variance,expected_m,expected_variance\n");
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
      "| take | clear pairs | accepted | of clear, % | clear at 25 dB and 3 m/s | of these, % | median, mm | 95 %, mm "
      "| "
      "slips | off by > 20 mm | occluded missed, % | clear flagged, % | error² / variance | beyond 3 σ |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : takes) {
    const auto opened = need(testing_support::open_ranging_take(name));
    const take::Take& take = opened->take;
    std::vector<evaluate::DriverBoxComparison> each(1 + take.info.rig.microphones.size(), opened->comparison());
    evaluate::RangeBreakdown breakdown = opened->breakdown();
    const auto report = need(opened->decode(parameters, [&](const decode::RangeReading& reading) {
      each.front().add(reading);
      breakdown.add(reading);
      if (csv != nullptr) {
        csv_line(csv, *opened, reading);
      }
      if (wires) {
        each[1 + static_cast<std::size_t>(reading.receiver)].add(reading);
      }
    }));
    row(take.folder.stem().string(), each.front().ranges(), breakdown.at_bar());
    if (wires) {
      for (std::size_t w = 0; w < take.info.rig.microphones.size(); ++w) {
        row("- " + take.info.rig.microphones[w].name, each[1 + w].ranges(), {});
      }
    }
    if (explain) {
      why(breakdown);
    }
    fmt::print(stderr, "{:.1f} s in {:.2f} s\n", static_cast<double>(take.info.frames) / take.info.format.rate.hz,
               report.seconds);
  }
  if (csv != nullptr) {
    std::fclose(csv);
  }
  return 0;
}
