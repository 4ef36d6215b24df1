#include "take/csv_table.h"

#include <zlib.h>

#include <array>
#include <charconv>
#include <limits>

namespace limbwave::take {
namespace {

constexpr std::size_t kSizeLimit = std::size_t{2} << 30;

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
    text.remove_prefix(1);
  }
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r')) {
    text.remove_suffix(1);
  }
  return text;
}

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t comma = line.find(',');
    std::string_view cell = trimmed(line.substr(0, comma));
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
      cell = cell.substr(1, cell.size() - 2);
    }
    cells.push_back(cell);
    if (comma == std::string_view::npos) {
      return cells;
    }
    line.remove_prefix(comma + 1);
  }
}

}  // namespace

bool read_number(std::string_view cell, double& value) {
  if (cell.empty()) {
    value = std::numeric_limits<double>::quiet_NaN();
    return true;
  }
  cell.remove_prefix(cell.front() == '+' ? 1 : 0);
  const auto [end, code] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return code == std::errc{} && end == cell.data() + cell.size();
}

Result<CsvTable> CsvTable::load(const std::filesystem::path& path) {
  gzFile file = gzopen(path.c_str(), "rb");
  if (file == nullptr) {
    return Error{"cannot be read", path.string(), "check that it exists and that you may read it"};
  }
  std::string text;
  std::array<char, 1 << 16> block{};
  int got = 0;
  while ((got = gzread(file, block.data(), block.size())) > 0 && text.size() <= kSizeLimit) {
    text.append(block.data(), static_cast<std::size_t>(got));
  }
  const bool whole = gzclose_r(file) == Z_OK && got == 0;
  if (!whole) {
    return Error{text.size() > kSizeLimit ? "is larger than 2 GB" : "is damaged or breaks off", path.string(),
                 "export it again"};
  }
  return parse(std::move(text), path.string());
}

Result<CsvTable> CsvTable::parse(std::string text, const std::string& place) {
  CsvTable table;
  table.text_ = std::move(text);
  table.file_ = place;
  const std::size_t mark = table.text_.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  int number = 0;
  for (std::size_t at = mark; at < table.text_.size();) {
    std::size_t end = table.text_.find('\n', at);
    end = end == std::string::npos ? table.text_.size() : end;
    ++number;
    if (!trimmed(std::string_view(table.text_).substr(at, end - at)).empty()) {
      table.lines_.emplace_back(at, end - at);
      table.numbers_.push_back(number);
    }
    at = end + 1;
  }
  if (table.lines_.empty()) {
    return Error{"is empty", place, "its first line names the columns"};
  }
  return table;
}

std::size_t CsvTable::columns() const {
  return split(std::string_view(text_).substr(lines_.front().first, lines_.front().second)).size();
}

int CsvTable::column(std::string_view name) const {
  const auto header = split(std::string_view(text_).substr(lines_.front().first, lines_.front().second));
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (header[i] == name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

std::vector<std::string_view> CsvTable::cells(std::size_t row) const {
  return split(std::string_view(text_).substr(lines_[row + 1].first, lines_[row + 1].second));
}

std::string CsvTable::place(std::size_t row) const {
  return file_ + ":" + std::to_string(numbers_[row + 1]);
}

}  // namespace limbwave::take
