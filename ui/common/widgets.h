/// Small building blocks that every place of the studio uses, so that all of them look and speak alike.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QToolButton>
#include <QVBoxLayout>
#include <functional>

namespace limbwave::ui {

/// A label for names of any length: shows what fits, the rest in the tooltip.
class ElidedLabel : public QLabel {
  Q_OBJECT
 public:
  explicit ElidedLabel(const QString& text = {}, QWidget* parent = nullptr);
  void set_text(const QString& text);
  [[nodiscard]] const QString& full_text() const { return full_; }
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString full_;
};

/// A quiet ground for things that belong together, with an optional heading; add to `body()`.
class Card : public QFrame {
  Q_OBJECT
 public:
  explicit Card(const QString& heading = {}, QWidget* parent = nullptr);
  [[nodiscard]] QVBoxLayout* body() const { return body_; }
  void set_heading(const QString& heading);

 private:
  QLabel* heading_;
  QVBoxLayout* body_;
};

/// What a place says while it has nothing to show: a picture, what is missing, what to do, the button that does it.
class EmptyState : public QWidget {
  Q_OBJECT
 public:
  explicit EmptyState(const QString& icon_name, QWidget* parent = nullptr);
  void set_texts(const QString& title, const QString& remedy);
  QPushButton* add_button(const QString& text, bool primary);
  /// A quiet link below the buttons: "Learn how", which explains more than a sentence can.
  QLabel* add_link(const QString& text);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void update_icon();
  QString icon_name_;
  QLabel* icon_;
  QLabel* title_;
  QLabel* remedy_;
  QHBoxLayout* buttons_;
  QVBoxLayout* links_;
};

/// States of health: a shape, a colour and words, never colour alone.
enum class Tone { kUnknown, kGood, kWarning, kDanger };

/// The shape of a tone: tick, triangle, octagon, dashed ring.
QString tone_icon(Tone tone);
QColor tone_color(const QPalette& palette, Tone tone);

QLabel* dim_label(const QString& text, QWidget* parent = nullptr);
QLabel* heading_label(const QString& text, QWidget* parent = nullptr);
/// Words that look and behave like a link; `linkActivated` when they are clicked or Enter is pressed on them.
QLabel* link_label(const QString& text, QWidget* parent = nullptr);
/// A flat button with an icon only; the text becomes tooltip and accessible name.
QToolButton* icon_button(const QString& icon_name, const QString& text, QWidget* parent = nullptr);
/// Sets a dynamic property and lets the stylesheet see it.
void set_style_property(QWidget* widget, const char* name, const QVariant& value);

}  // namespace limbwave::ui
