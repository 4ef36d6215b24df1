#include "workspaces/solve/solve_services.h"

namespace limbwave::ui {

SolveServices core_solve_services() {
  SolveServices services;
  services.solve = solve::solve_take;
  services.save = solve::save_solve;
  services.load = solve::load_solve;
  services.list = solve::list_solves;
  services.write_bvh = interchange::write_bvh;
  return services;
}

}  // namespace limbwave::ui
