/// A studio in front of its Export workspace, and how tests find their way on it.
#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>
#include <QUndoStack>
#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "common/widgets.h"
#include "interchange/animation_file.h"
#include "ui/support/solve_fixture.h"
#include "workspaces/export/export_workspace.h"

namespace limbwave::ui::testing {

struct ExportStudio {
  explicit ExportStudio(SolveServices services, StudioServices studio_services = {})
      : studio(std::make_unique<SolveStudio>(std::move(services), std::move(studio_services))) {}

  /// With a made-up take of eight seconds, solved.
  bool open_take() const {
    studio->context->document().set(made_up_take(studio->take_folder(QStringLiteral("swing.take")), 8.0));
    const bool solved = QTest::qWaitFor([this] { return studio->model->state() == SolveState::kSolved; }, 20000);
    studio->window->show_workspace(QStringLiteral("export"));
    return solved && settle();
  }
  /// Drops a file onto the window, as a file manager does.
  void drop(const QString& file) const {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(studio->window.get(), &enter);
    QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(studio->window.get(), &event);
  }
  bool open_animation(const QString& file) const {
    drop(file);
    const std::filesystem::path origin = file.toStdString();
    if (studio->window->workspace(QStringLiteral("export")) == nullptr) {
      return false;
    }
    return QTest::qWaitFor(
               [&] {
                 const ExportSource* source = model().sources().source();
                 return source != nullptr && source->origin == origin;
               },
               30000) &&
           settle();
  }
  /// Until what is shown is what is chosen, or was refused.
  bool settle() const {
    return QTest::qWaitFor(
        [this] { return model().preparing() == nullptr && (model().up_to_date() || model().refusal().has_value()); },
        60000);
  }
  [[nodiscard]] ExportWorkspace& workspace() const {
    return *qobject_cast<ExportWorkspace*>(studio->window->workspace(QStringLiteral("export")));
  }
  [[nodiscard]] ExportModel& model() const { return workspace().model(); }
  [[nodiscard]] ExportPreview& preview() const { return workspace().preview(); }

