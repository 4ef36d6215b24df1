#include "take/body_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "take/csv_table.h"

namespace limbwave::take {
namespace fs = std::filesystem;
namespace {

using estimate::BodyModel;
using estimate::BodyReadings;

constexpr double kRate = 1000.0;  // of a log's time base, Hz

Error bad(const CsvTable& table, std::size_t row, const std::string& what) {
  return {what, table.place(row), "correct the line"};
}

Error short_row(const CsvTable& table, std::size_t row) {
  return {"has fewer cells than the header", table.place(row), "complete the line; cells may be empty"};
}

Error no_column(const CsvTable& table, const std::string& name) {
  return {"has no column \"" + name + "\"", table.file(),
          "see \"Plain files for other people's sensors\" in the manual"};
}

// The columns of a table by name, and a row's numbers.
class Columns {
 public:
  Columns(const CsvTable& table, std::initializer_list<const char*> names) {
    for (const char* name : names) {
      columns_.push_back(table.column(name));
      missing_ = columns_.back() < 0 && missing_.empty() ? name : missing_;
    }
  }
  [[nodiscard]] const std::string& missing() const { return missing_; }
  // NaN where a cell is empty or absent. False: not a number.
  [[nodiscard]] bool read(const std::vector<std::string_view>& cells, std::vector<double>& values) const {
    values.assign(columns_.size(), std::nan(""));
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const auto column = static_cast<std::size_t>(columns_[i]);
      if (columns_[i] >= 0 && column < cells.size() &&
          (!read_number(cells[column], values[i]) || (!cells[column].empty() && !std::isfinite(values[i])))) {
        return false;
      }
    }
    return true;
  }

 private:
  std::vector<int> columns_;
  std::string missing_;
};

Status read_inertial(const CsvTable& table, const BodyModel& model, BodyReadings& readings) {
  const Columns columns(table, {"time_s", "wx_rad_s", "wy_rad_s", "wz_rad_s", "ax_m_s2", "ay_m_s2", "az_m_s2"});
  for (const char* chip : {"wx_rad_s,wy_rad_s,wz_rad_s", "ax_m_s2,ay_m_s2,az_m_s2"}) {
    // All three or none.
    std::string absent;
    int there = 0;
    for (std::string_view rest = chip; !rest.empty();) {
      const std::string name(rest.substr(0, rest.find(',')));
      rest.remove_prefix(std::min(rest.size(), name.size() + 1));
      const bool found = table.column(name) >= 0;
      there += found ? 1 : 0;
      absent = found || !absent.empty() ? absent : name;
    }
    if (there > 0 && there < 3) {
      return no_column(table, absent);
    }
  }
  const std::size_t width = table.columns();
  const int sensor = table.column("sensor");
  if (sensor < 0 && model.boards.size() != 1) {
    return Error{"has no column \"sensor\", and the rig has several", table.file(), "say which sensor every row is of"};
  }
  std::vector<double> v;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto cells = table.cells(row);
    if (cells.size() < width) {
      return short_row(table, row);
    }
    if (!columns.read(cells, v) || std::isnan(v[0])) {
      return bad(table, row, "has a cell that is not a number");
    }
    estimate::InertialReading reading;
    reading.time_s = v[0];
    if (sensor >= 0) {
      const std::string name(static_cast<std::size_t>(sensor) < cells.size() ? cells[static_cast<std::size_t>(sensor)]
                                                                             : std::string_view());
      reading.board = model.find_board(name);
      if (reading.board < 0) {
        return Error{"names the sensor \"" + name + "\", which the rig lacks", table.place(row),
                     "name sensors as in the rig"};
      }
    }
    reading.w_S = Eigen::Vector3d(v[1], v[2], v[3]);
    reading.f_S = Eigen::Vector3d(v[4], v[5], v[6]);
    if (!readings.inertial.empty() && reading.time_s < readings.inertial.back().time_s) {
      return bad(table, row, "is earlier than the line before");
    }
    readings.inertial.push_back(reading);
  }
  return {};
}

Status read_ranges(const CsvTable& table, const BodyModel& model, BodyReadings& readings) {
  const Columns columns(table, {"time_s", "range_m", "confidence"});
  for (const char* name : {"source", "receiver"}) {
    if (table.column(name) < 0) {
      return no_column(table, name);
    }
  }
  const std::size_t width = table.columns();
  const auto source = static_cast<std::size_t>(std::max(0, table.column("source")));
  const auto receiver = static_cast<std::size_t>(std::max(0, table.column("receiver")));
  std::vector<double> v;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto cells = table.cells(row);
    if (cells.size() < width) {
      return short_row(table, row);
    }
    if (!columns.read(cells, v) || std::isnan(v[0])) {
      return bad(table, row, "has a cell that is not a number");
    }
    estimate::RangeReading reading;
    reading.time_s = v[0];
    reading.source = model.find_source(std::string(cells[source]));
    reading.board = model.find_board(std::string(cells[receiver]));
    if (reading.source < 0 || reading.board < 0) {
      return Error{"names \"" + std::string(cells[reading.source < 0 ? source : receiver]) + "\", which the rig lacks",
                   table.place(row), "name sources and receivers as in the rig"};
    }
    if (std::isnan(v[1])) {
      continue;  // not heard
    }
    reading.range = v[1];
    reading.confidence = std::isnan(v[2]) ? 1.0 : v[2];
    if (reading.range <= 0.0) {
      return bad(table, row, "has a range that is not positive");
    }
    if (reading.confidence < 0.0 || reading.confidence > 1.0) {
      return bad(table, row, "has a confidence that is not from 0 to 1");
    }
    if (!readings.ranges.empty() && reading.time_s < readings.ranges.back().time_s) {
      return bad(table, row, "is earlier than the line before");
    }
    readings.ranges.push_back(reading);
  }
  return {};
}

