#include "workspaces/solve/quality_card.h"

#include <QGridLayout>
#include <algorithm>

#include "base/units.h"
#include "common/format.h"
#include "common/icons.h"
#include "common/shown_names.h"
#include "common/theme.h"

namespace limbwave::ui {

namespace {

constexpr std::size_t kMostFindings = 12;  // More than that nobody reads; their number is told.
constexpr int kToneIcon = 16;

QLabel* number_label(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setFont(tabular(parent->font()));
  label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  return label;
}

QLabel* tone_label(Tone tone, QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setPixmap(
      icon_pixmap(tone_icon(tone), tone_color(parent->palette(), tone), kToneIcon, parent->devicePixelRatioF()));
  label->setFixedWidth(kToneIcon + 4);
  return label;
}

// The shape and colour of a verdict beside its words, the remedy under them.
void add_verdict(QVBoxLayout* layout, const Verdict& verdict, bool strong, QWidget* parent) {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  row->addWidget(tone_label(verdict.tone, parent), 0, Qt::AlignTop);
  auto* text = new QLabel(verdict.text, parent);
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  if (strong) {
    QFont font = parent->font();
    font.setWeight(QFont::DemiBold);
    text->setFont(font);
  }
  auto* column = new QVBoxLayout;
  column->setSpacing(2);
  column->addWidget(text);
  if (!verdict.remedy.isEmpty()) {
    QLabel* remedy = dim_label(verdict.remedy, parent);
    remedy->setWordWrap(true);
    column->addWidget(remedy);
  }
  row->addLayout(column, 1);
  layout->addLayout(row);
}

QWidget* fresh_content(QWidget*& content, Card* card) {
  delete content;
  content = new QWidget(card);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid);
  card->body()->addWidget(content);
  return content;
}

QGridLayout* table(const QStringList& titles, QWidget* parent) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(kGrid);
  grid->setVerticalSpacing(4);
  for (int i = 0; i < static_cast<int>(titles.size()); ++i) {
    QLabel* title = dim_label(titles[i], parent);
    title->setAlignment(i == 0 ? Qt::AlignLeft : Qt::AlignRight);
    grid->addWidget(title, 0, i);
  }
  grid->setColumnStretch(0, 1);
  return grid;
}

}  // namespace

QualityCard::QualityCard(SolveModel& model, QWidget* parent) : Card(tr("Quality"), parent), model_(model) {
  connect(&model_, &SolveModel::solve_changed, this, &QualityCard::rebuild);
  connect(&model_, &SolveModel::evaluation_changed, this, &QualityCard::rebuild);
  rebuild();
}

void QualityCard::rebuild() {
  QWidget* content = fresh_content(content_, this);
  auto* layout = static_cast<QVBoxLayout*>(content->layout());
  if (!model_.solve()) {
    QLabel* nothing = dim_label(tr("Numbers appear here once the take is solved."), content);
    nothing->setWordWrap(true);
    layout->addWidget(nothing);
    return;
  }
  const solve::QualityReport& report = model_.solve()->report;
  const Verdict headline = overall_verdict(report, model_.evaluation() ? &*model_.evaluation() : nullptr);
  add_verdict(layout, headline, true, content);

  if (is_by_body_filter(report)) {
    add_uncertainty(layout, content);
  } else {
    add_sensors(layout, report, headline, content);
  }
  const std::size_t shown = std::min(report.diagnostics.size(), kMostFindings);
  for (std::size_t i = 0; i < shown; ++i) {
    if (const Verdict verdict = diagnostic_verdict(report.diagnostics[i]); verdict.text != headline.text) {
      add_verdict(layout, verdict, false, content);
    }
  }
  if (report.diagnostics.size() > shown) {
    layout->addWidget(
        dim_label(tr("and %n more finding(s)", nullptr, static_cast<int>(report.diagnostics.size() - shown)), content));
  }
  QLabel* times =
      dim_label(tr("%1 of take; decoded in %2 s, solved in %3 s")
                    .arg(format_clock_tenths(report.take_seconds), locale().toString(report.decode_seconds, 'f', 2),
                         locale().toString(report.solve_seconds, 'f', 2)),
                content);
  times->setWordWrap(true);
  layout->addWidget(times);
}

