#include "workspaces/form_sheet.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

FormSheet::FormSheet(const QString& title, const QString& sentence, const QString& verb, QWidget* parent)
    : QDialog(parent), layout_(new QVBoxLayout(this)), form_(new QFormLayout), problem_(new QLabel(this)) {
  setWindowTitle(title);
  layout_->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 2 * kGrid);
  layout_->setSpacing(2 * kGrid);
  auto* what = new QLabel(sentence, this);
  what->setWordWrap(true);
  what->setTextFormat(Qt::PlainText);
  layout_->addWidget(what);
  form_->setHorizontalSpacing(2 * kGrid);
  form_->setVerticalSpacing(kGrid);
  form_->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  layout_->addLayout(form_);
  problem_->setObjectName(QStringLiteral("sheet_problem"));
  problem_->setProperty("role", "danger");
  problem_->setWordWrap(true);
  problem_->hide();
  layout_->addWidget(problem_);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(tr("Cancel"), QDialogButtonBox::RejectRole);
  verb_ = buttons->addButton(verb, QDialogButtonBox::AcceptRole);
  verb_->setProperty("primary", true);
  layout_->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  setMinimumWidth(60 * kGrid);
}

void FormSheet::add_row(const QString& label, QWidget* field) {
  field->setAccessibleName(label);
  auto* title = dim_label(label, this);
  title->setBuddy(field);
  form_->addRow(title, field);
}

QLineEdit* FormSheet::add_line(const QString& label, const QString& object_name, const QString& text,
                               const QString& placeholder) {
  auto* line = new QLineEdit(text, this);
  line->setObjectName(object_name);
  line->setPlaceholderText(placeholder);
  line->setMaxLength(200);
  line->setCursorPosition(0);
  add_row(label, line);
  return line;
}

void FormSheet::add_wide(QWidget* widget) {
  layout_->insertWidget(layout_->indexOf(problem_), widget);
}

void FormSheet::set_problem(const QString& problem) {
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  verb_->setEnabled(problem.isEmpty());
}

}  // namespace limbwave::ui
