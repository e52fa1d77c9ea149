#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/output/csv.hpp"

namespace asperity {
namespace {

constexpr const char* kQuoteHint = "quotes enclose a whole cell, and are doubled inside it";

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

/// Bytes of the UTF-8 character that the text begins with; 0 where it begins with none. RFC 3629.
std::size_t character_bytes(std::string_view text) {
  constexpr char32_t kLeast[] = {0x0, 0x0, 0x80, 0x800, 0x10000};  // a longer form than needed is none
  const auto lead = static_cast<unsigned char>(text.front());
  if (lead < 0x80) return 1;
  const std::size_t bytes = lead < 0xc0 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf8 ? 4 : 0;
  if (bytes == 0 || text.size() < bytes) return 0;
  char32_t code = lead & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xc0U) != 0x80) return 0;
    code = code << 6U | (next & 0x3fU);
  }
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < kLeast[bytes] || code > 0x10ffff || surrogate ? 0 : bytes;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t bytes = character_bytes(text);
    if (bytes == 0) return false;
    text.remove_prefix(bytes);
  }
  return true;
}

/// The begin of a line for a message, bytes that do not print as \xfc.
std::string shown(std::string_view line) {
  constexpr std::size_t kMost = 60;
  std::string text;
  for (const char c : line.substr(0, kMost)) {
    const auto byte = static_cast<unsigned char>(c);
    text += byte >= 0x20 && byte < 0x7f ? std::string(1, c) : fmt::format("\\x{:02x}", byte);
  }
  return line.size() > kMost ? text + "..." : text;
}

/// One quoted cell from the front of the line, which it shortens. Returns what is wrong with it; empty: nothing.
std::string_view take_quoted(std::string_view& line, std::string& cell) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (line[i] != '"') {
      cell += line[i];
    } else if (i + 1 < line.size() && line[i + 1] == '"') {
      cell += line[i++];
    } else {
      line.remove_prefix(i + 1);
      const std::size_t end = std::min(line.find(','), line.size());
      if (!trimmed(line.substr(0, end)).empty()) return "text stands behind a closing quote";
      line.remove_prefix(end);
      return {};
    }
  }
  return "a quote stays open";
}

std::string take_plain(std::string_view& line) {
  const std::size_t end = std::min(line.find(','), line.size());
  std::string cell(trimmed(line.substr(0, end)));
  line.remove_prefix(end);
  return cell;
}

/// Splits a line into its cells. Returns what is wrong with it; empty: nothing.
std::string_view split(std::string_view line, std::vector<std::string>& cells) {
  for (;;) {
    if (line.starts_with('"')) {
      cells.emplace_back();
      if (const std::string_view wrong = take_quoted(line, cells.back()); !wrong.empty()) return wrong;
    } else {
      cells.push_back(take_plain(line));
    }
    if (line.empty()) return {};
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

/// A header row in one piece, with the separator of another table format in it.
void require_commas(const std::filesystem::path& path, std::size_t line, std::string_view header) {
  if (header.find(',') != header.npos) return;
  const std::size_t at = header.find_first_of(";\t");
  if (at == header.npos) return;
  const std::string separator = header[at] == ';' ? "semicolons" : "tabs";
  throw data_error(path, line,
                   {"", "the columns are separated by " + separator, shown(header),
                    "commas between columns, points in decimals", "save it so: 0,05;1,2 becomes 0.05,1.2"});
}

void require_unique(const std::filesystem::path& path, std::size_t line, std::vector<std::string> names) {
  std::sort(names.begin(), names.end());
  const auto twice = std::adjacent_find(names.begin(), names.end());
  if (twice != names.end())
    throw data_error(path, line, {"", "a column is named twice", *twice, "", "give each its own name"});
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
    if (!value)
      throw data_error(path_, lines_[row], {"", std::string(name) + " is no number", cells[row], "a number", ""});
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
    if (!is_utf8(line))
      throw data_error(name, number,
                       {"", "is no UTF-8 text", shown(line), "", "save the file as UTF-8 (\"CSV UTF-8\")"});
    if (data.names_.empty()) require_commas(name, number, line);
    std::vector<std::string> cells;
    const std::string_view wrong = split(line, cells);
    if (!wrong.empty()) throw data_error(name, number, {"", std::string(wrong), std::string(line), "", kQuoteHint});
    data.add_line(number, std::move(cells));
  }
  if (data.names_.empty())
    throw data_error(name, 0, {"", "has no header row", "", "a row with the names of the columns", ""});
  return data;
}

}  // namespace asperity
