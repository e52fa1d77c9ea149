#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/output/csv.hpp"

namespace asperity {
namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// Spreadsheets put one before UTF-8 text.
std::string_view without_byte_order_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

/// One cell from the front of the line, which it shortens; nothing if a quote stays open.
std::optional<std::string> take_quoted(std::string_view& line) {
  std::string cell;
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] != '"') {
      cell += line[i];
    } else if (i + 1 < line.size() && line[i + 1] == '"') {
      cell += line[i++];
    } else {
      line.remove_prefix(i + 1);
      line = line.substr(std::min(line.find(','), line.size()));
      return cell;
    }
  }
  return std::nullopt;
}

std::string take_plain(std::string_view& line) {
  const std::size_t end = std::min(line.find(','), line.size());
  std::string cell(trimmed(line.substr(0, end)));
  line.remove_prefix(end);
  return cell;
}

std::optional<std::vector<std::string>> split(std::string_view line) {
  std::vector<std::string> cells;
  for (;;) {
    if (line.starts_with('"')) {
      std::optional<std::string> cell = take_quoted(line);
      if (!cell) return std::nullopt;
      cells.push_back(*std::move(cell));
    } else {
      cells.push_back(take_plain(line));
    }
    if (line.empty()) return cells;
    line.remove_prefix(1);
  }
}

std::optional<double> to_number(std::string_view text) {
  if (text.empty()) return std::numeric_limits<double>::quiet_NaN();
  if (text.front() == '+') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string comma_list(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

Error data_error(const std::filesystem::path& path, std::size_t line, Fault fault) {
  fault.where = path.string() + (line > 0 ? ":" + std::to_string(line) : "");
  return {ErrorKind::config, {std::move(fault)}};
}

std::string read_data_file(const std::filesystem::path& path) {
  try {
    return read_file(path);
  } catch (const Error& failure) {
    // Data that the user named and we cannot read are wrong input, not a failed output.
    throw Error(ErrorKind::config, failure.faults());
  }
}

void require_unique(const std::filesystem::path& path, std::size_t line, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end()) throw data_error(path, line, {"", "a column is named twice", *twice, "", ""});
}

}  // namespace

bool CsvData::has(std::string_view name) const { return std::find(names_.begin(), names_.end(), name) != names_.end(); }

std::size_t CsvData::index_of(std::string_view name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    throw data_error(path_, 0, {"", "no column \"" + std::string(name) + "\"", "", comma_list(names_), ""});
  }
  return static_cast<std::size_t>(found - names_.begin());
}

std::vector<std::string> CsvData::words(std::string_view name) const { return columns_[index_of(name)]; }

std::vector<double> CsvData::numbers(std::string_view name) const {
  const std::vector<std::string>& cells = columns_[index_of(name)];
  std::vector<double> values(cells.size());
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const std::optional<double> value = to_number(cells[row]);
    if (!value) throw data_error(path_, lines_[row], {"", std::string(name) + " is no number", cells[row], "a number", ""});
    values[row] = *value;
  }
  return values;
}

void CsvData::add_line(std::size_t number, std::vector<std::string> cells) {
  if (names_.empty()) {
    require_unique(path_, number, cells);
    names_ = std::move(cells);
    columns_.resize(names_.size());
    return;
  }
  if (cells.size() != names_.size()) {
    throw data_error(path_, number,
                     {"", "wrong number of cells", std::to_string(cells.size()),
                      std::to_string(names_.size()) + ": " + comma_list(names_), ""});
  }
  for (std::size_t i = 0; i < cells.size(); ++i) columns_[i].push_back(std::move(cells[i]));
  lines_.push_back(number);
}

CsvData read_csv(const std::filesystem::path& path) { return parse_csv(read_data_file(path), path); }

CsvData parse_csv(std::string_view bytes, const std::filesystem::path& name) {
  CsvData data;
  data.path_ = name;
  std::size_t number = 0;
  for (std::string_view rest = without_byte_order_mark(bytes); !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trimmed(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    ++number;
    if (line.empty() || line.front() == '#') continue;
    std::optional<std::vector<std::string>> cells = split(line);
    if (!cells) throw data_error(name, number, {"", "a quote stays open", std::string(line), "", ""});
    data.add_line(number, *std::move(cells));
  }
  if (data.names_.empty()) throw data_error(name, 0, {"", "has no header row", "", "a row with the names of the columns", ""});
  return data;
}

}  // namespace asperity
