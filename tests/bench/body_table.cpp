// Table 1 of Vlasic et al. 2007 on simulated takes, side by side with the paper. Prints, never decides.
// body_table [table1] [key=value...]: table1 adds, below the lines of single takes, the table over all of them;
// motions, errors (profiles or files), seeds, sensors, methods (filter, smoother, batch) are lists with commas; rest,
// seconds are numbers; joints=1 adds a line per joint, times=S one per stretch of time, constants=1 one per board,
// drift=1 the first and the last 30 s (motions=walk seconds=300 drift=1: five minutes on a treadmill); any parameter of
// the filter goes by its name. "stated" is the root mean square of the σ that the estimate gives itself.
#include <fmt/format.h>

#include <cstdlib>
#include <ctime>
#include <sstream>

#include "estimate/body_batch.h"
#include "estimate/body_parameters.h"
#include "estimate/exact_rig.h"
#include "support/body_runs.h"

namespace {

using namespace limbwave;
using testing_support::JointErrors;

struct PaperRow {
  const char* sensors;
  double figures[6];
};
constexpr PaperRow kPaper[] = {{"A", {159.7, 147.7, 168.6, 105.9, 184.0, 146.0}},
                               {"AD", {74.0, 125.4, 178.6, 110.9, 165.5, 144.5}},
                               {"D", {120.2, 93.4, 54.7, 37.0, 117.4, 79.2}},
                               {"G", {25.9, 15.9, 10.1, 7.0, 8.3, 8.0}},
                               {"GD", {18.4, 7.4, 8.1, 5.8, 9.8, 5.4}},
                               {"AG", {9.5, 3.4, 10.9, 6.4, 5.6, 4.0}},
                               {"AGD", {5.7, 2.9, 8.0, 5.0, 6.6, 3.8}}};

template <typename T>
T need(Result<T> result) {
  if (!result) {
    fmt::print(stderr, "{}\n", result.error().text());
    std::exit(1);
  }
  return std::move(result).value();
}

std::vector<std::string> list(const std::string& text) {
  std::vector<std::string> items;
  std::istringstream in(text);
  for (std::string item; std::getline(in, item, ',');) {
    items.push_back(item);
  }
  return items;
}

double cpu_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Settings {
  std::vector<std::string> motions{"walk"}, errors{"paper"}, seeds{"1"}, methods{"filter"};
  std::vector<std::string> sensors{"A", "AD", "D", "G", "GD", "AG", "AGD"};
  double rest = 3.0, seconds = 0.0, metres = 0.0;
  double times = 0.0;
  bool joints = false, constants = false, drift = false, table1 = false;
  std::vector<std::pair<std::string, double>> parameters;
};

Settings parse(int argc, char** argv) {
  Settings s;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const auto equal = argument.find('=');
    const std::string key = argument.substr(0, equal);
    const std::string value = equal == std::string::npos ? "" : argument.substr(equal + 1);
    const double number = std::atof(value.c_str());
    estimate::BodyFilterParameters known;
    if (key == "table1") {
      s.table1 = true;
    } else if (key == "motions") {
      s.motions = list(value);
    } else if (key == "errors") {
      s.errors = list(value);
    } else if (key == "seeds") {
      s.seeds = list(value);
    } else if (key == "sensors") {
      s.sensors = list(value);
    } else if (key == "methods") {
      s.methods = list(value);
    } else if (key == "rest") {
      s.rest = number;
    } else if (key == "seconds") {
      s.seconds = number;
    } else if (key == "metres") {
      s.metres = number;
    } else if (key == "joints") {
      s.joints = number != 0.0;
    } else if (key == "drift") {
      s.drift = number != 0.0;
    } else if (key == "times") {
      s.times = number;
    } else if (key == "constants") {
      s.constants = number != 0.0;
    } else if (estimate::set_body_parameter(known, key, number)) {
      s.parameters.emplace_back(key, number);
    } else {
      fmt::print(stderr, "what is {}?\n", argument);
      std::exit(1);
    }
  }
  return s;
}

// Mean / σ, and what the filter says of itself.
std::string cell(const JointErrors& errors, const char* name) {
  const auto& e = errors.by_name.at(name);
  return fmt::format("{:6.2f}/{:5.2f}", e.mean(), e.sd());
}

