#include "solve/body_solve.h"
#include "workspaces/solve/solve_services.h"

namespace limbwave::ui {

SolveServices core_solve_services() {
  SolveServices services;
  // A sound card's take by inclination; what hears more than gravity by the body filter, in both directions of time.
  services.solve = [](const take::Take& take, const solve::SolveSettings& settings,
                      const Progress& progress) -> Result<solve::Solve> {
    if (take.info.kind == "line-in") {
      return solve::solve_take(take, settings, progress);
    }
    return solve::solve_as_chosen(take, settings, progress);
  };
  services.save = solve::save_solve;
  services.load = solve::load_solve;
  services.load_settings = solve::load_solve_settings;
  services.set_aside = solve::set_solve_aside;
  services.list = solve::list_solves;
  services.load_truth = [](const take::Take& take) -> Result<std::optional<evaluate::Truth>> {
    const std::filesystem::path file = take.folder / "truth.json";
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored)) {
      return std::optional<evaluate::Truth>();
    }
    Result<evaluate::Truth> truth = evaluate::load_truth(file);
    if (!truth) {
      return truth.error();
    }
    return std::optional<evaluate::Truth>(std::move(truth).value());
  };
  services.evaluate = evaluate::evaluate;
  services.export_file = interchange::export_file;
  return services;
}

}  // namespace limbwave::ui
