#include "workspaces/capture/board_dialog.h"

#include <QLineEdit>
#include <QPushButton>
#include <algorithm>

#include "take/sensor_places.h"
#include "workspaces/sensor_table.h"

namespace limbwave::ui {
namespace {

/// Where the sensors are worn, as entered; the rig's own places where that is not of this rig.
std::vector<std::string> places_on(const body::Rig& rig, const take::Board& board) {
  std::vector<std::string> own = take::places_of(rig);
  const bool fits = std::is_permutation(own.begin(), own.end(), board.places.begin(), board.places.end());
  return fits ? board.places : own;
}

}  // namespace

BoardDialog::BoardDialog(const QString& device_title, const body::Rig& rig, const take::Board& board, QWidget* parent)
    : FormSheet(
          tr("Sensor board"),
          tr("Calibrations are kept per sensor. Name the board on %1, so that another board's are never taken for "
             "its own. Where the sensors carry serials, enter them: they then keep their calibration on any board.")
              .arg(device_title),
          tr("Keep"), parent),
      own_places_(take::places_of(rig)) {
  setObjectName(QStringLiteral("board_dialog"));
  name_ = add_line(tr("Board"), QStringLiteral("board_name"), QString::fromStdString(board.name),
                   tr("As written on it, such as “Lab 2”"));
  name_->setMaxLength(60);
  std::vector<std::string> hints;
  for (const body::Accelerometer& sensor : rig.accelerometers) {
    hints.push_back(sensor.serial);
  }
  sensors_ = new SensorTable(places_on(rig, board), board.serials, hints, this);
  add_wide(sensors_);
  verb()->setObjectName(QStringLiteral("keep_board"));
  connect(sensors_, &SensorTable::changed, this, [this] { set_problem(sensors_->problem()); });
}

take::Board BoardDialog::board() const {
  take::Board board;
  board.name = name_->text().trimmed().toStdString();
  board.serials = sensors_->serials();
  if (std::all_of(board.serials.begin(), board.serials.end(),
                  [](const std::string& serial) { return serial.empty(); })) {
    board.serials.clear();
  }
  board.places = sensors_->places() == own_places_ ? std::vector<std::string>() : sensors_->places();
  return board;
}

}  // namespace limbwave::ui
