/// What tests of the Solve workspace share: a studio with a made-up solver, and ways to find what is on the screen.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <cmath>
#include <memory>

#include "ui/support/fake_capture.h"
#include "ui/support/solve_fixture.h"
#include "workspaces/solve/solve_workspace.h"

namespace limbwave::ui::testing {

class SolveWindowTest : public QObject {
 protected:
  std::unique_ptr<FakeSolving> solving_;
  std::unique_ptr<SolveStudio> studio_;

  void start(StudioServices services = {}) {
    solving_ = std::make_unique<FakeSolving>();
    studio_ = std::make_unique<SolveStudio>(solving_->services(), std::move(services));
    QVERIFY(QTest::qWaitForWindowExposed(studio_->window.get()));
  }
  void open(const QString& name = QStringLiteral("swing.take")) {
    studio_->context->document().set(made_up_take(studio_->take_folder(name), solving_->seconds));
    QTRY_COMPARE(studio_->window->current_workspace(), QStringLiteral("solve"));
  }
  void open_solved() {
    start();
    open();
    QTRY_COMPARE(model().state(), SolveState::kSolved);
  }
  [[nodiscard]] SolveModel& model() const { return *studio_->model; }
  [[nodiscard]] SolveWorkspace& workspace() const {
    return *qobject_cast<SolveWorkspace*>(studio_->window->workspace(QStringLiteral("solve")));
  }
  template <typename T>
  [[nodiscard]] T* find(const QString& accessible_name) const {
    for (T* widget : studio_->window->findChildren<T*>()) {
      if (widget->accessibleName() == accessible_name) {
        return widget;
      }
    }
    return nullptr;
  }
  [[nodiscard]] QPushButton* button(const QString& text) const {
    for (QPushButton* one : studio_->window->findChildren<QPushButton*>()) {
      if (one->text() == text && one->isVisible()) {
        return one;
      }
    }
    return nullptr;
  }
  [[nodiscard]] bool says(const QString& text) const {
    for (QLabel* label : studio_->window->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(text)) {
        return true;
      }
    }
    return false;
  }
  void save(const QString& name) const { QVERIFY(studio_->screen().save(screenshot_path(name))); }
  // Heading of a segment in the viewer: angle of its bone about the vertical.
  [[nodiscard]] double azimuth(int segment) const {
    const Eigen::Vector3d x =
        workspace().viewer().pose()[static_cast<std::size_t>(segment)].R_WL * Eigen::Vector3d::UnitX();
    return std::atan2(x.y(), x.x());
  }
};

}  // namespace limbwave::ui::testing
