/// From readings to a clip by the body filter or the smoother.
#pragma once

#include <string>

#include "base/progress.h"
#include "estimate/body_smoother.h"
#include "estimate/body_watch.h"
#include "solve/solve.h"

namespace limbwave::solve {

struct BodySolveSettings {
  std::string name = "default";
  std::string sensors = "AGD";  ///< Any of A, G and D.
  bool smooth = false;          ///< Both directions.
  std::string root = "free";    ///< "truth", "fixed", "contacts", "free", or a CSV file with the root's path.
  double rate_hz = 120.0;       ///< Poses a second of the clip at most.
  estimate::StartMode start = estimate::StartMode::kAny;
  std::string resume = {};      ///< File with the state to resume from; empty: from the beginning. Not with `smooth`.
  std::string save_state = {};  ///< File to save the last state to; empty: none.
  /// Ranges are judged by what came before them alone, as live; offline what comes after helps.
  bool by_past = false;
  /// Words of a driver box's boards are read at common instants (solve/word_alignment.h): ten times as fast.
  bool align_words = true;
  bool optimise =
      false;          ///< With `smooth`: rounds of it, each linearised about the one before (estimate/body_batch.h).
  bool tune = false;  ///< Noises are found from the take's first seconds (estimate/body_tuning.h).
};

/// The parameters that suit a model: what a rig of one free sensor needs is not what a body needs.
estimate::BodyFilterParameters body_parameters(const estimate::BodyModel& model, const BodySolveSettings& settings);

/// The root that suits a take where nobody chose one: by contacts where the skeleton has feet, else free.
std::string usual_root(const take::Take& take);

/// What is done around the filter's steps (estimate/body_watch.h) for these settings, live and offline.
estimate::BodyWatchParameters watch_parameters(const estimate::BodyModel& model, const BodySolveSettings& settings);

/// Solves readings on the take's skeleton. Boards that turn out to be exchanged or turned are put right, and told.
/// Fails when nothing of the chosen sensors is there, or the root is not.
Result<Solve> solve_body(const take::Take& take, estimate::BodyReadings readings, const BodySolveSettings& settings,
                         const Progress& progress);
/// The same for a take of kind "log", or of kind "driver-box", which is decoded first.
Result<Solve> solve_sensors(const take::Take& take, const BodySolveSettings& settings, const Progress& progress);
/// As `settings.body` chooses, or as usual; with `settings.headings` in it.
Result<Solve> solve_as_chosen(const take::Take& take, const SolveSettings& settings, const Progress& progress);

/// What a driver box heard, for the filter: words whose values are known, and ranges that were accepted. Memory grows
/// with the take: about 0.2 kB a word. `align`: at common instants. `progress` is asked to 1.
Result<estimate::BodyReadings> driver_box_readings(const take::Take& take, const estimate::BodyModel& model,
                                                   const Progress& progress, bool by_past = false, bool align = true);

}  // namespace limbwave::solve
