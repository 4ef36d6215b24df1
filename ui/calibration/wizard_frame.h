/// What both wizards share: title and steps above, the page, buttons below;
/// Enter goes on, Esc leaves and asks first when something would be lost.
#pragma once

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QWidget>

namespace limbwave::ui {

class WizardFrame : public QWidget {
  Q_OBJECT
 public:
  explicit WizardFrame(const QString& title, QWidget* parent = nullptr);

  /// Adds a page; returns its index.
  int add_page(QWidget* page) { return pages_->addWidget(page); }
  void show_page(int index);
  [[nodiscard]] int page() const { return pages_->currentIndex(); }
  /// A small button at the right of the heading.
  void add_tool(QWidget* tool);
  void set_steps(const QStringList& steps, int current);
  /// The verb on the main button, and why it cannot be pressed now (empty: it
  /// can).
  void set_next(const QString& verb, const QString& obstacle, bool shown = true);
  void set_back(const QString& verb, bool shown);
  void set_note(const QString& note) { note_->setText(note); }
  /// Asks in place whether to leave; answered by `left()` or by going on.
  void ask_leave(const QString& what_is_lost);

  [[nodiscard]] QPushButton* next_button() const { return next_; }
  [[nodiscard]] QPushButton* back_button() const { return back_; }
  [[nodiscard]] QPushButton* cancel_button() const { return cancel_; }

 Q_SIGNALS:
  void next();
  void back();
  void cancel();        ///< Esc or the button; nothing was asked yet.
  void leave_anyway();  ///< The answer to `ask_leave`.

 private:
  QHBoxLayout* header_;
  QLabel* steps_;
  QStackedWidget* pages_;
  QWidget* question_;
  QLabel* question_text_;
  QPushButton* leave_;
  QPushButton* stay_;
  QLabel* note_;
  QPushButton* back_;
  QPushButton* next_;
  QPushButton* cancel_;
};

/// A text that can be read from two metres away: 48 px high, shrinking never.
QLabel* distance_label(QWidget* parent);

}  // namespace limbwave::ui
