/// Markers of the running recording, or of the open take: set by key, renamed and moved in place, deleted.
#pragma once

#include "common/studio_context.h"
#include "common/widgets.h"

class QTableWidget;
class QToolButton;

namespace limbwave::ui {

class MarkerPanel : public Card {
  Q_OBJECT
 public:
  explicit MarkerPanel(StudioContext& context, QWidget* parent = nullptr);
  /// Opens the field for the name of a marker.
  void edit_name(std::int64_t number);

 private:
  void refresh();
  void refresh_buttons();
  void follow_selection();
  void accept_edit(std::int64_t number, int column, const QString& text);
  void choose_row(int row);
  void remove_selected();
  [[nodiscard]] std::int64_t number_of(int row) const;
  [[nodiscard]] int row_of(std::int64_t number) const;

  StudioContext& context_;
  QTableWidget* table_;
  QPushButton* mark_;
  QToolButton* rename_;
  QToolButton* remove_;
  QLabel* hint_;
};

}  // namespace limbwave::ui
