#include "take/board_book.h"

#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "base/files.h"
#include "base/json_reader.h"
#include "take/sensor_places.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kBookLimit = std::size_t{4} << 20;

struct Entry {
  std::string device, rig;
  Board board;
};

Result<std::vector<Entry>> read_book(const fs::path& file) {
  std::vector<Entry> entries;
  std::error_code code;
  if (!fs::exists(file, code)) {
    return entries;
  }
  const Result<std::string> text = read_file(file, kBookLimit);
  if (!text) {
    return text.error();
  }
  const Result<nlohmann::json> json = parse_json(*text, file.string());
  if (!json) {
    return json.error();
  }
  JsonReader::State state{file.string(), {}};
  const JsonReader reader(*json, "", state);
  reader.allow({"schema", "boards"});
  (void)reader.at("schema").integer(1, 1);
  for (const JsonReader& item : reader.at("boards").items()) {
    item.allow({"device", "rig", "name", "serials", "places"});
    Entry entry{item.at("device").string(), item.at("rig").string(), {item.at("name").string(), {}, {}}};
    for (const JsonReader& serial : item.at("serials").items()) {
      entry.board.serials.push_back(serial.string());
    }
    if (item.has("places")) {
      for (const JsonReader& place : item.at("places").items()) {
        entry.board.places.push_back(place.string());
      }
    }
    entries.push_back(std::move(entry));
  }
  if (state.error) {
    return *state.error;
  }
  return entries;
}

}  // namespace

BoardBook::BoardBook() : BoardBook(user_data_folder() / "boards.json") {}
BoardBook::BoardBook(fs::path file) : file_(std::move(file)) {}

Result<Board> BoardBook::board(const std::string& device, const std::string& rig) const {
  const Result<std::vector<Entry>> entries = read_book(file_);
  if (!entries) {
    return entries.error();
  }
  for (const Entry& entry : *entries) {
    if (entry.device == device && entry.rig == rig) {
      return entry.board;
    }
  }
  return Board{};
}

Status BoardBook::set_board(const std::string& device, const std::string& rig, const Board& board) const {
  std::set<std::string> seen;
  bool empty = board.name.empty() && board.places.empty();
  for (const std::string& serial : board.serials) {
    empty = empty && serial.empty();
    if (!serial.empty() && !seen.insert(serial).second) {
      return Error{"is entered for two sensors", "serial \"" + serial + "\"", "give each sensor its own"};
    }
  }
  const Result<std::vector<Entry>> entries = read_book(file_);
  if (!entries) {
    return entries.error();
  }
  nlohmann::json boards = nlohmann::json::array();
  const auto add = [&boards](const Entry& entry) {
    nlohmann::json one{
        {"device", entry.device}, {"rig", entry.rig}, {"name", entry.board.name}, {"serials", entry.board.serials}};
    if (!entry.board.places.empty()) {
      one["places"] = entry.board.places;
    }
    boards.push_back(std::move(one));
  };
  for (const Entry& entry : *entries) {
    if (entry.device != device || entry.rig != rig) {
      add(entry);
    }
  }
  if (!empty) {
    add({device, rig, board});
  }
  std::error_code code;
  fs::create_directories(file_.parent_path(), code);
  if (code) {
    return Error{"cannot be made (" + code.message() + ")", file_.parent_path().string(),
                 "check that you may write there"};
  }
  const nlohmann::json json{{"schema", 1}, {"boards", std::move(boards)}};
  return write_file(file_, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

body::Rig rig_with_board(body::Rig rig, const Board& board) {
  for (std::size_t s = 0; s < rig.accelerometers.size(); ++s) {
    body::Accelerometer& sensor = rig.accelerometers[s];
    if (s < board.serials.size() && !board.serials[s].empty()) {
      sensor.serial = board.serials[s];
    } else if (sensor.serial.empty() && !board.name.empty()) {
      sensor.serial = board.name + ": " + sensor.name;
    }
  }
  if (!board.places.empty()) {
    if (Result<body::Rig> worn = with_places(rig, board.places)) {
      return std::move(worn).value();
    }
  }
  return rig;
}

body::Rig rig_on_device(body::Rig rig, const std::string& device) {
  const Result<Board> board = BoardBook().board(device, rig.name);
  return board ? rig_with_board(std::move(rig), *board) : rig;
}

}  // namespace limbwave::take
