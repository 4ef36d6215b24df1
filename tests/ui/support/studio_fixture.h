/// A studio for tests: its own settings and takes folder, its own services, a window on the test's display.
#pragma once

#include <QApplication>
#include <QDir>
#include <QString>
#include <QTemporaryDir>
#include <memory>

#include "common/studio_context.h"
#include "workspaces/main_window.h"
#include "workspaces/workspace.h"

namespace limbwave::ui::testing {

struct StudioFixture {
  explicit StudioFixture(StudioServices services, StudioParts parts = studio_parts())
      : context(std::make_unique<StudioContext>(std::move(services), folder.filePath(QStringLiteral("settings")))) {
    context->set_takes_folder(folder.filePath(QStringLiteral("takes")));
    window = std::make_unique<MainWindow>(*context, std::move(parts));
    window->resize(1440, 900);
    window->show();
    window->activateWindow();  // Xvfb has no window manager that would do it.
  }
  StudioFixture(const StudioFixture&) = delete;
  StudioFixture& operator=(const StudioFixture&) = delete;
  ~StudioFixture() {
    window.reset();
    context.reset();
  }

  QTemporaryDir folder;
  std::unique_ptr<StudioContext> context;
  std::unique_ptr<MainWindow> window;
};

/// Where pictures of screens go: BUILD/screenshots/NAME.png.
inline QString screenshot_path(const QString& name) {
  const QString folder = QStringLiteral(LIMBWAVE_BINARY_DIR "/screenshots");
  QDir().mkpath(folder);
  return folder + QLatin1Char('/') + name + QStringLiteral(".png");
}

}  // namespace limbwave::ui::testing