// Means over stretches of time, a column a joint.
void print_times(const testing_support::Wearer& wearer, const estimate::BodyTrack& track, double stretch) {
  fmt::print("      s");
  for (std::size_t i = 1; i < wearer.skeleton.segments.size(); ++i) {
    fmt::print(" {:>7.7}",
               wearer.skeleton.segments[i].name.substr(wearer.skeleton.segments[i].name.size() > 8 ? 2 : 0));
  }
  for (double t = 0.0; t < track.times.back(); t += stretch) {
    const JointErrors errors = errors_of(wearer, track, t, t + stretch);
    fmt::print("\n{:7.2f}", t);
    for (std::size_t i = 1; i < wearer.skeleton.segments.size(); ++i) {
      fmt::print(" {:7.2f}", errors.by_name.at(wearer.skeleton.segments[i].name).mean());
    }
  }
  fmt::print("\n");
}

// How every board is really mounted, and what the filter believes at the end.
void print_constants(const testing_support::Wearer& wearer, const estimate::BodyModel& model,
                     const estimate::BodyState& last) {
  const auto degrees3 = [](const Eigen::Vector3d& v) {
    return fmt::format("{:6.2f} {:6.2f} {:6.2f}", degrees(v.x()), degrees(v.y()), degrees(v.z()));
  };
  const auto mm3 = [](const Eigen::Vector3d& v) {
    return fmt::format("{:6.1f} {:6.1f} {:6.1f}", 1e3 * v.x(), 1e3 * v.y(), 1e3 * v.z());
  };
  for (std::size_t b = 0; b < model.boards.size(); ++b) {
    const simulate::WornPlace& worn = wearer.actor->boards()[b];
    const auto& board = model.boards[b];
    fmt::print("   {:<16} mount {} ° believed {}   place {} mm believed {}\n", board.name,
               degrees3(geometry::log_so3(board.R_LS.conjugate() * worn.R_LS)),
               degrees3(geometry::log_so3(last.mount_rotation[b] * geometry::exp_so3(last.tissue_angle[b]))),
               mm3(worn.p_LS - board.p_LS), mm3(last.mount_place[b]));
  }
  for (std::size_t s = 0; s < model.skeleton.segments.size(); ++s) {
    const double length = wearer.skeleton.segments[s].length;
    fmt::print("   {:<16} longer by {:5.2f} % believed {:5.2f} %\n", wearer.skeleton.segments[s].name,
               100.0 * (wearer.actor->skeleton().segments[s].length / length - 1.0), 100.0 * last.bone_scale[s]);
  }
}

// Over all takes, by method and sensors.
using Totals = std::map<std::pair<std::string, std::string>, JointErrors>;

void merge(JointErrors& all, const JointErrors& more) {
  const auto add = [](testing_support::Errors& to, const testing_support::Errors& e) {
    to.sum += e.sum;
    to.square += e.square;
    to.stated += e.stated;
    to.largest = std::max(to.largest, e.largest);
    to.count += e.count;
  };
  for (const auto& [name, e] : more.by_name) {
    add(all.by_name[name], e);
  }
  add(all.all, more.all);
}

// Here and in the paper, mean / σ in degrees, and the mean of the three joints, by which the rows can be ordered.
void print_table1(const Settings& settings, const Totals& totals) {
  const char* joints[] = {"neck", "right_upper_arm", "left_thigh"};
  for (const std::string& method : settings.methods) {
    fmt::print("\nTable 1, {}: mean/σ here, the paper's\n{:<8}|{:^31}|{:^31}|{:^31}|{:^17}| all joints\n", method,
               "sensors", "neck", "right shoulder", "left hip", "mean of three");
    for (const PaperRow& row : kPaper) {
      const auto at = totals.find({method, row.sensors});
      if (at == totals.end()) {
        continue;
      }
      double here = 0.0;
      double paper = 0.0;
      fmt::print("{:<8}", row.sensors);
      for (int j = 0; j < 3; ++j) {
        const auto& e = at->second.by_name.at(joints[j]);
        fmt::print("|  {:6.2f}/{:6.2f}   {:6.1f}/{:5.1f}  ", e.mean(), e.sd(), row.figures[2 * j],
                   row.figures[2 * j + 1]);
        here += e.mean() / 3.0;
        paper += row.figures[2 * j] / 3.0;
      }
      fmt::print("|  {:6.2f}  {:6.1f} | {:6.2f}\n", here, paper, at->second.all.mean());
    }
  }
}

