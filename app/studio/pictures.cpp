#include "pictures.h"

#include <QImage>
#include <QString>
#include <algorithm>

#include "plots/take_pictures.h"
#include "solve/solve.h"
#include "take/take.h"

namespace limbwave::studio {
namespace {

Status save(const QImage& image, const std::filesystem::path& file) {
  if (!image.save(QString::fromStdString(file.string()))) {
    return Error{"the picture cannot be written", file.string(), "check that the folder exists and is writable"};
  }
  return {};
}

}  // namespace

Status write_pictures(const std::filesystem::path& folder, const std::filesystem::path& take_folder) {
  const Result<take::Take> take = take::open_take(take_folder);
  if (!take) {
    return take.error();
  }
  const std::vector<std::string> solves = solve::list_solves(*take);
  if (solves.empty()) {
    return Error{"the take has not been solved", take_folder.string(), "run limbwave solve first"};
  }
  const bool has_default = std::find(solves.begin(), solves.end(), "default") != solves.end();
  const Result<solve::Solve> solve = solve::load_solve(*take, has_default ? "default" : solves.front());
  if (!solve) {
    return solve.error();
  }
  if (Status saved = save(ui::skeleton_picture(solve->clip), folder / "skeleton.png"); !saved) {
    return saved;
  }
  const Result<QImage> signals_image = ui::signals_picture(*take);
  if (!signals_image) {
    return signals_image.error();
  }
  return save(*signals_image, folder / "signals.png");
}

}  // namespace limbwave::studio
