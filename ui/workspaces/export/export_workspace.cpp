#include "workspaces/export/export_workspace.h"

#include <QComboBox>
#include <QDesktopServices>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QProgressBar>
#include <QScrollArea>
#include <QStackedWidget>
#include <QUrl>
#include <cmath>

#include "common/core_text.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/theme.h"

namespace limbwave::ui {

namespace {

constexpr int kFormWidth = 640;
constexpr int kPreviewWidth = 320;
const auto kLastRate = QStringLiteral("export/fps");
const auto kLastUnit = QStringLiteral("export/unit");

QString sentence(const std::string& text) {
  QString made = core_text(text);
  if (!made.isEmpty()) {
    made[0] = made[0].toUpper();
    if (!made.endsWith(QLatin1Char('.'))) {
      made += QLatin1Char('.');
    }
  }
  return made;
}

}  // namespace

ExportWorkspace::ExportWorkspace(StudioContext& context, QWidget* parent)
    : Workspace(parent), context_(context), model_(SolveModel::of(context)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  layout->addWidget(pages_);
  empty_ = new EmptyState(QStringLiteral("export"), pages_);
  empty_button_ = empty_->add_button(tr("Go to Solve"), true);
  pages_->addWidget(empty_);
  // The form scrolls where it does not fit; the picture stays in view.
  auto* page = new QWidget(pages_);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(3 * kGrid, 3 * kGrid, 3 * kGrid, 3 * kGrid);
  row->setSpacing(2 * kGrid);
  auto* area = new QScrollArea(page);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  QWidget* form = make_form();
  form->setMaximumWidth(kFormWidth);
  area->setWidget(form);
  area->setMinimumWidth(form->minimumSizeHint().width());
  area->setMaximumWidth(kFormWidth);
  preview_ = new ExportPreview(context_, model_, page);
  preview_->setMinimumWidth(kPreviewWidth);
  row->addWidget(area, 1);
  row->addWidget(preview_, 1);
  pages_->addWidget(page);
  follow();
  show_take();
}

QWidget* ExportWorkspace::make_source_rows() {
  auto* rows = new QWidget(this);
  auto* form = new QFormLayout(rows);
  form->setContentsMargins(0, 0, 0, 0);
  form->setHorizontalSpacing(2 * kGrid);
  form->setVerticalSpacing(kGrid + 4);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  solves_ = new QComboBox(rows);
  formats_ = new QComboBox(rows);
  for (const ExportFormat& one : export_formats()) {
    formats_->addItem(one.title, one.id);
  }
  format_hint_ = dim_label({}, rows);
  rates_ = new QComboBox(rows);
  for (const double rate : export_rates()) {
    rates_->addItem(tr("%1 frames a second").arg(rate), rate);
  }
  rates_->addItem(tr("Another rate"), 0.0);
  custom_rate_ = new QDoubleSpinBox(rows);
  custom_rate_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  custom_rate_->setRange(kLowestRate, kHighestRate);
  custom_rate_->setDecimals(3);
  custom_rate_->setSuffix(tr(" Hz"));
  custom_rate_->setAccessibleName(tr("Frames a second"));
  custom_rate_->setMinimumWidth(16 * kGrid);
  units_ = new QComboBox(rows);
  units_->addItem(tr("Centimetres (most programs)"), static_cast<int>(ExportUnit::kCentimetres));
  units_->addItem(tr("Metres (Blender's own)"), static_cast<int>(ExportUnit::kMetres));
  ranges_ = new QComboBox(rows);
  ranges_->addItem({});
  ranges_->addItem({});
  file_ = new QLineEdit(rows);
  auto* choose = new QPushButton(tr("Choose…"), rows);
  connect(choose, &QPushButton::clicked, this, &ExportWorkspace::browse);

  auto* rate_row = new QHBoxLayout;
  rate_row->addWidget(rates_, 1);
  rate_row->addWidget(custom_rate_);
  auto* file_row = new QHBoxLayout;
  file_row->addWidget(file_, 1);
  file_row->addWidget(choose);
  form->addRow(tr("Solve"), solves_);
  form->addRow(tr("Format"), formats_);
  form->addRow(QString(), format_hint_);
  form->addRow(tr("Frame rate"), rate_row);
  form->addRow(tr("Unit of length"), units_);
  form->addRow(tr("Range"), ranges_);
  form->addRow(tr("File"), file_row);
  // Names for screen readers, since a layout in a row has no buddy of its own.
  solves_->setAccessibleName(tr("Solve"));
  formats_->setAccessibleName(tr("Format"));
  rates_->setAccessibleName(tr("Frame rate"));
  units_->setAccessibleName(tr("Unit of length"));
  ranges_->setAccessibleName(tr("Range"));
  file_->setAccessibleName(tr("File"));
  return rows;
}

QWidget* ExportWorkspace::make_result() {
  auto* card = new QFrame(this);
  card->setProperty("card", true);
  auto* row = new QHBoxLayout(card);
  row->setContentsMargins(2 * kGrid, kGrid + 4, 2 * kGrid, kGrid + 4);
  row->setSpacing(kGrid);
  result_icon_ = new QLabel(card);
  result_text_ = new QLabel(card);
  result_text_->setWordWrap(true);
  result_text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  result_detail_ = dim_label({}, card);
  result_detail_->setWordWrap(true);
  result_detail_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout;
  column->setSpacing(4);
  column->addWidget(result_text_);
  column->addWidget(result_detail_);
  show_ = new QPushButton(tr("Show in folder"), card);
  row->addWidget(result_icon_, 0, Qt::AlignTop);
  row->addLayout(column, 1);
  row->addWidget(show_, 0, Qt::AlignTop);
  connect(show_, &QPushButton::clicked, this, [this] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QString::fromStdString(written_.parent_path().string())));
  });
  return card;
}

