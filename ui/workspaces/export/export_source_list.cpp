#include "workspaces/export/export_source_list.h"

#include <QFileInfo>
#include <algorithm>
#include <cmath>
#include <utility>

#include "interchange/animation_file.h"

namespace limbwave::ui {

ExportSourceList::ExportSourceList(StudioContext& context, SolveModel& solves, QObject* parent)
    : QObject(parent), context_(context), solves_(solves) {
  connect(&context_.document(), &TakeDocument::changed, this, &ExportSourceList::follow_document);
  connect(&context_.document(), &TakeDocument::described, this, &ExportSourceList::refresh);
  connect(&solves_, &SolveModel::state_changed, this, &ExportSourceList::refresh);
  connect(&solves_, &SolveModel::solve_changed, this, &ExportSourceList::refresh);
  for (const auto signal : {&SolveModel::pose_changed, &SolveModel::skeleton_changed, &SolveModel::solve_changed}) {
    connect(&solves_, signal, this, &ExportSourceList::edited);
  }
  refresh();
}

const ExportSource* ExportSourceList::source() const {
  return chosen_ < 0 ? nullptr : &offered_[static_cast<std::size_t>(chosen_)];
}

void ExportSourceList::follow_document(bool other) {
  if (other) {
    others_.clear();
    if (context_.document().is_open()) {
      chosen_ = -1;  // The take that was opened comes before animations.
    }
    Q_EMIT replaced();
  }
  refresh();
}

void ExportSourceList::refresh() {
  const std::string before = source() != nullptr ? source()->key() : std::string();
  offered_.clear();
  const auto& take = context_.document().take();
  if (solves_.solve() && take) {
    const std::string current = solves_.settings().name;
    const QString name = context_.document().name();
    offered_.push_back(
        {ExportSource::Kind::kOpenSolve, tr("%1 (open, with your edits)").arg(name), current, take->folder, {}});
    for (const std::string& solve : solves_.names()) {
      if (solve != current) {
        offered_.push_back({ExportSource::Kind::kSolve,
                            tr("%1, solve “%2”").arg(name, QString::fromStdString(solve)),
                            solve,
                            take->folder,
                            {}});
      }
    }
  }
  offered_.insert(offered_.end(), animations_.begin(), animations_.end());
  const auto same =
      std::find_if(offered_.begin(), offered_.end(), [&](const ExportSource& one) { return one.key() == before; });
  const bool kept = same != offered_.end();
  chosen_ = kept ? static_cast<int>(same - offered_.begin()) : (offered_.empty() ? -1 : 0);
  if (!kept) {
    show_extent();
    Q_EMIT replaced();
  }
  Q_EMIT changed();
}

void ExportSourceList::choose(int index) {
  if (index == chosen_ || index < 0 || static_cast<std::size_t>(index) >= offered_.size()) {
    return;
  }
  chosen_ = index;
  show_extent();
  Q_EMIT replaced();
  Q_EMIT changed();
}

void ExportSourceList::set_shown(bool shown) {
  shown_ = shown;
  show_extent();
}

void ExportSourceList::show_extent() {
  const motion::Clip* clip = solves_.solve() ? &solves_.solve()->clip : nullptr;
  if (shown_ && source() != nullptr && source()->clip) {
    clip = source()->clip.get();
  }
  if (clip == nullptr) {
    return;
  }
  TimeModel& time = context_.time();
  const double frame_s = 1.0 / std::max(1.0, clip->frame_rate_hz);
  if (std::abs(time.duration_s() - clip->duration()) >= frame_s || time.frame_s() != frame_s) {
    time.set_extent(clip->duration(), frame_s);
  }
}

void ExportSourceList::add_take(const QString& folder) {
  const std::filesystem::path path = folder.toStdString();
  others_.push_back({ExportSource::Kind::kTake, QFileInfo(folder).completeBaseName(), {}, path, {}});
  Q_EMIT changed();
}

void ExportSourceList::remove_other(int index) {
  if (index >= 0 && static_cast<std::size_t>(index) < others_.size()) {
    others_.erase(others_.begin() + index);
    Q_EMIT changed();
  }
}

void ExportSourceList::open_animation(const QString& file, bool as_actor) {
  using Clips = std::vector<SharedClip>;
  const QString name = QFileInfo(file).fileName();
  context_.jobs().compute<Clips>(
      tr("Reading %1").arg(name), this,
      [path = std::filesystem::path(file.toStdString())](const Progress&) -> Result<Clips> {
        Result<std::vector<motion::Clip>> read = interchange::load_animation(path);
        if (!read) {
          return read.error();
        }
        Clips shared;
        for (motion::Clip& clip : *read) {
          shared.push_back(std::make_shared<const motion::Clip>(std::move(clip)));
        }
        return shared;
      },
      [this, file, name, as_actor](const Result<Clips>& clips) {
        if (clips) {
          take_over(file, *clips, as_actor);
        } else {
          context_.notifications().post_error(tr("%1 cannot be opened").arg(name), clips.error());
        }
      });
}

void ExportSourceList::take_over(const QString& file, const std::vector<SharedClip>& clips, bool as_actor) {
  const QString name = QFileInfo(file).fileName();
  const std::filesystem::path origin = file.toStdString();
  std::vector<ExportSource> read;
  for (const SharedClip& clip : clips) {
    const QString title = clips.size() == 1 ? name
                                            : tr("%1: %2 (%3 of %4)")
                                                  .arg(name, QString::fromStdString(clip->name))
                                                  .arg(read.size() + 1)
                                                  .arg(clips.size());
    read.push_back({ExportSource::Kind::kAnimation, title, {}, origin, clip});
  }
  if (as_actor) {
    others_.push_back(read.front());
    Q_EMIT changed();
    return;
  }
  std::erase_if(animations_, [&](const ExportSource& one) { return one.origin == origin; });
  animations_.insert(animations_.end(), read.begin(), read.end());
  refresh();
  const std::string key = read.front().key();
  const auto found =
      std::find_if(offered_.begin(), offered_.end(), [&](const ExportSource& one) { return one.key() == key; });
  chosen_ = -1;  // Chosen anew, also when the same file was read again.
  choose(static_cast<int>(found - offered_.begin()));
}

std::vector<ClipRequest> ExportSourceList::requests() const {
  std::vector<ClipRequest> all{request(*source())};
  for (const ExportSource& other : others_) {
    all.push_back(request(other));
  }
  return all;
}

ClipRequest ExportSourceList::request(const ExportSource& source) const {
  if (source.kind == ExportSource::Kind::kOpenSolve) {
    return {source.key(), {}, [edited = solves_.edited()]() -> Result<motion::Clip> { return edited().clip; }};
  }
  return {source.key(), source.clip,
          [studio = context_.services(), solving = solves_.services(), folder = source.origin, solve = source.solve] {
            return load_take_clip(studio, solving, folder, solve);
          }};
}

bool ExportSourceList::is_read_from(const std::filesystem::path& file) const {
  const auto same = [&](const ExportSource& one) {
    std::error_code ignored;
    return one.origin == file || std::filesystem::equivalent(one.origin, file, ignored);
  };
  return !file.empty() &&
         ((source() != nullptr && same(*source())) || std::any_of(others_.begin(), others_.end(), same));
}

}  // namespace limbwave::ui
