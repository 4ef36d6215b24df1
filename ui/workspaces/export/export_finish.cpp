#include "workspaces/export/export_finish.h"

#include <QClipboard>
#include <QDesktopServices>
#include <QEvent>
#include <QFileDialog>
#include <QGuiApplication>
#include <QLineEdit>
#include <QProgressBar>
#include <QSignalBlocker>
#include <QUrl>

#include "common/core_text.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

namespace {

constexpr double kSmallestShown = 1e-6;      // Metres.
constexpr int kIcon = 16, kResultIcon = 20;  // Pixels.

QLabel* told(const char* role, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setProperty("role", QString::fromLatin1(role));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

}  // namespace

ExportFinish::ExportFinish(ExportModel& model, QWidget* parent) : QWidget(parent), model_(model) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid);
  auto* card = new Card({}, this);
  make_file_row(card->body());
  problem_ = add_told(tr("Problem"), card->body());
  warnings_ = add_told(tr("Warnings"), card->body());
  replaced_ = add_told(tr("Note"), card->body());
  make_buttons(card->body());
  column->addWidget(card);
  column->addWidget(make_result());
  connect(&model_, &ExportModel::choices_changed, this, [this] {
    show_plan();
    if (failed_) {
      result_->hide();  // It was about other choices.
    }
  });
  connect(&model_, &ExportModel::file_changed, this, &ExportFinish::show_plan);
  connect(&model_, &ExportModel::prepared_changed, this, &ExportFinish::show_plan);
  connect(&model_.sources(), &ExportSourceList::changed, this, &ExportFinish::show_plan);
  connect(&model_.sources(), &ExportSourceList::replaced, result_, &QWidget::hide);
  connect(&model_, &ExportModel::exporting_changed, this, &ExportFinish::show_job);
  connect(&model_, &ExportModel::exported, this, &ExportFinish::show_result);
  show_plan();
  show_job();
}

ExportFinish::Told ExportFinish::add_told(const QString& name, QVBoxLayout* column) {
  Told made{new QWidget(this), new QLabel(this), told("", this)};
  auto* row = new QHBoxLayout(made.row);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(kGrid);
  row->addWidget(made.icon, 0, Qt::AlignTop);
  row->addWidget(made.text, 1);
  made.text->setAccessibleDescription(name);
  column->addWidget(made.row);
  return made;
}

void ExportFinish::tell(const Told& told, Tone tone, const QString& text) {
  told.text->setText(text);
  told.row->setVisible(!text.isEmpty());
  const QString name = tone == Tone::kUnknown ? QStringLiteral("info") : tone_icon(tone);
  told.icon->setPixmap(icon_pixmap(name, tone_color(palette(), tone), kIcon, devicePixelRatioF()));
}

void ExportFinish::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && result_ != nullptr) {
    show_plan();
  }
}

void ExportFinish::make_file_row(QVBoxLayout* column) {
  file_ = new QLineEdit(this);
  file_->setAccessibleName(tr("File"));
  auto* choose = new QPushButton(tr("Choose…"), this);
  choose->setToolTip(tr("Choose where the file goes"));
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  auto* name = new QLabel(tr("File"), this);
  name->setBuddy(file_);
  row->addWidget(name);
  row->addWidget(file_, 1);
  row->addWidget(choose);
  column->addLayout(row);
  connect(file_, &QLineEdit::textEdited, &model_, &ExportModel::set_file);
  connect(file_, &QLineEdit::editingFinished, this, &ExportFinish::follow_ending);
  connect(choose, &QPushButton::clicked, this, &ExportFinish::browse);
}

void ExportFinish::make_buttons(QVBoxLayout* column) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid);
  progress_ = new QProgressBar(this);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setAccessibleName(tr("Progress of the export"));
  step_ = dim_label({}, this);
  cancel_ = new QPushButton(tr("Cancel"), this);
  export_ = new QPushButton(tr("Export"), this);
  export_->setProperty("primary", true);
  export_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
  export_->setToolTip(tr("Write the file, read it back and compare (Ctrl+E)"));
  row->addWidget(progress_, 1);
  row->addWidget(step_, 1);
  row->addStretch(0);
  row->addWidget(cancel_);
  row->addWidget(export_);
  column->addLayout(row);
  connect(export_, &QPushButton::clicked, this, [this] {
    follow_ending();
    result_->hide();
    model_.start();
  });
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (model_.exporting() != nullptr) {
      model_.exporting()->cancel();
    }
  });
}

QWidget* ExportFinish::make_result() {
  result_ = new QFrame(this);
  result_->setProperty("card", true);
  auto* row = new QHBoxLayout(result_);
  row->setContentsMargins(2 * kGrid, kGrid + 4, 2 * kGrid, kGrid + 4);
  row->setSpacing(kGrid);
  result_icon_ = new QLabel(result_);
  result_text_ = told("", result_);
  result_detail_ = told("dim", result_);
  open_folder_ = new QPushButton(tr("Open folder"), result_);
  copy_path_ = new QPushButton(tr("Copy path"), result_);
  auto* column = new QVBoxLayout;
  column->setSpacing(4);
  column->addWidget(result_text_);
  column->addWidget(result_detail_);
  auto* buttons = new QVBoxLayout;
  buttons->setSpacing(kGrid);
  buttons->addWidget(open_folder_);
  buttons->addWidget(copy_path_);
  buttons->addStretch();
  row->addWidget(result_icon_, 0, Qt::AlignTop);
  row->addLayout(column, 1);
  row->addLayout(buttons);
  connect(open_folder_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(written_.parent_path().string())));
  });
  connect(copy_path_, &QPushButton::clicked, this,
          [this] { QGuiApplication::clipboard()->setText(QString::fromStdString(written_.string())); });
  result_->hide();
  return result_;
}