QWidget* ExportWorkspace::make_form() {
  auto* column = new QWidget(this);
  auto* layout = new QVBoxLayout(column);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2 * kGrid);
  auto* card = new Card(tr("Export"), column);
  card->body()->addWidget(make_source_rows());
  problem_ = new QLabel(card);
  problem_->setProperty("role", QStringLiteral("danger"));
  problem_->setWordWrap(true);
  card->body()->addWidget(problem_);
  facts_ = dim_label({}, card);
  facts_->setFont(tabular(font()));
  facts_->setWordWrap(true);
  card->body()->addWidget(facts_);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid);
  progress_ = new QProgressBar(card);
  progress_->setRange(0, 1000);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  step_ = dim_label({}, card);
  cancel_ = new QPushButton(tr("Cancel"), card);
  export_ = new QPushButton(tr("Export"), card);
  export_->setProperty("primary", true);
  export_->setShortcut(QKeySequence(Qt::CTRL | Qt::Key_E));
  export_->setToolTip(tr("Write the file (Ctrl+E)"));
  buttons->addWidget(progress_, 1);
  buttons->addWidget(step_, 1);
  buttons->addStretch(0);
  buttons->addWidget(cancel_);
  buttons->addWidget(export_);
  card->body()->addLayout(buttons);
  layout->addWidget(card);
  result_ = make_result();
  layout->addWidget(result_);
  layout->addStretch(1);
  progress_->hide();
  cancel_->hide();
  result_->hide();
  return column;
}

void ExportWorkspace::follow() {
  connect(&model_, &SolveModel::state_changed, this, &ExportWorkspace::show_take);
  connect(&model_, &SolveModel::solve_changed, this, &ExportWorkspace::show_take);
  connect(&context_.document(), &TakeDocument::changed, this, [this](bool other) {
    if (other) {
      result_->hide();
      suggested_.clear();
      file_->clear();
    }
    show_take();
  });
  connect(&context_.document(), &TakeDocument::described, this, &ExportWorkspace::show_take);
  for (QComboBox* box : {solves_, formats_, rates_, units_, ranges_}) {
    connect(box, &QComboBox::currentIndexChanged, this, &ExportWorkspace::show_plan);
  }
  connect(&context_.time(), &TimeModel::visible_changed, this, [this] {
    show_ranges();
    show_plan();
  });
  connect(custom_rate_, &QDoubleSpinBox::valueChanged, this, &ExportWorkspace::show_plan);
  connect(file_, &QLineEdit::textChanged, this, &ExportWorkspace::show_plan);
  connect(export_, &QPushButton::clicked, this, &ExportWorkspace::start);
  connect(cancel_, &QPushButton::clicked, this, [this] {
    if (job_) {
      job_->cancel();
    }
  });
  connect(empty_button_, &QPushButton::clicked, this, [this] { context_.reveal(QStringLiteral("solve")); });
  const double rate = context_.settings().value(kLastRate, 60.0).toDouble();
  const int index = rates_->findData(rate);
  rates_->setCurrentIndex(index >= 0 ? index : rates_->count() - 1);
  custom_rate_->setValue(rate);
  units_->setCurrentIndex(std::max(0, units_->findData(context_.settings().value(kLastUnit, 0).toInt())));
}

