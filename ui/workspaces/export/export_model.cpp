#include "workspaces/export/export_model.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "common/core_text.h"

namespace limbwave::ui {

namespace {

constexpr int kPrepareAfterMs = 120;  // A spin box that is still moving does not start one at every step.

// What is wrong and what to do. The clip's name as the place says nothing here; a file's does.
QString refusal_text(const Error& error) {
  const QString place = QString::fromStdString(error.place);
  const bool file = place.contains(QLatin1Char('/')) || place.contains(QLatin1Char('.'));
  const QString what =
      file ? QStringLiteral("%1: %2.").arg(place, core_text(error.message)) : core_sentence(error.message);
  return QStringList{what, core_sentence(error.remedy)}.join(QLatin1Char(' ')).trimmed();
}

}  // namespace

/// All that a job needs, so that it touches nothing of the window's.
struct ExportModel::Work {
  std::vector<ClipRequest> requests;
  std::shared_ptr<ClipCache> clips;
  std::shared_ptr<MeshCache> meshes;
  std::filesystem::path mesh;  ///< Empty: no own mesh.
  ExportFormat format;
  interchange::ExportOptions options;
  bool propose_rate = false;

  /// With the frame rate that is proposed for the first clip, where none is chosen.
  [[nodiscard]] interchange::ExportOptions options_for(const std::vector<SharedClip>& loaded) const {
    interchange::ExportOptions made = options;
    if (propose_rate && !loaded.empty()) {
      made.fps = proposed_rate(loaded.front()->frame_rate_hz);
    }
    return made;
  }