// How sure the filter is of the joints, on average over the take.
void QualityCard::add_uncertainty(QVBoxLayout* layout, QWidget* content) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const std::vector<float>& joints : model_.solve()->uncertainty.joint) {
    for (const float sigma : joints) {
      sum += static_cast<double>(sigma);
      count += sigma > 0.0F ? 1U : 0U;
    }
  }
  if (count > 0) {
    QLabel* label = dim_label(tr("Joints ± %1° on average (1 σ, by the filter itself)")
                                  .arg(locale().toString(degrees(sum / static_cast<double>(count)), 'f', 1)),
                              content);
    label->setWordWrap(true);
    layout->addWidget(label);
  }
}

// The accelerometers of a sound card's board, and its line.
void QualityCard::add_sensors(QVBoxLayout* layout, const solve::QualityReport& report, const Verdict& headline,
                              QWidget* content) {
  QGridLayout* grid = table({tr("Sensor"), tr("usable"), tr("trusted"), tr("at rest")}, content);
  int line = 1;
  for (const solve::SensorQuality& sensor : report.sensors) {
    const Verdict verdict = sensor_verdict(sensor);
    auto* name = new QHBoxLayout;
    name->setSpacing(2);
    name->addWidget(tone_label(verdict.tone, content));
    auto* label = new ElidedLabel(shown_name(sensor.sensor), content);
    label->setToolTip(verdict.text);
    name->addWidget(label, 1);
    grid->addLayout(name, line, 0);
    grid->addWidget(number_label(percent(sensor.usable), content), line, 1);
    grid->addWidget(number_label(percent(sensor.trusted), content), line, 2);
    grid->addWidget(
        number_label(sensor.mean_norm_g > 0.0 ? tr("%1 g").arg(locale().toString(sensor.mean_norm_g, 'f', 3)) : tr("–"),
                     content),
        line, 3);
    ++line;
  }
  layout->addLayout(grid);

  std::vector<Verdict> verdicts;
  for (const solve::SensorQuality& sensor : report.sensors) {
    verdicts.push_back(sensor_verdict(sensor));
  }
  verdicts.push_back(line_verdict(report.line));
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    // Good sensors stand in the table already, and nothing is said twice.
    const bool is_line = i + 1 == verdicts.size();
    if ((is_line || verdicts[i].tone != Tone::kGood) && verdicts[i].text != headline.text) {
      add_verdict(layout, verdicts[i], false, content);
    }
  }
  for (const QString& fact : line_facts(report.line)) {
    QLabel* label = dim_label(fact, content);
    label->setWordWrap(true);
    label->setIndent(kToneIcon + 8);
    layout->addWidget(label);
  }
}

TruthCard::TruthCard(SolveModel& model, QWidget* parent) : Card(tr("Against the truth"), parent), model_(model) {
  connect(&model_, &SolveModel::evaluation_changed, this, &TruthCard::rebuild);
  rebuild();
}

void TruthCard::rebuild() {
  QWidget* content = fresh_content(content_, this);
  auto* layout = static_cast<QVBoxLayout*>(content->layout());
  setVisible(model_.evaluation().has_value());
  if (!model_.evaluation()) {
    return;
  }
  const evaluate::Evaluation& evaluation = *model_.evaluation();
  auto* headline =
      new QLabel(tr("Inclination error %1")
                     .arg(error_text(evaluation.all.inclination_mean_deg, evaluation.all.inclination_max_deg)),
                 content);
  headline->setWordWrap(true);
  layout->addWidget(headline);
  QGridLayout* grid = table({tr("Bone"), tr("mean"), tr("max"), tr("position")}, content);
  int line = 1;
  for (const body::Segment& segment : model_.skeleton().segments) {
    const auto found = evaluation.segments.find(segment.name);
    if (found == evaluation.segments.end()) {
      continue;
    }
    const evaluate::ErrorStatistics& error = found->second;
    grid->addWidget(new ElidedLabel(shown_name(segment.name), content), line, 0);
    grid->addWidget(number_label(tr("%1°").arg(locale().toString(error.inclination_mean_deg, 'f', 2)), content), line,
                    1);
    grid->addWidget(number_label(tr("%1°").arg(locale().toString(error.inclination_max_deg, 'f', 1)), content), line,
                    2);
    grid->addWidget(number_label(tr("%1 mm").arg(locale().toString(error.position_mean_mm, 'f', 0)), content), line, 3);
    ++line;
  }
  layout->addLayout(grid);
}

}  // namespace limbwave::ui