void ExportWorkspace::activate() {
  show_take();
  preview_->set_active(true);
}

void ExportWorkspace::deactivate() {
  preview_->set_active(false);
}

void ExportWorkspace::show_ranges() {
  const TimeModel& time = context_.time();
  ranges_->setItemText(0, tr("Everything (%1)").arg(format_clock_tenths(time.duration_s())));
  ranges_->setItemText(
      1, tr("What the timeline shows (%1 to %2)")
             .arg(format_clock_tenths(time.visible_begin_s()), format_clock_tenths(time.visible_end_s())));
}

void ExportWorkspace::show_take() {
  const bool ready = model_.solve() != nullptr && context_.document().is_open();
  pages_->setCurrentIndex(ready ? 1 : 0);
  if (!ready) {
    const bool open = context_.document().is_open();
    const bool busy = model_.state() == SolveState::kSolving || model_.state() == SolveState::kLoading;
    empty_->set_texts(
        !open ? tr("No take is open") : (busy ? tr("The take is being solved") : tr("Nothing is solved yet")),
        !open ? tr("Open or capture one first.")
              : (busy ? tr("It can be exported in a moment.") : tr("Solve the take first.")));
    empty_button_->setVisible(open);
    return;
  }
  show_solves();
  show_ranges();
  show_plan();
}

void ExportWorkspace::show_solves() {
  const QString before = solves_->currentData().toString();
  const QSignalBlocker quiet(solves_);
  solves_->clear();
  const QString current = QString::fromStdString(model_.settings().name);
  solves_->addItem(tr("%1 (open, with your edits)").arg(current), current);
  for (const std::string& name : model_.services().list(*context_.document().take())) {
    if (name != model_.settings().name) {
      solves_->addItem(QString::fromStdString(name), QString::fromStdString(name));
    }
  }
  solves_->setCurrentIndex(std::max(0, solves_->findData(before)));
}

ExportFormat ExportWorkspace::format() const {
  return export_formats()[static_cast<std::size_t>(std::max(0, formats_->currentIndex()))];
}

ExportPlan ExportWorkspace::plan() const {
  ExportPlan made;
  const double rate = rates_->currentData().toDouble();
  made.fps = rate > 0.0 ? rate : custom_rate_->value();
  made.unit = static_cast<ExportUnit>(units_->currentData().toInt());
  made.file = file_->text().trimmed().toStdString();
  if (ranges_->currentIndex() == 1) {
    made.begin_s = context_.time().visible_begin_s();
    made.end_s = context_.time().visible_end_s();
  }
  return made;
}

void ExportWorkspace::show_plan() {
  if (!model_.solve() || !context_.document().is_open()) {
    return;
  }
  const std::string solve = solves_->currentData().toString().toStdString();
  const QString name = QString::fromStdString(
      default_export_file(context_.document().take()->folder, solve, format().extension).string());
  if (file_->text() == suggested_ && suggested_ != name) {
    suggested_ = name;
    file_->setText(name);  // Comes back here.
    return;
  }
  const ExportPlan wanted = plan();
  format_hint_->setText(format().hint);
  custom_rate_->setVisible(rates_->currentData().toDouble() <= 0.0);
  const QString problem = export_file_problem(wanted.file, format().extension);
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  file_->setToolTip(file_->text());
  std::error_code ignored;
  const bool exists = problem.isEmpty() && std::filesystem::exists(wanted.file, ignored);
  const motion::Clip& clip = model_.solve()->clip;
  const bool open = solves_->currentIndex() == 0;
  const double duration_s = range_of(wanted, clip.duration()).duration_s();
  QString facts = open ? tr("%1 frames, %2, %3 bones.")
                             .arg(locale().toString(qulonglong(motion::frame_count(duration_s, wanted.fps))),
                                  format_clock_tenths(duration_s))
                             .arg(clip.skeleton.segments.size())
                       : QString();
  if (exists) {
    facts += tr(" The file exists and will be replaced.");
  }
  facts_->setText(facts);
  export_->setEnabled(problem.isEmpty() && !job_);
  preview_->set_plan(wanted, open);
}

