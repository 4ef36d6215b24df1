#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/folder.h"
#include "base/json_reader.h"
#include "base/json_text.h"
#include "base/units.h"
#include "interchange/gltf_clip.h"
#include "solve/report_text.h"
#include "solve/solve.h"

namespace limbwave::solve {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOld = ".old";
constexpr const char* kDamaged = ".damaged-";
constexpr const char* kLiveHeadings = "live_headings.json";

Status check_name(const std::string& name) {
  const bool plain =
      !name.empty() && name.size() <= 100 && name.front() != '.' && name.find_first_of("/\\\0") == std::string::npos;
  if (!plain) {
    return Error{"cannot be the name of a solve", "\"" + name + "\"", "use letters, digits, spaces and dashes"};
  }
  return {};
}

nlohmann::json trust_to_json(const std::vector<std::vector<float>>& trust) {
  nlohmann::json list = nlohmann::json::array();
  for (const std::vector<float>& sensor : trust) {
    std::vector<int> percent(sensor.size());
    std::transform(sensor.begin(), sensor.end(), percent.begin(),
                   [](float value) { return static_cast<int>(std::lround(100.0F * value)); });
    list.push_back(percent);
  }
  return list;
}

std::vector<std::vector<float>> trust_from_json(const nlohmann::json& json) {
  std::vector<std::vector<float>> trust;
  for (const nlohmann::json& sensor : json) {
    std::vector<float>& values = trust.emplace_back();
    for (const nlohmann::json& percent : sensor) {
      values.push_back(0.01F * percent.get<float>());
    }
  }
  return trust;
}

Result<nlohmann::json> load_json(const fs::path& path) {
  const Result<std::string> text = read_file(path);
  if (!text) {
    return text.error();
  }
  return parse_json(*text, path.string());
}

// A table for other programs: a row a time and segment.
std::string uncertainty_text(const Solve& solve) {
  const Solve::Uncertainty& u = solve.uncertainty;
  std::string text = "time_s,segment,joint_sigma_deg,point_sigma_mm\n";
  for (std::size_t i = 0; i < u.times.size() && i < u.joint.size() && i < u.point.size(); ++i) {
    for (std::size_t s = 0; s < u.joint[i].size() && s < solve.clip.skeleton.segments.size(); ++s) {
      text += fmt::format("{:.4f},{},{:.3f},{:.1f}\n", u.times[i], solve.clip.skeleton.segments[s].name,
                          degrees(u.joint[i][s]), 1e3 * u.point[i][s]);
    }
  }
  return text;
}

Status write_parts(const fs::path& folder, const Solve& solve) {
  if (Status status = interchange::write_glb(solve.clip, folder / "clip.glb"); !status) {
    return status;
  }
  if (Status status = write_file(folder / "settings.json", json_text(settings_to_json(solve.settings), 2) + "\n");
      !status) {
    return status;
  }
  if (!solve.uncertainty.times.empty()) {
    if (Status status = write_file(folder / "uncertainty.csv", uncertainty_text(solve)); !status) {
      return status;
    }
  }
  nlohmann::json quality = report_to_json(solve);
  quality["trust_percent"] = trust_to_json(solve.trust);
  return write_file(folder / "quality.json", json_text(quality) + "\n");
}

// Where file systems that cannot exchange names keep the old solve for a moment.
fs::path old_folder(const fs::path& solves, const std::string& name) {
  return solves / ("." + name + std::string(kOld));
}

// Where a solve is: under its name, or aside when saving was killed between two renames.
fs::path folder_of(const fs::path& solves, const std::string& name) {
  std::error_code code;
  return fs::is_directory(solves / name, code) ? solves / name : old_folder(solves, name);
}

// `part` gets the name `target`. What had it is in `part` or gone afterwards.
Status put_in_place(const fs::path& part, const fs::path& target, const fs::path& old) {
  std::error_code code;
  const bool replaces = fs::exists(target, code);
  if (replaces && ::renameat2(AT_FDCWD, part.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) == 0) {
    return {};
  }
  if (replaces) {
    fs::remove_all(old, code);
    fs::rename(target, old, code);
  }
  if (!code) {
    fs::rename(part, target, code);
  }
  std::error_code ignored;
  if (code) {
    if (replaces && !fs::exists(target, ignored)) {
      fs::rename(old, target, ignored);
    }
    return Error{"cannot be written (" + code.message() + ")", target.string(),
                 "check that you may write into the take"};
  }
  fs::remove_all(old, ignored);
  return {};
}

// Everything that edits a solve relies on one time axis.
bool has_one_time_axis(const motion::Clip& clip) {
  return std::all_of(clip.joints.begin(), clip.joints.end(), [&](const motion::JointTracks& joint) {
    return joint.rotation.times == clip.joints.front().rotation.times &&
           joint.rotation.values.size() == joint.rotation.times.size();
  });
}

}  // namespace