  template <typename T>
  [[nodiscard]] T* find(const char* accessible_name) const {
    for (T* widget : studio->window->findChildren<T*>()) {
      if (widget->accessibleName() == QString::fromUtf8(accessible_name) && widget->isVisibleTo(studio->window.get())) {
        return widget;
      }
    }
    return nullptr;
  }
  [[nodiscard]] QPushButton* button(const char* text) const {
    for (QPushButton* one : studio->window->findChildren<QPushButton*>()) {
      if (one->text() == QString::fromUtf8(text) && one->isVisibleTo(studio->window.get())) {
        return one;
      }
    }
    return nullptr;
  }
  [[nodiscard]] bool says(const QString& text) const {
    for (QLabel* label : studio->window->findChildren<QLabel*>()) {
      const auto* elided = qobject_cast<ElidedLabel*>(label);
      const QString shown = elided != nullptr ? elided->full_text() : label->text();
      if (label->isVisibleTo(studio->window.get()) && shown.contains(text)) {
        return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool says(const char* text) const { return says(QString::fromUtf8(text)); }
  [[nodiscard]] QLineEdit* file() const { return find<QLineEdit>("File"); }
  /// Types a name as people do.
  void type_file(const QString& name) const {
    file()->setFocus();
    file()->selectAll();
    if (name.isEmpty()) {
      QTest::keyClick(file(), Qt::Key_Delete);
    } else {
      QTest::keyClicks(file(), name);
    }
    QTest::keyClick(file(), Qt::Key_Return);
  }
  /// Picks the entry of a box by what stands there; false when there is none.
  bool pick(const char* box_name, const QString& text) const {
    auto* box = find<QComboBox>(box_name);
    const int index = box == nullptr ? -1 : box->findText(text, Qt::MatchStartsWith);
    if (index < 0) {
      return false;
    }
    box->setCurrentIndex(index);
    return true;
  }
  bool pick(const char* box_name, const char* text) const { return pick(box_name, QString::fromUtf8(text)); }
  void press_export() const { QTest::mouseClick(button("Export"), Qt::LeftButton); }
  /// Presses Export and waits for what comes of it; false when nothing does.
  bool export_now() const {
    if (button("Export") == nullptr || !button("Export")->isEnabled()) {
      return false;
    }
    bool done = false, good = false;
    const auto connection = QObject::connect(&model(), &ExportModel::exported, &model(),
                                             [&](const Result<interchange::ExportReport>& result) {
                                               done = true;
                                               good = result.ok();
                                             });
    press_export();
    const bool ended = QTest::qWaitFor([&] { return done; }, 120000);
    QObject::disconnect(connection);
    return ended && good;
  }
  void save(const QString& name) const { QVERIFY(studio->screen().save(screenshot_path(name))); }
  [[nodiscard]] std::filesystem::path path(const QString& name) const {
    return studio->folder.filePath(name).toStdString();
  }

  std::unique_ptr<SolveStudio> studio;
};

/// What every test of the page has: made-up solving and, once it is opened, a studio in front of it.
class ExportCase {
 protected:
  void set_up() {
    apply_theme(*qApp, ThemeKind::kDark);
    solving_ = std::make_unique<FakeSolving>();
  }
  void tear_down() {
    studio_.reset();
    solving_.reset();
  }
  /// Without a take; another size than the usual where one is given.
  bool open_studio(SolveServices services, QSize size = {}) {
    studio_ = std::make_unique<ExportStudio>(std::move(services));
    if (size.isValid()) {
      studio_->studio->window->resize(size);
    }
    return QTest::qWaitForWindowExposed(studio_->studio->window.get());
  }
  [[nodiscard]] ExportModel& model() const { return studio_->model(); }
  [[nodiscard]] QUndoStack& undo() const { return studio_->studio->context->undo_stack(); }
  /// A chain of three bones in a file beside the takes.
  [[nodiscard]] QString chain(const char* name) const;

  std::unique_ptr<FakeSolving> solving_;
  std::unique_ptr<ExportStudio> studio_;
};

/// A recorded walk of a whole body (31 joints); empty where the recordings are not there.
inline QString recorded_motion(const QString& name = QStringLiteral("02_01.bvh")) {
  const char* data = std::getenv("LIMBWAVE_DATA");
  const std::filesystem::path file =
      std::filesystem::path(data == nullptr ? "." : data) / "motions" / name.toStdString();
  return std::filesystem::exists(file) ? QString::fromStdString(file.string()) : QString();
}

/// A chain of three bones in a BVH file, `metres` away from the origin and moving on 1.234 cm a frame.
inline bool write_chain(const std::filesystem::path& file, double metres, int frames = 20) {
  std::string text =
      "HIERARCHY\nROOT hips\n{\n OFFSET 0 0 0\n CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
      "Yrotation\n"
      " JOINT chest\n {\n  OFFSET 0 40 0\n  CHANNELS 3 Zrotation Xrotation Yrotation\n"
      "  JOINT head\n  {\n   OFFSET 0 30 0\n   CHANNELS 3 Zrotation Xrotation Yrotation\n"
      "   End Site\n   {\n    OFFSET 0 20 0\n   }\n  }\n }\n}\nMOTION\nFrames: " +
      std::to_string(frames) + "\nFrame Time: 0.0333333\n";
  for (int i = 0; i < frames; ++i) {
    text += std::to_string(100.0 * metres + 1.234 * i) + " 90 0 " + std::to_string(3 * i) + " 0 0 0 " +
            std::to_string(2 * i) + " 0 0 0 " + std::to_string(5 * i) + "\n";
  }
  return write_file(file, text).ok();
}

inline QString ExportCase::chain(const char* name) const {
  const QString file = studio_->studio->folder.filePath(QString::fromUtf8(name));
  return write_chain(file.toStdString(), 0.0) ? file : QString();
}

}  // namespace limbwave::ui::testing
