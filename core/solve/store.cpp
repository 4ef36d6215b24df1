#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files.h"
#include "base/json_reader.h"
#include "interchange/gltf_clip.h"
#include "solve/report_text.h"
#include "solve/solve.h"

namespace limbwave::solve {
namespace {

namespace fs = std::filesystem;

constexpr const char* kDamaged = ".damaged-";

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

Status write_parts(const fs::path& folder, const Solve& solve) {
  if (Status status = interchange::write_glb(solve.clip, folder / "clip.glb"); !status) {
    return status;
  }
  if (Status status = write_file(folder / "settings.json", settings_to_json(solve.settings).dump(2) + "\n"); !status) {
    return status;
  }
  nlohmann::json quality = report_to_json(solve);
  quality["trust_percent"] = trust_to_json(solve.trust);
  return write_file(folder / "quality.json", quality.dump() + "\n");
}

}  // namespace

Status save_solve(const take::Take& take, const Solve& solve) {
  if (Status status = check_name(solve.settings.name); !status) {
    return status;
  }
  const fs::path solves = take.folder / "solves";
  const fs::path target = solves / solve.settings.name;
  const fs::path part = solves / ("." + solve.settings.name + ".part");
  const fs::path old = solves / ("." + solve.settings.name + ".old");
  std::error_code code;
  fs::remove_all(part, code);
  fs::remove_all(old, code);
  fs::create_directories(part, code);
  if (code) {
    return Error{"cannot be made (" + code.message() + ")", part.string(), "check that you may write into the take"};
  }
  if (Status status = write_parts(part, solve); !status) {
    fs::remove_all(part, code);
    return status;
  }
  if (fs::exists(target, code)) {
    fs::rename(target, old, code);
  }
  fs::rename(part, target, code);
  if (code) {
    std::error_code ignored;
    fs::rename(old, target, ignored);
    fs::remove_all(part, ignored);
    return Error{"cannot be written (" + code.message() + ")", target.string(),
                 "check that you may write into the take"};
  }
  fs::remove_all(old, code);
  return {};
}

Result<SolveSettings> load_solve_settings(const take::Take& take, const std::string& name) {
  if (Status status = check_name(name); !status) {
    return status.error();
  }
  const fs::path file = take.folder / "solves" / name / "settings.json";
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
  fs::rename(solves / name, aside, code);
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
  const fs::path folder = take.folder / "solves" / name;
  std::error_code code;
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
  const Result<nlohmann::json> quality = load_json(folder / "quality.json");
  if (!quality) {
    return quality.error();
  }
  Solve solve;
  solve.settings = std::move(*settings);
  solve.settings.name = name;
  solve.clip = std::move(*clip);
  try {
    solve.report = report_from_json(*quality);
    solve.trust = trust_from_json(quality->value("trust_percent", nlohmann::json::array()));
  } catch (const nlohmann::json::exception&) {
    return Error{"is damaged", (folder / "quality.json").string(), "solve the take again"};
  }
  return solve;
}

std::vector<std::string> list_solves(const take::Take& take) {
  std::vector<std::string> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(take.folder / "solves", code)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory(code) && !name.starts_with('.') && name.find(kDamaged) == std::string::npos) {
      names.push_back(name);
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace limbwave::solve
