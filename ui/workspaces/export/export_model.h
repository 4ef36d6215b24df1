/// The state of the Export workspace: what is exported, how, where to, and how far that is. No widgets.
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <functional>
#include <optional>
#include <vector>

#include "workspaces/export/export_plan.h"
#include "workspaces/export/export_source_list.h"
#include "workspaces/export/export_words.h"

namespace limbwave::ui {

/// Everything that is chosen on the Export page.
struct ExportState {
  ExportSourceState sources;
  ExportChoices choices;
  std::optional<QString> file;  ///< Nothing: the name that is proposed.
  bool operator==(const ExportState&) const = default;
};

class ExportModel : public QObject {
  Q_OBJECT
 public:
  ExportModel(StudioContext& context, SolveModel& solves, QObject* parent = nullptr);

  [[nodiscard]] ExportSourceList& sources() { return sources_; }
  /// Whether there is something to export.
  [[nodiscard]] bool has_source() const { return sources_.source() != nullptr; }

  [[nodiscard]] const std::vector<PresetEntry>& presets() const { return presets_; }
  /// Reads all presets again; those of the user may have been added.
  void read_presets();
  /// What the user changes here, the motion and the other actors included, is one step of undo each (export_edits.h).
  [[nodiscard]] ExportState state() const;
  void put(const ExportState& state);
  /// With the choices of the last time.
  void choose_preset(const std::string& name);
  /// The chosen one; without `preset` if it cannot be read.
  [[nodiscard]] const PresetEntry& preset() const;
  [[nodiscard]] const ExportChoices& choices() const { return choices_; }
  /// Other choices, which are remembered; the file's ending follows the format.
  void change(const ExportChoices& choices);

  [[nodiscard]] const QString& file() const { return file_; }
  void set_file(const QString& file);

  /// Frames a second of the motion that is exported; 0 while it is not known.
  [[nodiscard]] double source_rate_hz() const;
  /// What is proposed for it; 0: its own. Animations of other programs keep theirs.
  [[nodiscard]] double proposed_rate_hz() const;
  /// Of the file, as it is chosen or proposed; 0 while it is not known.
  [[nodiscard]] double file_rate_hz() const;

  /// The range in seconds of the clip; the end is infinite where it is the clip's.
  [[nodiscard]] double begin_s() const;
  [[nodiscard]] double end_s() const;

  /// The motion as it will be written; null until it is made. Made only while `active`.
  [[nodiscard]] const std::shared_ptr<const PreparedExport>& prepared() const { return prepared_; }
  /// Whether `prepared` shows the present choices.
  [[nodiscard]] bool up_to_date() const { return prepared_ != nullptr && !stale_; }
  /// The running preparation, null when none runs.
  [[nodiscard]] Job* preparing() const { return preparing_; }
  /// Why the present choices cannot be prepared.
  [[nodiscard]] const std::optional<Error>& refusal() const { return refusal_; }
  /// Prepares again after it was cancelled.
  void prepare();
  void set_active(bool active);

  /// What is wrong with the choices themselves, so that there is nothing to show; empty: nothing is known.
  [[nodiscard]] QString choice_problem() const;
  /// Why an export would fail; empty: nothing is known.
  [[nodiscard]] QString problem() const;
  [[nodiscard]] QStringList warnings() const;
  void start();
  /// The running export, null when none runs.
  [[nodiscard]] Job* exporting() const { return exporting_; }

 Q_SIGNALS:
  void choices_changed();
  void file_changed();
  void prepared_changed();
  void exporting_changed();
  void exported(const limbwave::Result<limbwave::interchange::ExportReport>& result);

 private:
  struct Work;
  void follow_sources();
  void edit(const std::function<void()>& change);
  void put_choices(const ExportChoices& choices);
  void put_file(const QString& file);
  void forget_prepared();
  /// What was prepared is not what would be written now.
  void touch();
  void suggest_file();
  [[nodiscard]] Work work() const;

  StudioContext& context_;
  SolveModel& solves_;
  ExportSourceList sources_;
  std::vector<PresetEntry> presets_;
  ExportChoices choices_;
  QString file_, suggested_;  ///< The name we put there is replaced as long as it is not another.
  std::shared_ptr<ClipCache> clips_ = std::make_shared<ClipCache>();
  std::shared_ptr<MeshCache> meshes_ = std::make_shared<MeshCache>();
  std::shared_ptr<const PreparedExport> prepared_;
  std::optional<Error> refusal_;
  bool active_ = false, stale_ = true, editing_ = false;
  double read_rate_hz_ = 0.0;  ///< Of a motion that was read to be exported.
  QTimer prepare_soon_;
  QPointer<Job> preparing_, exporting_;
  int attempt_ = 0;  ///< Counts preparations, so that one that was overtaken is dropped.
};

}  // namespace limbwave::ui
