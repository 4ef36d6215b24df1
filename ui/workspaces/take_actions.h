/// What can be done to takes as a whole: new, open, import, demo. Used by menus, the welcome page and drag and drop.
#pragma once

#include <QObject>
#include <QStringList>
#include <QUrl>

#include "common/studio_context.h"

namespace limbwave::ui {

class TakeActions : public QObject {
  Q_OBJECT
 public:
  /// Dialogs belong to `window`.
  TakeActions(StudioContext& context, QWidget* window);

  /// Goes to Capture, ready to record.
  void new_take();
  void choose_and_open();
  void choose_and_import();
  void choose_and_open_animation();
  void open(const QString& folder);
  /// Shows an animation file of another program in Export.
  void open_animation(const QString& file);
  /// What the window is about: the animation that is looked at, else the take.
  void close();
  /// Imports recordings into a new take named after the first, and opens it.
  void import_files(const QStringList& files);
  /// Makes the take in a job and opens it.
  void import_as(const QStringList& files, const QString& name, const QString& rig, const QString& subject);
  /// Opens the demo take of this motion, simulating it first when it is not on disk yet.
  void open_demo(const QString& motion);
  /// Name, subject and sensors of the open take, to be changed.
  void edit_details();

  /// Whether a file is an animation that can be opened.
  static bool is_animation(const QString& file);
  /// Sorts what was dropped on the window into recordings to import, take folders and animations to open; false: none.
  static bool acceptable(const QList<QUrl>& urls);
  void handle_drop(const QList<QUrl>& urls);

 private:
  StudioContext& context_;
  QWidget* window_;
};

}  // namespace limbwave::ui