void run(const Settings& settings, const testing_support::Wearer& wearer, const std::string& label, Totals& totals) {
  const double seconds = wearer.readings.inertial.back().time_s;
  for (const PaperRow& row : kPaper) {
    const std::string sensors = row.sensors;
    if (std::find(settings.sensors.begin(), settings.sensors.end(), sensors) == settings.sensors.end()) {
      continue;
    }
    for (const std::string& method : settings.methods) {
      estimate::BodyFilterParameters p;
      p.root = estimate::RootMode::kGiven;
      p.use_accelerometers = sensors.find('A') != std::string::npos;
      p.use_gyroscopes = sensors.find('G') != std::string::npos;
      p.use_ranges = sensors.find('D') != std::string::npos;
      for (const auto& [name, value] : settings.parameters) {
        estimate::set_body_parameter(p, name, value);
      }
      const estimate::BodyModel model = estimate::body_model(wearer.rig, wearer.skeleton);
      const double begin = cpu_seconds();
      const bool exact = estimate::rig_is_exact(model, p, wearer.readings);
      if (exact) {
        p = estimate::exact_parameters(p);
      }
      estimate::BodyRun solved;
      if (method == "batch") {
        auto optimum = need(estimate::optimise_body(model, p, wearer.readings, 60.0, {}));
        solved = std::move(optimum.run);
        fmt::print("   costs:");
        for (const double cost : optimum.costs) {
          fmt::print(" {:.0f}", cost);
        }
        fmt::print("\n");
      } else {
        solved = need(method == "filter" ? estimate::filter_body(model, p, wearer.readings, 60.0, {})
                                         : estimate::smooth_body(model, p, wearer.readings, 60.0, {}));
      }
      const double busy = cpu_seconds() - begin;
      const JointErrors errors = errors_of(wearer, solved.track);
      merge(totals[{method, sensors}], errors);
      double worst = 0.0;
      for (const auto& [name, e] : errors.by_name) {
        worst = std::max(worst, e.mean());
      }
      fmt::print("{:<28} {:<8} {:<3} | {} {} {} | ", label, method, sensors, cell(errors, "neck"),
                 cell(errors, "right_upper_arm"), cell(errors, "left_thigh"));
      for (const double figure : row.figures) {
        fmt::print("{:5.1f} ", figure);
      }
      fmt::print("| {:6.3f} worst {:6.3f} max {:6.2f} | rms {:5.2f} stated {:5.2f} | {:.1f}\n", errors.all.mean(),
                 worst, errors.all.largest, errors.all.rms(), errors.all.sigma(), seconds / busy,
                 exact ? "(exact rig)" : "");
      if (settings.joints) {
        for (const auto& [name, e] : errors.by_name) {
          fmt::print("   {:<16} {:6.2f} / {:5.2f}  max {:6.2f}   rms {:5.2f} stated {:5.2f}\n", name, e.mean(), e.sd(),
                     e.largest, e.rms(), e.sigma());
        }
      }
      if (settings.drift) {
        const JointErrors first = errors_of(wearer, solved.track, settings.rest + 2.0, settings.rest + 32.0);
        const JointErrors last = errors_of(wearer, solved.track, seconds - 30.0, seconds);
        fmt::print(
            "   first 30 s: mean {:.2f} rms {:.2f} stated {:.2f}; last 30 s: mean {:.2f} rms {:.2f} stated {:.2f} "
            "degrees, all joints\n",
            first.all.mean(), first.all.rms(), first.all.sigma(), last.all.mean(), last.all.rms(), last.all.sigma());
      }
      if (settings.times > 0.0) {
        print_times(wearer, solved.track, settings.times);
      }
      if (settings.constants) {
        print_constants(wearer, model, solved.last);
      }
      std::fflush(stdout);
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  const Settings settings = parse(argc, argv);
  fmt::print(
      "motion, errors, seed         method   sensors |     neck       right shoulder   left hip   | paper's: the same  "
      "  "
      "             | all joints | all joints rms | x real time\n");
  Totals totals;
  for (const std::string& motion : settings.motions) {
    for (const std::string& profile : settings.errors) {
      const auto errors = need(simulate::load_driver_box_errors(profile));
      for (const std::string& seed : settings.seeds) {
        const auto wearer =
            need(testing_support::make_wearer(motion, errors, static_cast<std::uint64_t>(std::atoi(seed.c_str())),
                                              settings.rest, settings.seconds, settings.metres));
        const auto name = [](const std::string& path) {
          const auto slash = path.find_last_of('/');
          return path.substr(slash == std::string::npos ? 0 : slash + 1);
        };
        run(settings, wearer, name(motion) + " " + name(profile) + " " + seed, totals);
      }
    }
  }
  if (settings.table1) {
    print_table1(settings, totals);
  }
  return 0;
}