void ExportWorkspace::browse() {
  const ExportFormat chosen = format();
  QString file = QFileDialog::getSaveFileName(this, tr("Export to"), file_->text(),
                                              tr("%1 (*%2)").arg(chosen.title, chosen.extension), nullptr,
                                              QFileDialog::DontConfirmOverwrite);
  if (file.isEmpty()) {
    return;
  }
  if (!file.endsWith(chosen.extension, Qt::CaseInsensitive)) {
    file += chosen.extension;
  }
  file_->setText(file);
}

void ExportWorkspace::start() {
  const ExportPlan wanted = plan();
  context_.settings().setValue(kLastRate, wanted.fps);
  context_.settings().setValue(kLastUnit, static_cast<int>(wanted.unit));
  result_->hide();
  const bool open = solves_->currentIndex() == 0;
  const std::string name = solves_->currentData().toString().toStdString();
  job_ = context_.jobs().compute<ExportResult>(
      tr("Exporting %1").arg(QString::fromStdString(wanted.file.filename().string())), this,
      [wanted, open, name, edited = model_.edited(), load = model_.services().load, write = model_.services().write_bvh,
       take = context_.document().take()](const Progress& progress) -> Result<ExportResult> {
        if (open) {
          return export_clip(edited().clip, wanted, write, progress);
        }
        const Result<solve::Solve> loaded = load(*take, name);
        return loaded ? export_clip(loaded->clip, wanted, write, progress) : Result<ExportResult>(loaded.error());
      },
      [this](const Result<ExportResult>& result) {
        job_.clear();
        progress_->hide();
        cancel_->hide();
        step_->clear();
        show_result(result);
        show_plan();
      });
  connect(job_, &Job::changed, this, [this] {
    if (job_) {
      progress_->setValue(static_cast<int>(1000 * job_->fraction()));
      const double left = job_->left_s();
      step_->setText(left < 3.0 ? job_->step() : tr("%1, %2 left").arg(job_->step(), format_clock(left)));
    }
  });
  progress_->setValue(0);
  progress_->show();
  cancel_->show();
  export_->setEnabled(false);
}

void ExportWorkspace::show_result(const Result<ExportResult>& result) {
  const Tone tone = result ? Tone::kGood : (is_cancelled(result.error()) ? Tone::kUnknown : Tone::kDanger);
  result_icon_->setPixmap(icon_pixmap(tone_icon(tone), tone_color(palette(), tone), 20, devicePixelRatioF()));
  show_->setVisible(result.ok());
  if (result) {
    written_ = result->file;
    result_text_->setText(
        tr("Written and read back: %1").arg(QString::fromStdString(result->file.filename().string())));
    result_detail_->setText(tr("%1, %2 frames at %3 Hz, %4, %5 bones, in %6")
                                .arg(size_text(result->bytes), locale().toString(qulonglong(result->frames)),
                                     locale().toString(result->fps, 'g', 6), format_clock_tenths(result->duration_s))
                                .arg(result->bones)
                                .arg(QString::fromStdString(result->file.parent_path().string())));
  } else if (is_cancelled(result.error())) {
    result_text_->setText(tr("Export cancelled."));
    result_detail_->setText(tr("No file was left behind."));
  } else {
    const Error& error = result.error();
    result_text_->setText(tr("Not exported. %1").arg(sentence(error.message)));
    result_detail_->setText(
        QStringList{sentence(error.remedy), QString::fromStdString(error.place)}.join(QLatin1Char('\n')).trimmed());
  }
  result_->show();
}

}  // namespace limbwave::ui
