#include "common/take_document.h"

#include <QFileInfo>

namespace limbwave::ui {

TakeDocument::TakeDocument(const StudioServices& services, JobRunner& jobs, QObject* parent)
    : QObject(parent), services_(services), jobs_(jobs) {}

QString TakeDocument::name() const {
  return take_ ? QString::fromStdString(take_->folder.stem().string()) : QString();
}

double TakeDocument::capture_start_s() const {
  return take_ && take_->info.format.rate.hz > 0.0 ? take_->info.format.rate.seconds(take_->info.capture().first).value
                                                   : 0.0;
}

void TakeDocument::open(const QString& folder) {
  if (!services_.open_take) {
    return;
  }
  const std::filesystem::path path(QFileInfo(folder).absoluteFilePath().toStdString());
  const int attempt = ++attempt_;
  jobs_.compute<take::Take>(
      tr("Opening %1").arg(QFileInfo(folder).fileName()), this,
      [open_take = services_.open_take, path](const Progress&) { return open_take(path); },
      [this, folder, attempt](Result<take::Take> result) {
        if (attempt != attempt_) {
          return;  // Another one was asked for meanwhile.
        }
        if (!result) {
          Q_EMIT open_failed(folder, result.error());
          return;
        }
        set(std::move(result).value());
      });
}

void TakeDocument::set(take::Take take) {
  ++attempt_;
  const bool other = !take_ || take_->folder != take.folder;
  opening_ += other ? 1 : 0;
  take_ = std::make_shared<const take::Take>(std::move(take));
  Q_EMIT changed(other);
}

void TakeDocument::set_events(std::vector<take::TakeEvent> events) {
  if (take_) {
    take::Take next = *take_;
    next.events = std::move(events);
    take_ = std::make_shared<const take::Take>(std::move(next));
    Q_EMIT events_changed();
  }
}

void TakeDocument::describe(const std::filesystem::path& folder, const std::string& subject) {
  if (take_) {
    take::Take next = *take_;
    next.folder = folder;
    next.info.subject = subject;
    take_ = std::make_shared<const take::Take>(std::move(next));
    Q_EMIT described();
  }
}

void TakeDocument::close() {
  ++attempt_;
  if (take_) {
    take_.reset();
    Q_EMIT changed(true);
  }
}

}  // namespace limbwave::ui