void ExportFinish::show_plan() {
  if (file_->text() != model_.file()) {
    file_->setText(model_.file());
  }
  file_->setToolTip(model_.file());
  const QString problem = model_.has_source() ? model_.problem() : QString();
  tell(problem_, Tone::kDanger, problem);
  tell(warnings_, Tone::kWarning, model_.warnings().join(QLatin1Char('\n')));
  std::error_code ignored;
  const bool exists = problem.isEmpty() && std::filesystem::exists(model_.file().trimmed().toStdString(), ignored);
  tell(replaced_, Tone::kUnknown,
       exists ? tr("The file exists. It is replaced when the new one is written and checked.") : QString());
  export_->setEnabled(model_.has_source() && problem.isEmpty() && model_.exporting() == nullptr);
}

void ExportFinish::show_job() {
  Job* job = model_.exporting();
  for (QWidget* one : {static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) {
    one->setVisible(job != nullptr);
  }
  progress_->setValue(0);
  step_->clear();
  show_plan();
  if (job == nullptr) {
    return;
  }
  connect(job, &Job::changed, this, [this, job] {
    progress_->setValue(static_cast<int>(1000 * job->fraction()));
    const double left = job->left_s();
    step_->setText(left < 3.0 ? job->step() : tr("%1, %2 left").arg(job->step(), format_clock(left)));
  });
}

void ExportFinish::follow_ending() {
  const std::optional<ExportFormat> format = format_of_file(model_.file().trimmed().toStdString());
  if (format && format->id != model_.choices().format) {
    ExportChoices choices = model_.choices();
    choices.format = format->id;
    model_.change(choices);
  }
}

void ExportFinish::browse() {
  const ExportFormat chosen = export_format(model_.choices().format);
  QStringList filters{tr("%1 (*%2)").arg(chosen.title, chosen.extension)};
  for (const ExportFormat& one : export_formats()) {
    if (one.id != chosen.id) {
      filters << tr("%1 (*%2)").arg(one.title, one.extension);
    }
  }
  const QString file =
      QFileDialog::getSaveFileName(window(), tr("Export to"), model_.file(), filters.join(QStringLiteral(";;")),
                                   nullptr, QFileDialog::DontConfirmOverwrite);
  if (!file.isEmpty()) {
    const bool known = format_of_file(file.toStdString()).has_value();
    model_.set_file(known ? file : with_extension(file, chosen.extension));
    follow_ending();
  }
}

void ExportFinish::show_result(const Result<interchange::ExportReport>& result) {
  const Tone tone = result ? Tone::kGood : (is_cancelled(result.error()) ? Tone::kUnknown : Tone::kDanger);
  result_icon_->setPixmap(icon_pixmap(tone_icon(tone), tone_color(palette(), tone), kResultIcon, devicePixelRatioF()));
  open_folder_->setVisible(result.ok());
  copy_path_->setVisible(result.ok());
  if (result) {
    written_ = result->file;
    result_text_->setText(
        tr("Written and read back: %1").arg(QString::fromStdString(result->file.filename().string())));
    const QString size = tr("%1, %2 frames at %3 Hz, %4, %5 bones, in %6")
                             .arg(size_text(result->bytes), locale().toString(qulonglong(result->frames)),
                                  locale().toString(result->fps, 'g', 6), format_clock_tenths(result->duration_s))
                             .arg(result->bones)
                             .arg(QString::fromStdString(result->file.parent_path().string()));
    const QString distance = result->worst_m < kSmallestShown
                                 ? tr("below %1").arg(locale().toString(1e3 * kSmallestShown, 'f', 3))
                                 : locale().toString(1e3 * result->worst_m, 'f', 3);
    const QString worst = result->worst_joint.empty() ? tr("Every joint is where it belongs.")
                                                      : tr("Largest difference at any key: %1 mm, at %2.")
                                                            .arg(distance, QString::fromStdString(result->worst_joint));
    result_detail_->setText(size + QLatin1Char('\n') + worst);
  } else if (is_cancelled(result.error())) {
    result_text_->setText(tr("Export cancelled."));
    result_detail_->setText(tr("Nothing was written; a file that was there before is as it was."));
  } else {
    const Error& error = result.error();
    result_text_->setText(tr("Not exported. %1").arg(core_sentence(error.message)));
    result_detail_->setText(QStringList{core_sentence(error.remedy), QString::fromStdString(error.place)}
                                .join(QLatin1Char('\n'))
                                .trimmed());
  }
  failed_ = !result.ok();
  result_->show();
}

}  // namespace limbwave::ui
