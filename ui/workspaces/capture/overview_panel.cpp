#include "workspaces/capture/overview_panel.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "common/core_text.h"
#include "common/format.h"
#include "common/theme.h"
#include "solve/live_body_session.h"
#include "take/markers.h"

namespace limbwave::ui {
namespace {

constexpr qsizetype kTroubles = 3;  // that are told beside the picture

}  // namespace

OverviewPanel::OverviewPanel(StudioContext& context, QWidget* parent)
    : QWidget(parent), context_(context), title_(new ElidedLabel({}, this)), view_(new OverviewView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid / 2);
  title_->setProperty("role", "dim");
  layout->addWidget(title_);
  layout->addWidget(view_);
  connect(&context_.document(), &TakeDocument::changed, this, &OverviewPanel::follow_take);
  connect(&context_.live(), &LiveModel::recording_changed, this, &OverviewPanel::follow_recording);
  connect(&context_.live(), &LiveModel::snapshot_changed, this, &OverviewPanel::append_new_samples);
  connect(&context_.live(), &LiveModel::recording_failed, this, [this] { follow_take(true); });
  connect(&context_.document(), &TakeDocument::events_changed, this, &OverviewPanel::show_marks);
  connect(&context_.document(), &TakeDocument::described, this, [this] { follow_take(false); });
  connect(&context_.markers(), &MarkerModel::changed, this, &OverviewPanel::show_marks);
  connect(&context_.selection(), &Selection::changed, this, [this] {
    view_->set_selected_mark(context_.selection().marker());
    view_->set_selected_wire(context_.selection().index_of(SelectionKind::kSensor));
  });
  connect(view_, &OverviewView::wire_clicked, this,
          [this](int wire) { context_.selection().select(SelectionKind::kSensor, wire); });
  connect(view_, &OverviewView::mark_selected, this,
          [this](std::int64_t number) { context_.selection().select_marker(number); });
  connect(view_, &OverviewView::mark_moved, this, &OverviewPanel::move_mark);
  connect(view_, &OverviewView::mark_removed, this, [this](std::int64_t number) { context_.markers().remove(number); });
  connect(view_, &OverviewView::mark_activated, this, &OverviewPanel::rename_wanted);
  connect(view_, &OverviewView::mark_wanted, this, [this](double time_s) {
    if (context_.markers().add(time_s)) {
      Q_EMIT rename_wanted(context_.markers().newest());
    }
  });
  follow_take(true);
}

void OverviewPanel::follow_recording() {
  // The raw samples of a calibration are nobody's take.
  if (context_.live().recording() && context_.live().aside()) {
    return;
  }
  if (context_.live().recording() && !growing_) {
    growing_ = std::make_shared<TakeOverview>();
    next_sample_ = -1.0;
    view_->set_overview(growing_);
    show_marks();
    title_->set_text(tr("What is being recorded"));
    show();
  } else if (!context_.live().recording()) {
    if (growing_ && !growing_->box.empty()) {
      recorded_ = growing_;  // It knows more of the wires than their samples tell at a glance.
      recorded_folder_ = context_.live().recording_folder();
    }
    growing_.reset();  // The view keeps its picture until the take is read.
  }
}

void OverviewPanel::show_marks() {
  std::vector<OverviewMark> marks;
  const auto& take = context_.document().take();
  if (take && !growing_) {
    for (const take::TakeEvent& event : take->events) {
      if (!take::is_marker(event)) {
        const std::string& text = event.text.empty() ? event.kind : event.text;
        marks.push_back({take->info.format.rate.seconds(event.sample).value, core_text(text), true, 0});
      }
    }
  }
  for (const Marker& marker : context_.markers().markers()) {
    marks.push_back({context_.markers().time_s(marker), marker.text, false, marker.number});
  }
  view_->set_marks(std::move(marks));
}

void OverviewPanel::move_mark(std::int64_t number, double time_s) {
  // Keys that follow each other are one step of undo; a drag comes here once.
  if (number != moved_number_ || !moved_.isValid() || moved_.elapsed() > 1000) {
    ++gesture_;
  }
  moved_number_ = number;
  moved_.start();
  context_.markers().move(number, time_s, gesture_);
}

