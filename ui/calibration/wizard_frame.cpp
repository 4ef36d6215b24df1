#include "calibration/wizard_frame.h"

#include <QHBoxLayout>
#include <QShortcut>
#include <QVBoxLayout>

#include "common/theme.h"
#include "common/widgets.h"

namespace limbwave::ui {

QLabel* distance_label(QWidget* parent) {
  auto* label = new QLabel(parent);
  QFont font = label->font();
  font.setPixelSize(48);
  font.setWeight(QFont::DemiBold);
  label->setFont(font);
  label->setStyleSheet(QStringLiteral("font-size: 48px; font-weight: 600;"));
  label->setWordWrap(true);
  return label;
}

WizardFrame::WizardFrame(const QString& title, QWidget* parent)
    : QWidget(parent),
      header_(new QHBoxLayout),
      steps_(dim_label({}, this)),
      pages_(new QStackedWidget(this)),
      question_(new QFrame(this)),
      question_text_(new QLabel(question_)),
      leave_(new QPushButton(tr("Leave"), question_)),
      stay_(new QPushButton(tr("Stay"), question_)),
      note_(dim_label({}, this)),
      back_(new QPushButton(tr("Back"), this)),
      next_(new QPushButton(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setFocusPolicy(Qt::StrongFocus);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(3 * kGrid, 2 * kGrid, 3 * kGrid, 2 * kGrid);
  layout->setSpacing(2 * kGrid);
  auto* heading = new QLabel(title, this);
  heading->setStyleSheet(QStringLiteral("font-size: 20px;"));
  header_->addWidget(heading);
  header_->addStretch();
  steps_->setTextFormat(Qt::RichText);
  header_->addWidget(steps_);
  layout->addLayout(header_);
  layout->addWidget(pages_, 1);

  question_->setProperty("card", true);
  question_->setObjectName(QStringLiteral("leave_question"));
  auto* question_layout = new QHBoxLayout(question_);
  question_text_->setWordWrap(true);
  question_layout->addWidget(question_text_, 1);
  stay_->setProperty("primary", true);
  leave_->setObjectName(QStringLiteral("leave"));
  stay_->setObjectName(QStringLiteral("stay"));
  question_layout->addWidget(leave_);
  question_layout->addWidget(stay_);
  question_->hide();
  layout->addWidget(question_);

  auto* footer = new QHBoxLayout;
  footer->setSpacing(kGrid);
  note_->setWordWrap(true);
  note_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  footer->addWidget(note_, 1);
  footer->addWidget(cancel_);
  footer->addWidget(back_);
  footer->addWidget(next_);
  layout->addLayout(footer);
  next_->setProperty("primary", true);
  next_->setObjectName(QStringLiteral("next"));
  back_->setObjectName(QStringLiteral("back"));
  cancel_->setObjectName(QStringLiteral("cancel"));
  cancel_->setToolTip(tr("Esc"));

  connect(next_, &QPushButton::clicked, this, &WizardFrame::next);
  connect(back_, &QPushButton::clicked, this, &WizardFrame::back);
  connect(cancel_, &QPushButton::clicked, this, &WizardFrame::cancel);
  connect(leave_, &QPushButton::clicked, this, [this] {
    question_->hide();
    Q_EMIT leave_anyway();
  });
  connect(stay_, &QPushButton::clicked, question_, &QWidget::hide);
  for (const int key : {Qt::Key_Return, Qt::Key_Enter}) {
    auto* enter = new QShortcut(QKeySequence(key), this);
    enter->setContext(Qt::WidgetWithChildrenShortcut);
    connect(enter, &QShortcut::activated, this, [this] {
      if (!question_->isHidden()) {
        question_->hide();
      } else if (next_->isEnabled() && !next_->isHidden()) {
        Q_EMIT next();
      }
    });
  }
  auto* escape = new QShortcut(QKeySequence(Qt::Key_Escape), this);
  escape->setContext(Qt::WidgetWithChildrenShortcut);
  connect(escape, &QShortcut::activated, this, [this] {
    if (!question_->isHidden()) {
      question_->hide();
    } else {
      Q_EMIT cancel();
    }
  });
}

void WizardFrame::add_tool(QWidget* tool) {
  header_->addSpacing(kGrid);
  header_->addWidget(tool);
}

void WizardFrame::show_page(int index) {
  question_->hide();
  pages_->setCurrentIndex(index);
  // Keys reach the wizard only while it has the focus; no button gets it, so
  // that Space presses none by accident.
  if (isVisible()) {
    setFocus();
  }
}

void WizardFrame::set_steps(const QStringList& steps, int current) {
  QStringList parts;
  for (int i = 0; i < steps.size(); ++i) {
    const QString text = QStringLiteral("%1&nbsp;%2").arg(i + 1).arg(steps[i].toHtmlEscaped());
    parts << (i == current ? QStringLiteral("<b><span style='color:%1'>%2</span></b>")
                                 .arg(theme_colors(palette()).accent.name(), text)
                           : text);
  }
  steps_->setText(parts.join(QStringLiteral("&nbsp;&nbsp;&nbsp;›&nbsp;&nbsp;&nbsp;")));
}

void WizardFrame::set_next(const QString& verb, const QString& obstacle, bool shown) {
  next_->setText(verb);
  next_->setEnabled(obstacle.isEmpty());
  next_->setToolTip(obstacle.isEmpty() ? tr("Enter") : obstacle);
  next_->setVisible(shown);
}

void WizardFrame::set_back(const QString& verb, bool shown) {
  back_->setText(verb);
  back_->setVisible(shown);
}

void WizardFrame::ask_leave(const QString& what_is_lost) {
  question_text_->setText(what_is_lost);
  question_->show();
  stay_->setFocus();
}

}  // namespace limbwave::ui
