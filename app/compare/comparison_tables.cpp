#include <fmt/format.h>

#include "app/compare/comparison.hpp"
#include "core/base/atomic_file.hpp"
#include "core/output/csv.hpp"

namespace asperity::app {
namespace {

std::string without_breaks(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '|') c = ' ';
  return text;
}

CsvCell cell(std::string_view word) { return word; }

void write_measures(const Comparison& c, const std::filesystem::path& path) {
  std::vector<std::string> columns{"run", "folder", "differs_by", "aligned"};
  for (const MeasureKind& kind : measure_kinds()) columns.emplace_back(kind.key);
  std::vector<std::vector<CsvCell>> rows;
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    std::vector<CsvCell> row{cell(c.runs[i].letter), cell(c.runs[i].folder.string()), cell(without_breaks(c.labels[i])),
                             cell(c.aligned.frames[i].reached ? "yes" : "no")};
    for (const MeasureKind& kind : measure_kinds()) row.emplace_back(c.patterns[i].measures.*kind.value);
    rows.push_back(std::move(row));
  }
  write_csv(path, columns, rows);
}

void write_orientations(const Comparison& c, const std::filesystem::path& path) {
  std::vector<std::vector<CsvCell>> rows;
  for (std::size_t i = 0; i < c.runs.size(); ++i)
    for (std::size_t bin = 0; bin < kOrientationBins; ++bin) {
      const double from = -90.0 + kOrientationBinDeg * static_cast<double>(bin);
      rows.push_back(
          {cell(c.runs[i].letter), from, from + kOrientationBinDeg, c.patterns[i].measures.orientation[bin]});
    }
  write_csv(path, {"run", "from_deg", "to_deg", "share_of_crack_length"}, rows);
}

}  // namespace

std::string markdown_table(const Comparison& c) {
  std::string head = "| measure | unit |", line = "|---|---|", label = "| differs by | |", folder = "| folder | |";
  for (std::size_t i = 0; i < c.runs.size(); ++i) {
    head += " " + c.runs[i].letter + " |";
    line += "---:|";
    label += " " + without_breaks(c.labels[i]) + " |";
    folder += " " + without_breaks(c.runs[i].name) + " |";
  }
  std::string table = head + "\n" + line + "\n" + folder + "\n" + label + "\n";
  for (const MeasureKind& kind : measure_kinds()) {
    table += fmt::format("| {} | {} |", kind.name, kind.unit);
    for (const MeasuredPattern& pattern : c.patterns) table += " " + measure_text(pattern.measures.*kind.value) + " |";
    table += "\n";
  }
  return table;
}

void write_tables(const Comparison& comparison, const ComparisonFiles& files) {
  write_measures(comparison, files.beside(".csv"));
  write_orientations(comparison, files.beside("_orientation.csv"));
  write_file_atomically(files.beside(".md"), "# " + title_of(comparison) + ", " + comparison.aligned.words + "\n\n" +
                                                 markdown_table(comparison));
}

}  // namespace asperity::app
