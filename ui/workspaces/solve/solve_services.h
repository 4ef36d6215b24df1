/// What the Solve and Export workspaces ask of the core, as a table of functions, so that tests put their own in.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/evaluate.h"
#include "interchange/export_file.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::ui {

/// All may take long and run in jobs, except `list`.
struct SolveServices {
  std::function<Result<solve::Solve>(const take::Take&, const solve::SolveSettings&, const Progress&)> solve;
  std::function<Status(const take::Take&, const solve::Solve&)> save;
  std::function<Result<solve::Solve>(const take::Take&, const std::string& name)> load;
  /// Of a solve that cannot be loaded: its settings, and putting it out of the way unharmed. Returns its new folder.
  std::function<Result<solve::SolveSettings>(const take::Take&, const std::string& name)> load_settings;
  std::function<Result<std::filesystem::path>(const take::Take&, const std::string& name)> set_aside;
  std::function<std::vector<std::string>(const take::Take&)> list;
  /// Empty for a take without truth.
  std::function<Result<std::optional<evaluate::Truth>>(const take::Take&)> load_truth;
  std::function<Result<evaluate::Evaluation>(const motion::Clip&, double clip_start_s, const evaluate::Truth&)>
      evaluate;
  std::function<Result<interchange::ExportReport>(std::span<const motion::Clip* const>, const std::filesystem::path&,
                                                  const interchange::ExportOptions&, const Progress&)>
      export_file;
};

/// The real ones.
SolveServices core_solve_services();

}  // namespace limbwave::ui
