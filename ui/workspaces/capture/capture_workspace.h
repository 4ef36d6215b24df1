/// Capture: device, level, live signals and recording on one screen.
#pragma once

#include "workspaces/capture/capture_model.h"
#include "workspaces/workspace.h"

class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace limbwave::ui {

class BoxPanel;
class EmptyState;
class LevelPanel;
class MarkerPanel;
class OverviewPanel;
class RecordPanel;
class ScopeView;
class SensorStrips;
class SourceBar;
class WireView;

class CaptureWorkspace : public Workspace {
  Q_OBJECT
 public:
  explicit CaptureWorkspace(StudioContext& context, QWidget* parent = nullptr);
  void activate() override;
  void deactivate() override;
  void reveal(const QString& topic) override;
  [[nodiscard]] CaptureModel& model() { return model_; }
  /// Rows of the shortcut sheet.
  static std::vector<ShortcutHelp> shortcuts();

 private:
  void make_signals();
  void make_side();
  void make_shortcuts();
  void follow_state();
  void follow_snapshot();
  void show_markers();
  void announce(const take::Take& take);

  StudioContext& context_;
  CaptureModel& model_;
  SourceBar* source_;
  QStackedWidget* center_;
  EmptyState* empty_;
  QPushButton* empty_refresh_;
  QPushButton* empty_simulator_;
  QWidget* live_page_ = nullptr;
  ScopeView* scope_ = nullptr;
  SensorStrips* strips_ = nullptr;
  QScrollArea* side_ = nullptr;
  RecordPanel* record_ = nullptr;
  LevelPanel* level_ = nullptr;
  QWidget* box_page_ = nullptr;  ///< Instead of the live page, of a driver box.
  WireView* wires_ = nullptr;
  BoxPanel* box_ = nullptr;
  MarkerPanel* markers_ = nullptr;
  OverviewPanel* overview_ = nullptr;
  bool searched_ = false;
  int announced_ = 0;  ///< The piece of news about the last recording.
};

}  // namespace limbwave::ui