Result<std::vector<estimate::RootReading>> read_poses(const CsvTable& table, const std::string& segment) {
  const Columns columns(table, {"time_s", "qw", "qx", "qy", "qz", "px_m", "py_m", "pz_m"});
  if (!columns.missing().empty()) {
    return Error{"has no column \"" + columns.missing() + "\"", table.file(),
                 "a path has time_s,qw,qx,qy,qz,px_m,py_m,pz_m"};
  }
  const int name = table.column("segment");
  std::vector<estimate::RootReading> path;
  std::vector<double> v;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto cells = table.cells(row);
    if (!segment.empty() && name >= 0 &&
        (static_cast<std::size_t>(name) >= cells.size() || cells[static_cast<std::size_t>(name)] != segment)) {
      continue;
    }
    if (!columns.read(cells, v)) {
      return bad(table, row, "has a cell that is not a number");
    }
    if (std::any_of(v.begin(), v.end(), [](double x) { return std::isnan(x); })) {
      continue;
    }
    const Eigen::Quaterniond q(v[1], v[2], v[3], v[4]);
    if (std::abs(q.norm() - 1.0) > 0.01) {
      return bad(table, row, "has a quaternion that is not of length 1");
    }
    if (!path.empty() && v[0] <= path.back().time_s) {
      return bad(table, row, "is not later than the line before");
    }
    path.push_back({v[0], q.normalized(), {v[5], v[6], v[7]}});
  }
  if (path.size() < 2) {
    return Error{"has fewer than two poses", table.file(), "check the columns and the segment's name"};
  }
  return path;
}

}  // namespace

Result<BodyReadings> read_logs(const std::vector<fs::path>& files, const BodyModel& model) {
  BodyReadings readings;
  for (const fs::path& file : files) {
    const Result<CsvTable> table = CsvTable::load(file);
    if (!table) {
      return table.error();
    }
    const bool inertial = table->column("wx_rad_s") >= 0 || table->column("ax_m_s2") >= 0;
    if (!inertial && table->column("range_m") < 0) {
      return Error{"has neither the columns of inertial readings nor those of ranges", file.string(),
                   "see \"Plain files for other people's sensors\" in the manual"};
    }
    if (table->column("time_s") < 0) {
      return Error{"has no column \"time_s\"", file.string(), "say when every row was measured"};
    }
    if (Status status = inertial ? read_inertial(*table, model, readings) : read_ranges(*table, model, readings);
        !status) {
      return status.error();
    }
  }
  if (readings.inertial.empty() && readings.ranges.empty()) {
    return Error{"has no reading", files.empty() ? "" : files.front().string(), "export it again"};
  }
  return readings;
}

Result<std::vector<estimate::RootReading>> read_root(const fs::path& file) {
  return read_root_of_truth(file, "");
}

Result<std::vector<estimate::RootReading>> read_root_of_truth(const fs::path& file, const std::string& segment) {
  const Result<CsvTable> table = CsvTable::load(file);
  if (!table) {
    return table.error();
  }
  return read_poses(*table, segment);
}

Result<BodyReadings> read_logs_of(const Take& take, const BodyModel& model) {
  std::vector<fs::path> files;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(take.folder / "readings", code)) {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return read_logs(files, model);
}

Result<Take> import_logs(const fs::path& folder, const std::vector<fs::path>& files, const body::Rig& rig,
                         const body::Skeleton& skeleton, const std::string& subject) {
  std::error_code code;
  if (fs::exists(folder, code)) {
    return Error{"exists already", folder.string(), "choose another name"};
  }
  const Result<BodyReadings> readings = read_logs(files, estimate::body_model(rig, skeleton));
  if (!readings) {
    return readings.error();
  }
  Take take;
  take.folder = folder;
  take.info.kind = "log";
  take.info.subject = subject;
  take.info.source = files.front().filename().string();
  take.info.format = {SampleRate{kRate}, 1, acquire::SampleType::kInt16};
  take.info.complete = true;
  take.info.rig = rig;
  take.info.skeleton = skeleton;
  const double end = std::max(readings->inertial.empty() ? 0.0 : readings->inertial.back().time_s,
                              readings->ranges.empty() ? 0.0 : readings->ranges.back().time_s);
  take.info.frames = static_cast<std::int64_t>(std::ceil(end * kRate));
  fs::create_directories(folder / "readings", code);
  int number = 0;
  for (const fs::path& file : files) {
    if (!code) {
      fs::copy_file(file, folder / "readings" / (std::to_string(number++) + "-" + file.filename().string()), code);
    }
  }
  Status status =
      code ? Status(Error{"cannot be made (" + code.message() + ")", folder.string(), "check that you may write there"})
           : save_info(take);
  if (!status) {
    fs::remove_all(folder, code);
    return status.error();
  }
  return take;
}

}  // namespace limbwave::take