void OverviewPanel::append_new_samples() {
  const auto& snapshot = context_.live().snapshot();
  if (growing_ && snapshot && snapshot->box) {
    append_wires(*snapshot);
    return;
  }
  if (!growing_ || !snapshot || snapshot->scope.size() < 2) {
    return;
  }
  growing_->rate_hz = snapshot->format.rate.hz;
  const auto frames = static_cast<std::int64_t>(snapshot->scope.size() / 2);
  const double end = snapshot->scope_first_sample + static_cast<double>(frames);
  auto fresh = static_cast<std::int64_t>(next_sample_ < 0.0 ? 0.0 : std::max(0.0, end - next_sample_));
  next_sample_ = end;
  // The snapshot holds the newest 100 ms. What a busy window missed stays empty here; the recorder has it.
  if (fresh > frames) {
    const std::vector<float> missed(static_cast<std::size_t>(fresh - frames), std::numeric_limits<float>::quiet_NaN());
    growing_->left.append(missed);
    growing_->right.append(missed);
    growing_->frames += fresh - frames;
    fresh = frames;
  }
  const std::span<const float> samples =
      std::span<const float>(snapshot->scope).last(static_cast<std::size_t>(2 * fresh));
  if (!samples.empty()) {
    growing_->left.append(samples, 2);
    growing_->right.append(samples.subspan(1), 2);
    growing_->frames += fresh;
  }
  view_->grown();
}

void OverviewPanel::append_wires(const solve::LiveSnapshot& snapshot) {
  if (!snapshot.recording) {
    return;
  }
  growing_->rate_hz = snapshot.format.rate.hz;
  growing_->frames = std::llround(snapshot.recorded_s * growing_->rate_hz);
  growing_->box.add(snapshot.recorded_s, snapshot.box->wires,
                    static_cast<double>(snapshot.box->counters.lost_frames) / growing_->rate_hz);
  show_troubles(tr("What is being recorded"), growing_->box);
  view_->grown();
}

void OverviewPanel::show_troubles(const QString& what, const BoxHistory& box) {
  const QStringList troubles = box.troubles();
  const QString words = box.empty()          ? QString()
                        : troubles.isEmpty() ? tr("nothing was lost")
                                             : troubles.mid(0, kTroubles).join(QStringLiteral("; ")) +
                                                   (troubles.size() > kTroubles ? tr(" and more") : QString());
  const QString text = words.isEmpty() ? what : what + QStringLiteral("  ·  ") + words;
  title_->set_text(text);
  title_->setToolTip(troubles.join(QLatin1Char('\n')));
  view_->setAccessibleDescription(words);
}

void OverviewPanel::show_overview(std::shared_ptr<const TakeOverview> overview) {
  shown_ = std::move(overview);
  view_->set_overview(shown_);
  show_facts();
}

void OverviewPanel::show_facts() {
  if (shown_ && !shown_->box.empty()) {
    show_troubles(facts_, shown_->box);
  } else {
    title_->set_text(facts_);
    title_->setToolTip({});
    view_->setAccessibleDescription({});
  }
}

void OverviewPanel::follow_take(bool other) {
  const auto& take = context_.document().take();
  if (growing_) {
    return;  // What is being recorded goes first.
  }
  setVisible(take != nullptr);
  if (!take) {
    facts_.clear();
    show_overview(nullptr);
    return;
  }
  const take::TakeInfo& info = take->info;
  const double seconds = info.format.rate.hz > 0.0 ? static_cast<double>(info.frames) / info.format.rate.hz : 0.0;
  QStringList facts{context_.document().name(), format_clock_tenths(seconds), format_rate(info.format.rate.hz)};
  for (const std::string& text : {info.subject, info.source}) {
    if (!text.empty()) {
      facts.append(QString::fromStdString(text));
    }
  }
  facts_ = facts.join(QStringLiteral("  ·  "));
  show_marks();
  if (!other) {
    show_facts();
    return;
  }
  show_overview(recorded_ && recorded_folder_ == take->folder ? recorded_ : nullptr);
  if (shown_) {
    return;
  }
  if (job_ != nullptr) {
    job_->cancel();
  }
  using Overview = std::shared_ptr<const TakeOverview>;
  Job* job = context_.jobs().compute<Overview>(
      tr("Reading %1").arg(context_.document().name()), this,
      [take](const Progress& progress) { return load_overview(*take, progress); },
      [this, take](Result<Overview> result) {
        if (context_.document().take() == nullptr || context_.document().take()->folder != take->folder) {
          return;
        }
        if (result) {
          show_overview(std::move(result).value());
        } else {
          context_.notifications().post_error(tr("The signal cannot be shown"), result.error());
        }
      });
  job_ = job;
  connect(job, &Job::finished, this, [this, job] {
    if (job_ == job) {
      job_ = nullptr;
    }
  });
}

}  // namespace limbwave::ui
