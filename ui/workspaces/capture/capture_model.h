/// What the Capture workspace knows, apart from its widgets: devices, rig, subject, the next take's name, markers.
#pragma once

#include <QDate>
#include <QObject>
#include <QString>
#include <QStringList>
#include <vector>

#include "acquire/live_source.h"
#include "common/studio_context.h"

namespace limbwave::ui {

struct MarkerRow {
  double time_s = 0.0;
  QString text;
};

class CaptureModel : public QObject {
  Q_OBJECT
 public:
  explicit CaptureModel(StudioContext& context, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<acquire::DeviceInfo>& devices() const { return devices_; }
  [[nodiscard]] bool searching() const { return searching_; }
  [[nodiscard]] const QString& search_problem() const { return search_problem_; }
  [[nodiscard]] QStringList rigs() const;
  [[nodiscard]] const QString& rig() const { return rig_; }
  [[nodiscard]] QString subject() const { return context_.wearer(); }
  /// Name of the next take without ".take"; suggested as long as the user has not typed one.
  [[nodiscard]] const QString& take_name() const { return take_name_; }
  [[nodiscard]] QString take_folder() const;
  /// Why the next take cannot be recorded under this name; empty: it can.
  [[nodiscard]] const QString& take_name_problem() const { return name_problem_; }
  [[nodiscard]] const std::vector<MarkerRow>& markers() const { return markers_; }
  [[nodiscard]] bool can_record() const;
  /// Names of the rig's sensors, of the running capture, else of the chosen rig.
  [[nodiscard]] QStringList sensor_names() const;
  [[nodiscard]] int slot_count() const;

  /// Asks for devices in a job, then opens the one used last time when it is there.
  void refresh_devices();
  /// Empty: closes.
  void open_device(const QString& id);
  void set_rig(const QString& rig);
  void set_subject(const QString& subject);
  void set_take_name(const QString& name);
  /// Another name for the next take, unless the user has typed one: another folder, or this one's name is taken.
  void suggest_name();
  void start_recording();
  void stop_recording();
  void toggle_recording();
  /// "Marker 3" when `text` is empty.
  void mark(const QString& text = {});
  /// For tests: the day that take names use.
  void set_today(const QDate& today);

 Q_SIGNALS:
  void devices_changed();
  void setup_changed();  ///< Rig, subject or take name.
  void markers_changed();

 private:
  void load_rig_names();
  void check_name();
  void show_markers_of_take();

  StudioContext& context_;
  std::vector<acquire::DeviceInfo> devices_;
  bool searching_ = false;
  QString search_problem_, rig_, take_name_;
  bool name_typed_ = false;
  QString name_problem_;  ///< As it was when the name or what is in the folder changed: looking may wait for a network.
  QStringList sensor_names_;
  int slot_count_ = 16;
  std::vector<MarkerRow> markers_;
  QDate today_;
};

}  // namespace limbwave::ui