  Result<std::vector<SharedMesh>> skin(const std::vector<SharedClip>& loaded, const Progress& progress) const {
    std::vector<SharedMesh> skinned;
    for (const SharedClip& clip : loaded) {
      if (mesh.empty()) {
        break;
      }
      const double done = static_cast<double>(skinned.size()), all = static_cast<double>(loaded.size());
      Result<SharedMesh> one = meshes->get(mesh, *clip, progress.part(done / all, (done + 1.0) / all));
      if (!one) {
        return one.error();
      }
      skinned.push_back(*std::move(one));
    }
    return skinned;
  }
};

ExportModel::ExportModel(StudioContext& context, SolveModel& solves, QObject* parent)
    : QObject(parent), context_(context), solves_(solves), sources_(context, solves), presets_(ui::read_presets()) {
  prepare_soon_.setSingleShot(true);
  prepare_soon_.setInterval(kPrepareAfterMs);
  connect(&prepare_soon_, &QTimer::timeout, this, &ExportModel::prepare);
  connect(&context_.time(), &TimeModel::visible_changed, this, [this] {
    if (choices_.range == ExportRange::kVisible) {
      touch();
      Q_EMIT choices_changed();
    }
  });
  const std::string last = remembered_preset(context_.settings());
  const bool there = std::any_of(presets_.begin(), presets_.end(), [&](const auto& one) { return one.name == last; });
  choices_ = remembered_choices(context_.settings(), there ? last : "plain", QStringLiteral("fbx"));
  follow_sources();
  suggest_file();
}

void ExportModel::follow_sources() {
  sources_.set_editor([this](const std::function<void()>& change) { edit(change); });
  connect(&sources_, &ExportSourceList::replaced, this, [this] {
    if (choices_.range == ExportRange::kPart) {
      choices_.range = ExportRange::kAll;  // It was a part of something else.
      Q_EMIT choices_changed();
    }
    prepared_.reset();
    read_rate_hz_ = 0.0;
    clips_ = std::make_shared<ClipCache>();
    suggested_.clear();
    put_file({});
  });
  connect(&sources_, &ExportSourceList::changed, this, [this] {
    suggest_file();
    touch();
  });
  connect(&sources_, &ExportSourceList::edited, this, [this] {
    clips_ = std::make_shared<ClipCache>();
    touch();
  });
}

void ExportModel::read_presets() {
  presets_ = ui::read_presets();
  const auto same = [&](const PresetEntry& one) { return one.name == choices_.preset; };
  if (std::none_of(presets_.begin(), presets_.end(), same)) {
    choose_preset("plain");
  }
  Q_EMIT choices_changed();
  touch();
}

const PresetEntry& ExportModel::preset() const {
  static const PresetEntry kNone;
  const auto found = std::find_if(presets_.begin(), presets_.end(),
                                  [this](const PresetEntry& one) { return one.name == choices_.preset; });
  return found == presets_.end() ? kNone : *found;
}

double ExportModel::source_rate_hz() const {
  const ExportSource* source = sources_.source();
  if (source == nullptr) {
    return 0.0;
  }
  if (source->clip) {
    return source->clip->frame_rate_hz;
  }
  return source->kind == ExportSource::Kind::kOpenSolve && solves_.solve() ? solves_.solve()->clip.frame_rate_hz
                                                                           : read_rate_hz_;
}

double ExportModel::proposed_rate_hz() const {
  const ExportSource* source = sources_.source();
  return source == nullptr || source->kind == ExportSource::Kind::kAnimation ? 0.0 : proposed_rate(source_rate_hz());
}

double ExportModel::file_rate_hz() const {
  const double rate = choices_.fps.value_or(proposed_rate_hz());
  return rate > 0.0 ? rate : source_rate_hz();
}

double ExportModel::begin_s() const {
  switch (choices_.range) {
    case ExportRange::kVisible:
      return context_.time().visible_begin_s();
    case ExportRange::kPart:
      return choices_.begin_s;
    case ExportRange::kAll:
      break;
  }
  return 0.0;
}

double ExportModel::end_s() const {
  switch (choices_.range) {
    case ExportRange::kVisible:
      return context_.time().visible_end_s();
    case ExportRange::kPart:
      return choices_.end_s;
    case ExportRange::kAll:
      break;
  }
  return std::numeric_limits<double>::infinity();
}

ExportModel::Work ExportModel::work() const {
  Work made{sources_.requests(),
            clips_,
            meshes_,
            {},
            export_format(choices_.format),
            export_options(choices_, *preset().preset, begin_s(), end_s()),
            !choices_.fps && sources_.source()->kind != ExportSource::Kind::kAnimation};
  if (choices_.body == ExportBody::kOwnMesh && made.format.has_frames) {
    made.mesh = choices_.mesh;
  }
  return made;
}

void ExportModel::touch() {
  stale_ = true;
  refusal_.reset();
  if (preparing_) {
    ++attempt_;  // What is being made is of other choices already.
    preparing_->cancel();
    preparing_.clear();
    Q_EMIT prepared_changed();
  }
  if (!has_source()) {
    forget_prepared();
  } else if (active_) {
    prepare_soon_.start();
  }
}

// What was made of other choices is no picture of these.
void ExportModel::forget_prepared() {
  prepared_.reset();
  Q_EMIT prepared_changed();
}

void ExportModel::prepare() {
  if (preparing_) {
    preparing_->cancel();
  }
  prepare_soon_.stop();
  const int attempt = ++attempt_;
  refusal_.reset();
  if (!has_source() || !choice_problem().isEmpty()) {
    forget_prepared();
    return;
  }
  using Shared = std::shared_ptr<const PreparedExport>;
  preparing_ = context_.jobs().compute<Shared>(
      tr("Preparing the preview"), this,
      [work = work()](const Progress& progress) -> Result<Shared> {
        const Result<std::vector<SharedClip>> clips = load_clips(work.requests, *work.clips, progress.part(0.0, 0.1));
        if (!clips) {
          return clips.error();
        }
        const Result<std::vector<SharedMesh>> meshes = work.skin(*clips, progress.part(0.1, 0.8));
        if (!meshes) {
          return meshes.error();
        }
        Result<PreparedExport> made =
            prepare_export(*clips, work.format.format, work.options_for(*clips), *meshes, progress.part(0.8, 1.0));
        return made ? Result<Shared>(std::make_shared<const PreparedExport>(*std::move(made)))
                    : Result<Shared>(made.error());
      },
      [this, attempt](const Result<Shared>& made) {
        if (attempt != attempt_) {
          return;
        }
        preparing_.clear();
        stale_ = !made;
        if (made) {
          prepared_ = *made;
          const bool other = read_rate_hz_ != prepared_->source_rate_hz;
          read_rate_hz_ = prepared_->source_rate_hz;
          Q_EMIT prepared_changed();
          if (other) {
            Q_EMIT choices_changed();  // Only now it is known what is proposed.
          }
        } else {
          refusal_ = made.error();
          forget_prepared();
        }
      });
  Q_EMIT prepared_changed();
}

void ExportModel::set_active(bool active) {
  active_ = active;
  sources_.set_shown(active);
  if (active_ && stale_ && has_source()) {
    prepare();
  }
}

QString ExportModel::choice_problem() const {
  const ExportFormat format = export_format(choices_.format);
  if (preset().error) {
    return core_sentence(preset().error->text());
  }
  if (!format.has_frames && !sources_.others().empty()) {
    return tr("A file of this format holds one actor. Choose FBX or glTF, or remove the others.");
  }
  if (choices_.body == ExportBody::kOwnMesh && format.has_frames && choices_.mesh.empty()) {
    return tr("Choose the mesh that is to be skinned.");
  }
  if (choices_.range == ExportRange::kPart && choices_.begin_s >= choices_.end_s) {
    return tr("The part ends before it begins.");
  }
  return {};
}

QString ExportModel::problem() const {
  if (QString wrong = choice_problem(); !wrong.isEmpty()) {
    return wrong;
  }
  if (refusal_ && !is_cancelled(*refusal_)) {
    return refusal_text(*refusal_);
  }
  const ExportFormat format = export_format(choices_.format);
  const std::filesystem::path file = file_.trimmed().toStdString();
  if (sources_.is_read_from(file)) {
    return tr("This is the file that is being exported. Choose another name.");
  }
  return export_file_problem(file, format.extension);
}

QStringList ExportModel::warnings() const {
  if (!preset().preset) {
    return {};
  }
  MotionFacts facts;
  facts.rate_hz = source_rate_hz();
  if (prepared_) {
    facts.person = prepared_->person;
  }
  return export_warnings(choices_, *preset().preset, facts);
}

void ExportModel::start() {
  if (exporting_ || !has_source() || !problem().isEmpty()) {
    return;
  }
  using interchange::ExportReport;
  const std::filesystem::path file = file_.trimmed().toStdString();
  exporting_ = context_.jobs().compute<ExportReport>(
      tr("Exporting %1").arg(QString::fromStdString(file.filename().string())), this,
      [work = work(), file, write = solves_.services().export_file](const Progress& progress) -> Result<ExportReport> {
        Result<std::vector<SharedClip>> clips = load_clips(work.requests, *work.clips, progress.part(0.0, 0.05));
        if (!clips) {
          return clips.error();
        }
        const Result<std::vector<SharedMesh>> meshes = work.skin(*clips, progress.part(0.05, 0.2));
        if (!meshes) {
          return meshes.error();
        }
        for (std::size_t i = 0; i < meshes->size(); ++i) {
          auto with_mesh = std::make_shared<motion::Clip>(*(*clips)[i]);
          with_mesh->meshes = {(*meshes)[i]};
          (*clips)[i] = std::move(with_mesh);
        }
        std::vector<const motion::Clip*> pointers;
        for (const SharedClip& clip : *clips) {
          pointers.push_back(clip.get());
        }
        return write(pointers, file, work.options_for(*clips), progress.part(0.2, 1.0));
      },
      [this](const Result<ExportReport>& result) {
        exporting_.clear();
        Q_EMIT exporting_changed();
        Q_EMIT exported(result);
      });
  Q_EMIT exporting_changed();
}

}  // namespace limbwave::ui
