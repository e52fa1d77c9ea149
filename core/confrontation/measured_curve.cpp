#include "core/confrontation/measured_curve.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include "core/config/suggest.hpp"
#include "core/confrontation/curve_columns.hpp"
#include "core/measurement/curve_shape.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSpecimen = "specimen";
/// Columns that a laboratory keeps for itself.
constexpr std::string_view kOwn = "note_";
/// The load of a disc as a force; it needs the thickness.
constexpr std::string_view kForceBase = "load";

/// One column of the file that is one of a curve's.
struct Taken {
  const ColumnKind* kind;
  std::string name;
  double factor;
};

std::string known_names(ExperimentType experiment) {
  std::string names(kSpecimen);
  for (const ColumnKind& kind : curve_columns(experiment)) {
    names += ", " + std::string(kind.base) + std::string(unit_suffixes(kind.quantity).front().suffix);
  }
  return names;
}

std::string unknown_hint(const std::string& name, ExperimentType experiment) {
  std::vector<std::string> names{std::string(kSpecimen)};
  for (const ColumnKind& kind : curve_columns(experiment)) {
    for (const UnitSuffix& unit : unit_suffixes(kind.quantity)) {
      names.push_back(std::string(kind.base) + std::string(unit.suffix));
    }
  }
  const std::string near = closest(name, names);
  return near.empty() ? "begin its name with note_ to have it passed over" : "did you mean " + near + "?";
}

std::optional<double> force_factor(const std::string& name, const MeasuredTest& test) {
  if (test.experiment != ExperimentType::brazilian || !test.thickness_mm) return std::nullopt;
  const auto factor = unit_factor(name, kForceBase, Quantity::force);
  return factor ? std::optional(*factor / *test.thickness_mm) : std::nullopt;
}

std::optional<Taken> take(const std::string& name, const MeasuredTest& test) {
  for (const ColumnKind& kind : curve_columns(test.experiment)) {
    auto factor = unit_factor(name, kind.base, kind.quantity);
    if (!factor && kind.base == kForceBase) factor = force_factor(name, test);
    if (factor) return Taken{&kind, name, *factor};
  }
  return std::nullopt;
}

/// The longest column name that the name begins with: what is behind it is meant as its unit.
const ColumnKind* meant_by(const std::string& name, ExperimentType experiment) {
  const ColumnKind* meant = nullptr;
  for (const ColumnKind& kind : curve_columns(experiment)) {
    const bool begins = name == kind.base || name.starts_with(std::string(kind.base) + "_");
    if (begins && (!meant || kind.base.size() > meant->base.size())) meant = &kind;
  }
  return meant;
}

Fault name_fault(const fs::path& file, const std::string& name, const MeasuredTest& test) {
  if (const ColumnKind* kind = meant_by(name, test.experiment)) {
    const bool force = kind->base == kForceBase && unit_factor(name, kForceBase, Quantity::force);
    if (force)
      return {file.string(), "a force needs the disc's thickness", name, names_with_units(kind->base, kind->quantity),
              "give thickness_mm of the test"};
    return {file.string(), "the unit of a column is not known", name, names_with_units(kind->base, kind->quantity),
            "convert it to one of these"};
  }
  return {file.string(), "a column is none of this experiment's", name, known_names(test.experiment),
          unknown_hint(name, test.experiment)};
}

std::vector<Taken> take_columns(const CsvData& table, const fs::path& file, const MeasuredTest& test,
                                std::vector<Fault>& faults) {
  std::vector<Taken> taken;
  for (const std::string& name : table.names()) {
    if (name == kSpecimen || name.starts_with(kOwn)) continue;
    const auto column = take(name, test);
    if (!column) {
      faults.push_back(name_fault(file, name, test));
      continue;
    }
    const auto same = std::find_if(taken.begin(), taken.end(), [&](const Taken& t) { return t.kind == column->kind; });
    if (same != taken.end()) {
      faults.push_back(
          {file.string(), "a column is given twice, in two units", same->name + ", " + name, "one of them", ""});
    } else {
      taken.push_back(*column);
    }
  }
  for (const ColumnKind& kind : curve_columns(test.experiment)) {
    const bool given = std::any_of(taken.begin(), taken.end(), [&](const Taken& t) { return t.kind == &kind; });
    const auto meant = [&](const std::string& name) { return meant_by(name, test.experiment) == &kind; };
    const bool named = std::any_of(table.names().begin(), table.names().end(), meant);
    if (!kind.required || given || named) continue;
    faults.push_back({file.string(), "the column " + std::string(kind.base) + " is missing", "",
                      names_with_units(kind.base, kind.quantity), std::string(kind.what)});
  }
  return taken;
}

/// Reads a column; a cell that is no number is a fault of the table.
std::vector<double> read_column(const CsvData& table, const Taken& column, std::vector<Fault>& faults) {
  try {
    std::vector<double> values = table.numbers(column.name);
    for (double& value : values) value *= column.factor;
    return values;
  } catch (const Error& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return {};
  }
}

using SpecimenRows = std::pair<std::string, std::vector<std::size_t>>;

/// Specimens in the order in which they first appear, with their rows.
std::vector<SpecimenRows> rows_of_specimens(const CsvData& table) {
  std::vector<SpecimenRows> groups;
  std::unordered_map<std::string, std::size_t> places;
  const std::vector<std::string> names =
      table.has(kSpecimen) ? table.words(kSpecimen) : std::vector<std::string>(table.rows(), "1");
  for (std::size_t row = 0; row < names.size(); ++row) {
    const auto [place, fresh] = places.emplace(names[row], groups.size());
    if (fresh) groups.push_back({names[row], {}});
    groups[place->second].second.push_back(row);
  }
  return groups;
}

/// Of several specimens none has rows enough for a curve: `specimen` counts something else.
bool all_too_short(const std::vector<SpecimenRows>& specimens) {
  const auto is_short = [](const SpecimenRows& s) { return s.second.size() < kLeastRows; };
  return specimens.size() > 1 && std::all_of(specimens.begin(), specimens.end(), is_short);
}

Fault short_fault(const fs::path& file, std::size_t specimens, std::size_t rows) {
  return {file.string(), "every specimen has too few rows",
          std::to_string(specimens) + " specimens in " + std::to_string(rows) + " rows",
          std::to_string(kLeastRows) + " rows or more of each",
          "specimen names the replicate a row belongs to; name a counter of rows note_row"};
}

}  // namespace

std::vector<Fault> take_in_curves(const CsvData& table, const fs::path& file, MeasuredTest& test) {
  std::vector<Fault> faults;
  const std::vector<Taken> columns = take_columns(table, file, test, faults);
  if (table.rows() == 0) faults.push_back({file.string(), "has no rows", "", "a row for each reading", ""});
  Curve whole;
  for (const Taken& column : columns) whole.*(column.kind->member) = read_column(table, column, faults);
  if (!faults.empty()) return faults;
  if (test.axial_gauge_mm && whole.gauge_strain.empty()) whole.gauge_strain = whole.path;
  const std::vector<SpecimenRows> specimens = rows_of_specimens(table);
  if (all_too_short(specimens)) return {short_fault(file, specimens.size(), table.rows())};
  for (const auto& [specimen, rows] : specimens) {
    SpecimenCurve curve{specimen, select_rows(whole, rows), {}};
    for (const std::size_t row : rows) curve.lines.push_back(table.line(row));
    test.curves.push_back(std::move(curve));
  }
  test.curve_file = file;
  return faults;
}

}  // namespace asperity
