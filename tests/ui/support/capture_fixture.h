/// The Capture workspace with its real widgets over a made-up line.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <memory>

#include "ui/support/fake_services.h"
#include "ui/support/studio_fixture.h"
#include "workspaces/capture/capture_workspace.h"

namespace limbwave::ui::testing {

struct Capture {
  explicit Capture(const std::shared_ptr<FakeLine>& the_line) : line(the_line), studio(fake_services(the_line)) {
    studio.window->show_workspace(QStringLiteral("capture"));
    workspace = dynamic_cast<CaptureWorkspace*>(studio.window->workspace(QStringLiteral("capture")));
    workspace->model().set_today(QDate(2026, 11, 22));
  }
  template <typename T>
  [[nodiscard]] T* find(const char* name) const {
    return studio.window->findChild<T*>(QString::fromLatin1(name));
  }
  [[nodiscard]] LiveModel& live() const { return studio.context->live(); }
  std::shared_ptr<FakeLine> line;
  StudioFixture studio;
  CaptureWorkspace* workspace = nullptr;
};

inline bool wait_for_devices(Capture& capture) {
  return QTest::qWaitFor([&] { return !capture.workspace->model().devices().empty(); });
}
inline bool choose(Capture& capture, const char* id) {
  if (!wait_for_devices(capture)) {
    return false;
  }
  auto* box = capture.find<QComboBox>("device_box");
  const int index = box->findData(QString::fromLatin1(id));
  box->setCurrentIndex(index);
  Q_EMIT box->activated(index);
  return QTest::qWaitFor([&] { return capture.live().snapshot() != nullptr; });
}

}  // namespace limbwave::ui::testing
