#include "core/output/csv.hpp"

#include <array>
#include <cassert>
#include <charconv>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"

namespace asperity {
namespace {

std::string quoted(std::string_view word) {
  std::string text = "\"";
  for (const char c : word) text += c == '"' ? std::string("\"\"") : std::string(1, c);
  return text + '"';
}

std::string joined(std::span<const CsvCell> cells) {
  std::string line;
  for (const CsvCell& cell : cells) line += (&cell == cells.data() ? "" : ",") + cell.text();
  return line + '\n';
}

std::string header_line(const std::vector<std::string>& columns) {
  return joined(std::vector<CsvCell>(columns.begin(), columns.end()));
}

/// Bytes up to the end of the given number of whole lines; npos if the text has fewer.
std::size_t end_of_lines(std::string_view text, std::size_t lines) {
  std::size_t end = 0;
  for (; lines > 0; --lines) {
    const std::size_t newline = text.find('\n', end);
    if (newline == std::string_view::npos) return newline;
    end = newline + 1;
  }
  return end;
}

Error cannot_resume(const std::filesystem::path& path, const std::string& what, const std::string& allowed) {
  return Error(ErrorKind::output,
               {{path.string(), "cannot be continued: " + what, "", allowed, "run the config again with --force"}});
}

}  // namespace

CsvCell::CsvCell(double value) {
  std::array<char, 32> buffer;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  assert(error == std::errc());
  text_.assign(buffer.data(), end);
}

CsvCell::CsvCell(std::string_view word) {
  assert(word.find_first_of("\r\n") == std::string_view::npos);
  text_ = word.find_first_of(",\"") == std::string_view::npos ? std::string(word) : quoted(word);
}

CsvTable::CsvTable(FileDescriptor file, std::size_t columns, std::size_t rows)
    : file_(std::move(file)), columns_(columns), rows_(rows) {}

CsvTable CsvTable::create(const std::filesystem::path& path, const std::vector<std::string>& columns) {
  write_file_atomically(path, header_line(columns));
  return {FileDescriptor(path, O_WRONLY | O_APPEND), columns.size(), 0};
}

CsvTable CsvTable::resume(const std::filesystem::path& path, const std::vector<std::string>& columns,
                          std::size_t rows) {
  const std::string text = read_file(path);
  const std::string header = header_line(columns);
  if (!text.starts_with(header))
    throw cannot_resume(path, "its columns are others", header.substr(0, header.size() - 1));
  const std::size_t end = end_of_lines(text, rows + 1);
  if (end == std::string::npos) throw cannot_resume(path, "rows are missing", std::to_string(rows) + " rows or more");
  FileDescriptor file(path, O_WRONLY | O_APPEND);
  file.cut_to(static_cast<off_t>(end));
  return {std::move(file), columns.size(), rows};
}

void CsvTable::append(std::span<const CsvCell> cells) {
  assert(cells.size() == columns_);
  file_.append_all(joined(cells));
  ++rows_;
}

void CsvTable::append(std::span<const double> values) {
  append(std::span<const CsvCell>(std::vector<CsvCell>(values.begin(), values.end())));
}

void write_csv(const std::filesystem::path& path, const std::vector<std::string>& columns,
               const std::vector<std::vector<CsvCell>>& rows) {
  std::string text = header_line(columns);
  for (const std::vector<CsvCell>& row : rows) text += joined(row);
  write_file_atomically(path, text);
}

}  // namespace asperity
