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
    take_first_ = context_.document().is_open();  // It comes before animations.
    if (take_first_) {
      chosen_ = -1;
    }
    Q_EMIT replaced();
  }
  refresh();
}

void ExportSourceList::refresh() {
  offer(source() != nullptr ? source()->key() : std::string());
}

// Lists what there is; `wanted` by its key, or what comes first.
void ExportSourceList::offer(const std::string& wanted) {
  const std::string before = source() != nullptr ? source()->key() : std::string();
  offered_.clear();
  const auto& take = context_.document().take();
  if (solves_.solve() && take) {
    const std::string current = solves_.settings().name;
    const QString name = context_.document().name();
    offered_.push_back({ExportSource::Kind::kOpenSolve, tr("%1, as edited").arg(name), current, take->folder, {}});
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
      std::find_if(offered_.begin(), offered_.end(), [&](const ExportSource& one) { return one.key() == wanted; });
  const bool found = same != offered_.end();
  const bool opened = take_first_ && !offered_.empty() && offered_.front().kind == ExportSource::Kind::kOpenSolve;
  take_first_ = take_first_ && !opened;
  chosen_ = found && !opened ? static_cast<int>(same - offered_.begin()) : (offered_.empty() ? -1 : 0);
  name_animation();
  if (!found || source()->key() != before) {
    show_extent();
    Q_EMIT replaced();
  }
  Q_EMIT changed();
}

void ExportSourceList::choose(int index) {
  if (index == chosen_ || index < 0 || static_cast<std::size_t>(index) >= offered_.size()) {
    return;
  }
  edit_([this, index] { show(index); });
}

void ExportSourceList::show(int index) {
  chosen_ = index;
  take_first_ = false;
  name_animation();
  show_extent();
  Q_EMIT replaced();
  Q_EMIT changed();
}

ExportSourceState ExportSourceList::state() const {
  return {source() != nullptr ? source()->key() : std::string(), animations_, others_};
}

void ExportSourceList::put(const ExportSourceState& state) {
  if (state != this->state()) {
    animations_ = state.animations;
    others_ = state.others;
    offer(state.chosen);
  }
}

// An animation is what the window is about as long as it is looked at, or when no take is open.
void ExportSourceList::name_animation() {
  const bool animation = source() != nullptr && source()->kind == ExportSource::Kind::kAnimation;
  context_.set_animation(animation && (shown_ || !context_.document().is_open())
                             ? QString::fromStdString(source()->origin.filename().string())
                             : QString());
}

void ExportSourceList::set_shown(bool shown) {
  shown_ = shown;
  name_animation();
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
  } else {
    time.correct_duration(clip->duration());
  }
}

void ExportSourceList::add_take(const QString& folder) {
  const std::filesystem::path path = folder.toStdString();
  edit_([&] {
    others_.push_back({ExportSource::Kind::kTake, QFileInfo(folder).completeBaseName(), {}, path, {}});
    Q_EMIT changed();
  });
}

void ExportSourceList::remove_other(int index) {
  if (index >= 0 && static_cast<std::size_t>(index) < others_.size()) {
    edit_([&] {
      others_.erase(others_.begin() + index);
      Q_EMIT changed();
    });
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
    edit_([&] {
      others_.push_back(read.front());
      Q_EMIT changed();
    });
    return;
  }
  edit_([&] {
    std::erase_if(animations_, [&](const ExportSource& one) { return one.origin == origin; });
    animations_.insert(animations_.end(), read.begin(), read.end());
    chosen_ = -1;  // Chosen anew, also when the same file was read again.
    take_first_ = false;
    offer(read.front().key());
  });
}

bool ExportSourceList::close_animations() {
  if (animations_.empty()) {
    return false;
  }
  edit_([&] {
    animations_.clear();
    refresh();
  });
  return true;
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