Status save_solve(const take::Take& take, const Solve& solve) {
  if (Status status = check_name(solve.settings.name); !status) {
    return status;
  }
  const fs::path solves = take.folder / "solves";
  const fs::path target = solves / solve.settings.name;
  const fs::path part = solves / ("." + solve.settings.name + ".part");
  const fs::path old = old_folder(solves, solve.settings.name);
  std::error_code code;
  if (!fs::exists(target, code) && fs::exists(old, code)) {
    fs::rename(old, target, code);  // saving was killed between two renames: until there is a new one, this counts
  }
  fs::remove_all(part, code);
  fs::create_directories(part, code);
  if (code) {
    return Error{"cannot be made (" + code.message() + ")", part.string(), "check that you may write into the take"};
  }
  Status status = write_parts(part, solve);
  if (status) {
    status = put_in_place(part, target, old);
  }
  fs::remove_all(part, code);  // what was written in vain, or what the new one has replaced
  return status;
}

Result<SolveSettings> load_solve_settings(const take::Take& take, const std::string& name) {
  if (Status status = check_name(name); !status) {
    return status.error();
  }
  const fs::path file = folder_of(take.folder / "solves", name) / "settings.json";
  const Result<nlohmann::json> json = load_json(file);
  if (!json) {
    return json.error();
  }
  Result<SolveSettings> settings = settings_from_json(*json, file.string());
  if (settings) {
    settings->name = name;
  }
  return settings;
}

Status save_live_headings(const fs::path& take_folder, const std::vector<std::vector<HeadingKey>>& headings) {
  SolveSettings settings;
  settings.headings = headings;
  return write_file(take_folder / kLiveHeadings, json_text(settings_to_json(settings), 2) + "\n");
}

std::vector<std::vector<HeadingKey>> known_headings(const take::Take& take, const std::string& name) {
  if (Result<SolveSettings> stored = load_solve_settings(take, name)) {
    return std::move(stored->headings);
  }
  const Result<nlohmann::json> json = load_json(take.folder / kLiveHeadings);
  if (!json) {
    return {};
  }
  Result<SolveSettings> live = settings_from_json(*json, (take.folder / kLiveHeadings).string());
  return live ? std::move(live->headings) : std::vector<std::vector<HeadingKey>>();
}

Result<fs::path> set_solve_aside(const take::Take& take, const std::string& name) {
  if (Status status = check_name(name); !status) {
    return status.error();
  }
  const fs::path solves = take.folder / "solves";
  std::error_code code;
  fs::path aside;
  for (int number = 1; aside.empty() || fs::exists(aside, code); ++number) {
    aside = solves / (name + kDamaged + std::to_string(number));
  }
  fs::rename(folder_of(solves, name), aside, code);
  if (code) {
    return Error{"cannot be set aside (" + code.message() + ")", (solves / name).string(),
                 "check that you may write into the take"};
  }
  return aside;
}

Result<Solve> load_solve(const take::Take& take, const std::string& name) {
  if (Status status = check_name(name); !status) {
    return status.error();
  }
  fs::path folder = take.folder / "solves" / name;
  std::error_code code;
  if (!fs::is_directory(folder, code)) {
    folder = old_folder(take.folder / "solves", name);  // saving was killed between two renames
  }
  if (!fs::is_directory(folder, code)) {
    return Error{"has no solve \"" + name + "\"", take.folder.string(), "solve it first: limbwave solve TAKE"};
  }
  const Result<nlohmann::json> settings_json = load_json(folder / "settings.json");
  if (!settings_json) {
    return settings_json.error();
  }
  Result<SolveSettings> settings = settings_from_json(*settings_json, (folder / "settings.json").string());
  if (!settings) {
    return settings.error();
  }
  Result<motion::Clip> clip = interchange::load_glb(folder / "clip.glb");
  if (!clip) {
    return clip.error();
  }
  if (!has_one_time_axis(*clip)) {
    return Error{"was changed by another program: its joints have keys at different times",
                 (folder / "clip.glb").string(), "solve the take again, or import the changed clip elsewhere"};
  }
  const Result<nlohmann::json> quality = load_json(folder / "quality.json");
  if (!quality) {
    return quality.error();
  }
  Solve solve;
  solve.settings = std::move(*settings);
  solve.settings.name = name;
  solve.clip = std::move(*clip);
  bool damaged = false;
  try {
    solve.report = report_from_json(*quality);
    solve.trust = trust_from_json(quality->value("trust_percent", nlohmann::json::array()));
  } catch (const nlohmann::json::exception&) {
    damaged = true;
  }
  const std::size_t frames = solve.clip.joints.empty() ? 0 : solve.clip.joints.front().rotation.times.size();
  damaged = damaged || std::any_of(solve.trust.begin(), solve.trust.end(), [&](const std::vector<float>& sensor) {
              return !sensor.empty() && sensor.size() != frames;
            });
  if (damaged) {
    return Error{"is damaged", (folder / "quality.json").string(), "solve the take again"};
  }
  return solve;
}

std::vector<std::string> list_solves(const take::Take& take) {
  const fs::path solves = take.folder / "solves";
  std::vector<std::string> names;
  std::error_code code;
  for (const fs::path& entry : entries_of(solves)) {
    const std::string name = entry.filename().string();
    if (!fs::is_directory(entry, code)) {
      continue;
    }
    if (!name.starts_with('.') && name.find(kDamaged) == std::string::npos) {
      names.push_back(name);
    } else if (name.starts_with('.') && name.ends_with(kOld) &&
               !fs::exists(solves / name.substr(1, name.size() - 1 - kOld.size()), code)) {
      names.push_back(name.substr(1, name.size() - 1 - kOld.size()));
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace limbwave::solve
