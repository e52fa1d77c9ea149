#pragma once
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/file_descriptor.hpp"

namespace asperity {

/// One cell as text: a number in its shortest form that reads back to the same bits ("nan" where not measured), an
/// integer, or a word (quoted where it holds a comma or a quote; line breaks are not allowed).
class CsvCell {
 public:
  CsvCell(double value);  // NOLINT(google-explicit-constructor): rows are written as {0.1, 3, "shear"}.
  CsvCell(std::integral auto value) : text_(std::to_string(value)) {}  // NOLINT(google-explicit-constructor)
  CsvCell(std::string_view word);                                      // NOLINT(google-explicit-constructor)
  CsvCell(const char* word) : CsvCell(std::string_view(word)) {}       // NOLINT(google-explicit-constructor)
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// A CSV file that grows row by row; its header row names each column with its unit ("time_s,axial_stress_mpa"). Every
/// row reaches the operating system whole, or not at all, before append() returns, so an interrupted run leaves a
/// readable file.
class CsvTable {
 public:
  /// Starts the file anew with its header row, in one step. Throws Error(output).
  static CsvTable create(const std::filesystem::path& path, const std::vector<std::string>& columns);

  /// Opens the file of an interrupted run and cuts it to its first `rows` rows (those of the checkpoint).
  /// Throws Error(output) where the header differs or rows are missing.
  static CsvTable resume(const std::filesystem::path& path, const std::vector<std::string>& columns, std::size_t rows);

  /// Appends one row with as many cells as there are columns. Throws Error(output), e.g. when the disk is full.
  void append(std::span<const CsvCell> cells);
  void append(std::initializer_list<CsvCell> cells) { append(std::span(cells.begin(), cells.size())); }
  void append(std::span<const double> values);

  /// Waits until all rows are on the disk. Throws Error(output).
  void sync() const { file_.sync(); }

  std::size_t rows() const { return rows_; }

 private:
  CsvTable(FileDescriptor file, std::size_t columns, std::size_t rows);
  FileDescriptor file_;
  std::size_t columns_;
  std::size_t rows_;
};

/// Replaces a whole table in one step. Throws Error(output); the old one stays.
void write_csv(const std::filesystem::path& path, const std::vector<std::string>& columns,
               const std::vector<std::vector<CsvCell>>& rows);

/// A CSV file read back. Lines that start with '#' and empty lines are skipped.
class CsvData {
 public:
  const std::vector<std::string>& names() const { return names_; }
  std::size_t rows() const { return lines_.size(); }
  std::size_t line(std::size_t row) const { return lines_[row]; }  ///< In the file, from 1.
  bool has(std::string_view name) const;

  /// The column as numbers; an empty cell is NaN. Throws Error(config) with file:line for a cell that is no number, and
  /// with the columns there are for a name that is not one of them.
  std::vector<double> numbers(std::string_view name) const;

  /// The column as text. Throws Error(config) for an unknown name.
  std::vector<std::string> words(std::string_view name) const;

 private:
  friend CsvData parse_csv(std::string_view bytes, const std::filesystem::path& name);
  void add_line(std::size_t number, std::vector<std::string> cells);
  std::size_t index_of(std::string_view name) const;
  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> columns_;
  std::vector<std::size_t> lines_;  ///< Line of each row in the file, from 1.
};

/// Reads a CSV file with a header row. Throws Error(config) naming file:line for a row of the wrong length, an open
/// quote, text behind a closing quote, text that is not UTF-8, other separators than commas, a column named twice, and
/// where the file is missing or has no header.
CsvData read_csv(const std::filesystem::path& path);

/// The same for bytes that are already there; `name` stands for the file in errors.
CsvData parse_csv(std::string_view bytes, const std::filesystem::path& name);

}  // namespace asperity
