/// Tables of numbers and names in CSV: comma, decimal point, a header line (overview.md, "Plain files").
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace limbwave::take {

/// A whole file in memory, its cells found on demand. Plain or gzip.
class CsvTable {
 public:
  static Result<CsvTable> load(const std::filesystem::path& path);
  static Result<CsvTable> parse(std::string text, const std::string& place);

  [[nodiscard]] std::size_t rows() const { return lines_.empty() ? 0 : lines_.size() - 1; }
  [[nodiscard]] std::size_t columns() const;  ///< Of the header.
  /// Column of a name, or -1.
  [[nodiscard]] int column(std::string_view name) const;
  /// Cells of a row, 0-based; a view into the table.
  [[nodiscard]] std::vector<std::string_view> cells(std::size_t row) const;
  /// "FILE:LINE" of a row.
  [[nodiscard]] std::string place(std::size_t row) const;
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string text_, file_;
  std::vector<std::pair<std::size_t, std::size_t>> lines_;  // begin and length; the header first
  std::vector<int> numbers_;                                // of lines in the file
};

/// A number in a cell; NaN when it is empty. False when it is something else.
bool read_number(std::string_view cell, double& value);

}  // namespace limbwave::take
