/// What the Capture workspace knows, apart from its widgets: devices, rig, subject, the next take's name.
#pragma once

#include <QDate>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <vector>

#include "acquire/live_source.h"
#include "calibration/cue_sounds.h"
#include "common/studio_context.h"
#include "take/board_book.h"

namespace limbwave::ui {

/// What the user says about the next take; changes can be undone.
struct CaptureSetup {
  QString rig;  ///< Its name, as StudioServices::load_rig takes it.
  QString subject;
  QString take_name;        ///< Without ".take".
  bool name_typed = false;  ///< Else it is suggested.
  QString folder;           ///< For takes.
  bool operator==(const CaptureSetup&) const = default;
};

class CaptureModel : public QObject {
  Q_OBJECT
 public:
  static constexpr int kCountdown_s = 5;

  /// The context's own, made when first asked for.
  static CaptureModel& of(StudioContext& context);
  explicit CaptureModel(StudioContext& context, QObject* parent = nullptr);

  [[nodiscard]] const std::vector<acquire::DeviceInfo>& devices() const { return devices_; }
  [[nodiscard]] bool searching() const { return searching_; }
  [[nodiscard]] const QString& search_problem() const { return search_problem_; }
  /// Those for the kind of device that is open, or was last: sound card or driver box.
  [[nodiscard]] std::vector<RigChoice> rigs() const;
  /// The device that is open, or was to be, is a driver box.
  [[nodiscard]] bool is_box() const;
  [[nodiscard]] const CaptureSetup& setup() const { return setup_; }
  [[nodiscard]] const QString& rig() const { return setup_.rig; }
  [[nodiscard]] const QString& subject() const { return setup_.subject; }
  /// Name of the next take without ".take"; suggested as long as the user has not typed one.
  [[nodiscard]] const QString& take_name() const { return setup_.take_name; }
  [[nodiscard]] QString take_folder() const;
  /// Why the next take cannot be recorded under this name; empty: it can.
  [[nodiscard]] const QString& take_name_problem() const { return name_problem_; }
  [[nodiscard]] bool can_record() const;
  /// Names of the rig's sensors, of the running capture, else of the chosen rig.
  [[nodiscard]] QStringList sensor_names() const;
  [[nodiscard]] int slot_count() const;

  /// Asks for devices in a job, then opens the one used last time when it is there.
  void refresh_devices();
  /// The device that is open, or was to be; null: none, or it is not among the devices any more.
  [[nodiscard]] const acquire::DeviceInfo* device() const;
  /// How that device is opened; kept for each device.
  [[nodiscard]] DeviceSetup device_setup() const;
  /// The board on the open device was read from the user's book, with the rig as its file has it: to be shown. In a
  /// job; ends in `board_ready` unless it cannot be read.
  void read_board();
  /// Another name, serials or places. Can be undone; the capture then goes by it.
  void set_board(const QString& device, const std::string& rig, const take::Board& before, const take::Board& after);
  /// Opens it anew in this way. Refused while recording.
  void set_device_setup(const DeviceSetup& setup);
  /// Empty: closes.
  void open_device(const QString& id);
  /// A driver box at a serial port that is not listed: it is from now on, and is opened.
  void open_box_port(const QString& port);
  void set_rig(const QString& rig);
  void set_subject(const QString& subject);
  void set_take_name(const QString& name);
  /// Where takes go.
  void set_takes_folder(const QString& folder);
  /// Another name for the next take, unless the user has typed one: another folder, or this one's name is taken.
  void suggest_name();
  void start_recording();
  void stop_recording();
  /// Ends a countdown, or a recording; else begins one. A calibration's recording is left alone.
  void toggle_recording();
  /// Begins to record after a countdown, for people who are alone in the suit; it can be heard. A second call ends it.
  void toggle_countdown();
  /// Seconds until recording begins; 0: nothing is counted down.
  [[nodiscard]] int countdown() const { return countdown_; }
  [[nodiscard]] CueSounds& sounds() { return sounds_; }
  /// For tests: the day that take names use.
  void set_today(const QDate& today);

 Q_SIGNALS:
  void devices_changed();
  void setup_changed();  ///< Rig, subject, take name or folder.
  void board_ready(const limbwave::body::Rig& rig, const limbwave::take::Board& board);
  void countdown_changed();

 private:
  friend class SetupCommand;
  friend class FormatCommand;
  friend class BoardCommand;
  enum class Field { kRig, kSubject, kTakeName, kFolder };
  void change(const CaptureSetup& next, Field field, const QString& text);
  bool apply(const CaptureSetup& next);
  [[nodiscard]] QString suggested_name(const QString& subject) const;
  void put_format(const acquire::DeviceInfo& device, const DeviceSetup& setup);
  void put_board(const QString& device, const std::string& rig, const take::Board& board);
  /// Closes the device and opens it again, unless another one is open by now.
  void reopen(const QString& device);
  void load_rig_names();
  /// The rig last used for this kind of device, where the present one is for the other.
  void suit_rig(const QString& device);
  void add_own_ports();
  [[nodiscard]] QString rig_key() const;  ///< Of the settings, for this kind of device.
  void check_name();
  void set_countdown(int seconds);
  void count_down();

  StudioContext& context_;
  std::vector<acquire::DeviceInfo> devices_;
  bool searching_ = false;
  QString search_problem_;
  std::vector<RigChoice> rigs_;
  CaptureSetup setup_;
  QString name_problem_;  ///< As it was when the name or what is in the folder changed: looking may wait for a network.
  QStringList sensor_names_;
  int slot_count_ = 16;
  QString reopen_;  ///< As soon as nothing is recorded any more.
  QDate today_;
  CueSounds sounds_;
  QTimer countdown_timer_;
  int countdown_ = 0;
};

}  // namespace limbwave::ui
