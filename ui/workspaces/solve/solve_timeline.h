/// The shared timeline, filled from the open take and its solve.
#pragma once

#include <QWidget>

#include "common/studio_context.h"

namespace limbwave::ui {

QWidget* make_solve_timeline(StudioContext& context, QWidget* parent);

}  // namespace limbwave::ui
