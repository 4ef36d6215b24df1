/// A small dialog of labelled fields: a sentence on top, a form, what is wrong with it, and one verb beside "Cancel".
#pragma once

#include <QDialog>
#include <QString>

class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace limbwave::ui {

class FormSheet : public QDialog {
  Q_OBJECT
 public:
  FormSheet(const QString& title, const QString& sentence, const QString& verb, QWidget* parent);

 protected:
  /// A row of the form; the label's text is for people and for screen readers.
  void add_row(const QString& label, QWidget* field);
  /// A line of text as a row.
  QLineEdit* add_line(const QString& label, const QString& object_name, const QString& text,
                      const QString& placeholder);
  /// Below the rows, over the whole width.
  void add_wide(QWidget* widget);
  /// Why the verb cannot be done now; empty: it can.
  void set_problem(const QString& problem);
  [[nodiscard]] QPushButton* verb() const { return verb_; }

 private:
  QVBoxLayout* layout_;
  QFormLayout* form_;
  QLabel* problem_;
  QPushButton* verb_;
};

}  // namespace limbwave::ui
