#include "workspaces/capture/overview_panel.h"

#include <QVBoxLayout>

#include "common/format.h"
#include "common/theme.h"

namespace limbwave::ui {

OverviewPanel::OverviewPanel(StudioContext& context, QWidget* parent)
    : QWidget(parent), context_(context), title_(new ElidedLabel({}, this)), view_(new OverviewView(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kGrid / 2);
  title_->setProperty("role", "dim");
  layout->addWidget(title_);
  layout->addWidget(view_);
  connect(&context_.document(), &TakeDocument::changed, this, &OverviewPanel::follow_take);
  follow_take(true);
}

void OverviewPanel::follow_take(bool other) {
  const auto& take = context_.document().take();
  setVisible(take != nullptr);
  if (!take) {
    view_->set_overview(nullptr);
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
  title_->set_text(facts.join(QStringLiteral("  ·  ")));
  std::vector<OverviewMark> marks;
  for (const take::TakeEvent& event : take->events) {
    marks.push_back(
        {info.format.rate.seconds(event.sample).value, QString::fromStdString(event.text), event.kind != "marker"});
  }
  view_->set_marks(std::move(marks));
  if (!other) {
    return;
  }
  view_->set_overview(nullptr);
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
          view_->set_overview(std::move(result).value());
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
