#include "core/output/run_tables.hpp"

#include <fmt/format.h>

#include "core/measurement/acoustic.hpp"
#include "core/measurement/crack_network.hpp"
#include "core/measurement/fragment_sizes.hpp"
#include "core/measurement/sample.hpp"

namespace asperity {
namespace {

/// One column with the way to its value, so that names and values cannot get out of step.
template <class Row>
struct Column {
  const char* name;
  CsvCell (*cell)(const Row&);
};

const char* word_of(BreakMode mode) {
  switch (mode) {
    case BreakMode::tension:
      return "tension";
    case BreakMode::shear:
      return "shear";
    case BreakMode::none:
      break;
  }
  return "none";
}

const std::vector<Column<Sample>>& curve_table() {
  static const std::vector<Column<Sample>> table{
      {"time_s", [](const Sample& s) -> CsvCell { return s.time_s; }},
      {"platen_displacement_mm", [](const Sample& s) -> CsvCell { return s.closure_mm; }},
      {"axial_strain", [](const Sample& s) -> CsvCell { return s.axial_strain; }},
      {"gauge_axial_strain", [](const Sample& s) -> CsvCell { return s.gauge_axial_strain; }},
      {"lateral_strain", [](const Sample& s) -> CsvCell { return s.lateral_strain; }},
      {"axial_stress_mpa", [](const Sample& s) -> CsvCell { return s.stress_mpa; }},
      {"load_n_per_mm", [](const Sample& s) -> CsvCell { return s.load_n_per_mm; }},
      {"reaction_bottom_n", [](const Sample& s) -> CsvCell { return s.reaction_bottom_n; }},
      {"reaction_top_n", [](const Sample& s) -> CsvCell { return s.reaction_top_n; }},
      {"confining_pressure_mpa", [](const Sample& s) -> CsvCell { return s.confining_pressure_mpa; }},
      {"cracks_tension", [](const Sample& s) -> CsvCell { return s.cracks_tension; }},
      {"cracks_shear", [](const Sample& s) -> CsvCell { return s.cracks_shear; }},
      {"contacts_softening", [](const Sample& s) -> CsvCell { return s.contacts_softening; }},
  };
  return table;
}

const std::vector<Column<Sample>>& joint_curve_table() {
  static const std::vector<Column<Sample>> table{
      {"time_s", [](const Sample& s) -> CsvCell { return s.time_s; }},
      {"shear_displacement_mm", [](const Sample& s) -> CsvCell { return s.closure_mm; }},
      {"shear_stress_mpa", [](const Sample& s) -> CsvCell { return s.stress_mpa; }},
      {"normal_stress_mpa", [](const Sample& s) -> CsvCell { return s.joint.normal_stress_mpa; }},
      {"dilation_mm", [](const Sample& s) -> CsvCell { return s.joint.dilation.mean; }},
      {"dilation_front_mm", [](const Sample& s) -> CsvCell { return s.joint.dilation.front; }},
      {"dilation_rear_mm", [](const Sample& s) -> CsvCell { return s.joint.dilation.rear; }},
      {"reaction_lower_n", [](const Sample& s) -> CsvCell { return s.reaction_bottom_n; }},
      {"reaction_upper_n", [](const Sample& s) -> CsvCell { return s.reaction_top_n; }},
      {"cracks_tension", [](const Sample& s) -> CsvCell { return s.cracks_tension; }},
      {"cracks_shear", [](const Sample& s) -> CsvCell { return s.cracks_shear; }},
      {"contacts_softening", [](const Sample& s) -> CsvCell { return s.contacts_softening; }},
  };
  return table;
}

const std::vector<Column<ToothReading>>& tooth_table() {
  static const std::vector<Column<ToothReading>> table{
      {"leading_x_n_per_mm", [](const ToothReading& t) -> CsvCell { return t.leading.x; }},
      {"leading_y_n_per_mm", [](const ToothReading& t) -> CsvCell { return t.leading.y; }},
      {"trailing_x_n_per_mm", [](const ToothReading& t) -> CsvCell { return t.trailing.x; }},
      {"trailing_y_n_per_mm", [](const ToothReading& t) -> CsvCell { return t.trailing.y; }},
      {"attached_share", [](const ToothReading& t) -> CsvCell { return t.attached_share; }},
      {"cracks", [](const ToothReading& t) -> CsvCell { return t.cracks; }},
  };
  return table;
}

const std::vector<Column<Sample>>& energy_table() {
  static const std::vector<Column<Sample>> table{
      {"external_work_n_mm", [](const Sample& s) -> CsvCell { return s.energy.external_work; }},
      {"elastic_n_mm", [](const Sample& s) -> CsvCell { return s.energy.elastic; }},
      {"recoverable_n_mm", [](const Sample& s) -> CsvCell { return s.energy.recoverable; }},
      {"fracture_n_mm", [](const Sample& s) -> CsvCell { return s.energy.fracture; }},
      {"friction_n_mm", [](const Sample& s) -> CsvCell { return s.energy.friction; }},
      {"damping_n_mm", [](const Sample& s) -> CsvCell { return s.energy.damping; }},
      {"kinetic_n_mm", [](const Sample& s) -> CsvCell { return s.energy.kinetic; }},
      {"plasticity_n_mm", [](const Sample& s) -> CsvCell { return s.energy.plasticity; }},
      {"created_by_law_n_mm", [](const Sample& s) -> CsvCell { return s.energy.created_by_law; }},
      {"closure_error_n_mm", [](const Sample& s) -> CsvCell { return s.energy.error(); }},
  };
  return table;
}

const std::vector<Column<Crack>>& crack_table() {
  static const std::vector<Column<Crack>> table{
      {"contact", [](const Crack& c) -> CsvCell { return c.contact; }},
      {"mode", [](const Crack& c) -> CsvCell { return word_of(c.mode); }},
      {"time_s", [](const Crack& c) -> CsvCell { return c.time_s; }},
      {"x_mm", [](const Crack& c) -> CsvCell { return c.place.x; }},
      {"y_mm", [](const Crack& c) -> CsvCell { return c.place.y; }},
      {"orientation_deg", [](const Crack& c) -> CsvCell { return c.orientation_deg; }},
      {"length_mm", [](const Crack& c) -> CsvCell { return c.length_mm; }},
      {"energy_n_mm", [](const Crack& c) -> CsvCell { return c.energy_n_mm; }},
  };
  return table;
}

const std::vector<Column<AcousticEvent>>& event_table() {
  static const std::vector<Column<AcousticEvent>> table{
      {"time_s", [](const AcousticEvent& e) -> CsvCell { return e.time_s; }},
      {"duration_s", [](const AcousticEvent& e) -> CsvCell { return e.duration_s; }},
      {"x_mm", [](const AcousticEvent& e) -> CsvCell { return e.place.x; }},
      {"y_mm", [](const AcousticEvent& e) -> CsvCell { return e.place.y; }},
      {"cracks", [](const AcousticEvent& e) -> CsvCell { return e.cracks; }},
      {"tension", [](const AcousticEvent& e) -> CsvCell { return e.tension; }},
      {"shear", [](const AcousticEvent& e) -> CsvCell { return e.shear; }},
      {"energy_n_mm", [](const AcousticEvent& e) -> CsvCell { return e.energy_n_mm; }},
  };
  return table;
}

template <class Row>
std::vector<std::string> names_of(const std::vector<Column<Row>>& table) {
  std::vector<std::string> names;
  names.reserve(table.size());
  for (const Column<Row>& column : table) names.emplace_back(column.name);
  return names;
}

template <class Row>
std::vector<CsvCell> cells_of(const std::vector<Column<Row>>& table, const Row& row) {
  std::vector<CsvCell> cells;
  cells.reserve(table.size());
  for (const Column<Row>& column : table) cells.push_back(column.cell(row));
  return cells;
}

/// energy.csv begins with the curve's time and strain; curves.csv ends with the energies.
template <class Item>
std::vector<Item> joined(std::vector<Item> first, const std::vector<Item>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

}  // namespace

std::vector<std::string> curve_columns(const CurveLayout& layout) {
  std::vector<std::string> names = names_of(layout.joint ? joint_curve_table() : curve_table());
  for (std::size_t i = 0; i < layout.teeth; ++i) {
    for (const std::string& name : names_of(tooth_table())) names.push_back(fmt::format("tooth{}_{}", i + 1, name));
  }
  return joined(std::move(names), names_of(energy_table()));
}

std::vector<std::string> energy_columns(const CurveLayout& layout) {
  return joined({"time_s", layout.joint ? "shear_displacement_mm" : "axial_strain"}, names_of(energy_table()));
}

std::vector<std::string> crack_columns() { return names_of(crack_table()); }

std::vector<std::string> event_columns() { return names_of(event_table()); }

std::vector<std::string> fragment_columns() { return {"fragment", "area_mm2", "size_mm"}; }

std::vector<CsvCell> curve_row(const Sample& sample, const CurveLayout& layout) {
  std::vector<CsvCell> cells = cells_of(layout.joint ? joint_curve_table() : curve_table(), sample);
  for (std::size_t i = 0; i < layout.teeth; ++i) {
    cells = joined(std::move(cells), cells_of(tooth_table(), sample.joint.teeth[i]));
  }
  return joined(std::move(cells), cells_of(energy_table(), sample));
}

std::vector<CsvCell> energy_row(const Sample& sample, const CurveLayout& layout) {
  return joined({sample.time_s, layout.joint ? sample.closure_mm : sample.axial_strain},
                cells_of(energy_table(), sample));
}

std::vector<CsvCell> crack_row(const Crack& crack) { return cells_of(crack_table(), crack); }

std::vector<CsvCell> event_row(const AcousticEvent& event) { return cells_of(event_table(), event); }

std::vector<CsvCell> fragment_row(std::size_t number, double area_mm2) {
  return {number, area_mm2, equivalent_diameter(area_mm2)};
}

}  // namespace asperity
