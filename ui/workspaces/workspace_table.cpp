/// The table of workspaces: one row each, in the order of the mode bar.
#include <QCoreApplication>

#include "workspaces/workspace.h"

namespace limbwave::ui {
namespace {

struct Workspaces {
  Q_DECLARE_TR_FUNCTIONS(Workspaces)
};

}  // namespace

StudioParts studio_parts() {
  StudioParts parts;
  return parts;
}

}  // namespace limbwave::ui
