/// Which sensor of a board is worn where. A board's sensors are told apart by their sockets: accelerometer s of a rig
/// is the one in socket s (slots 3s to 3s + 2 of the multiplexed signal, signals.md §1). What a rig says of a place
/// (its name, segment and nominal mounting) can hang on any of them, because cables get mixed up.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "take/take.h"

namespace limbwave::take {

/// Names of the places in the order of the sockets: "torso", "upper arm" ...
std::vector<std::string> places_of(const body::Rig& rig);

/// The rig with the sensor in socket s worn at `places[s]`; calibration groups follow their places. A sensor keeps its
/// key in the calibration library: one without a serial gets the key that it had as its serial. Fails unless `places`
/// names every place of the rig once.
Result<body::Rig> with_places(body::Rig rig, const std::vector<std::string>& places);

/// A take's sensors as they were really worn, told afterwards: `places` and `serials` by socket (an empty serial: the
/// library knows the sensor by its rig and socket). The range of a serial that the take knew moves along with it, that
/// of an unknown one becomes the data sheet's; a first serial for a sensor without one only names it. A mounting that
/// was calibrated in the poses of another group becomes the data sheet's. Fails as `with_places`, and for a serial that
/// two sensors share.
Result<TakeInfo> with_sensors(TakeInfo info, const std::vector<std::string>& places,
                              const std::vector<std::string>& serials);

}  // namespace limbwave::take
