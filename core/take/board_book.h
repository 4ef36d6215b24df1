/// Which physical sensors hang on which capture device, so that every board's calibrations stay its own.
/// On disk: user_data_folder()/boards.json.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.h"
#include "body/rig.h"

namespace limbwave::take {

/// The board on one device, as people name it.
struct Board {
  std::string name;  ///< "Lab 2"; names every sensor without a serial: "Lab 2: forearm". May be empty.
  std::vector<std::string> serials =
      {};  ///< By socket: accelerometer of the rig; may be empty or shorter than the rig.
  std::vector<std::string> places =
      {};  ///< By socket, where its sensor is worn (sensor_places.h); empty: as the rig says.
  bool operator==(const Board&) const = default;
};

class BoardBook {
 public:
  /// The user's own: user_data_folder()/boards.json.
  BoardBook();
  explicit BoardBook(std::filesystem::path file);

  /// The board of a device ("portaudio:ALSA:pulse") with this rig; an unnamed one when nothing was entered. Fails when
  /// the file cannot be read or is damaged.
  [[nodiscard]] Result<Board> board(const std::string& device, const std::string& rig) const;
  /// Keeps it; an empty board forgets the device. Refuses a serial that two sensors share.
  Status set_board(const std::string& device, const std::string& rig, const Board& board) const;

 private:
  std::filesystem::path file_;
};

/// The rig with the board's serials: the one entered for a sensor, else the rig file's, else "NAME: SENSOR" when the
/// board has a name, else none (then the calibration library knows a sensor by rig and socket alone). Sensors are worn
/// where the board says; places that are not the rig's leave them where the rig has them.
body::Rig rig_with_board(body::Rig rig, const Board& board);

/// `rig_with_board` by the user's own book; the rig as it is when the book cannot be read.
body::Rig rig_on_device(body::Rig rig, const std::string& device);

}  // namespace limbwave::take
