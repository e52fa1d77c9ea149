#include "core/output/measured_curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/base/error.hpp"
#include "core/output/csv.hpp"

namespace asperity {
namespace {

/// The two columns that a measured curve of a test must have.
struct NeededColumns {
  const char* abscissa;
  const char* stress;
};

NeededColumns needed_columns(ExperimentType type) {
  if (type == ExperimentType::direct_shear) return {"shear_displacement_mm", "shear_stress_mpa"};
  if (type == ExperimentType::brazilian) return {"platen_displacement_mm", "load_n_per_mm"};
  return {"axial_strain", "axial_stress_mpa"};
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void require_columns(const CsvData& table, const NeededColumns& needed, const std::string& file) {
  std::vector<Fault> faults;
  for (const char* name : {needed.abscissa, needed.stress}) {
    if (table.has(name)) continue;
    faults.push_back({file, "the measured curve has no column \"" + std::string(name) + "\"", listed(table.names()),
                      std::string(needed.abscissa) + ", " + needed.stress + " in this experiment",
                      "name the columns in the first line, units included"});
  }
  if (faults.empty() && table.rows() == 0) {
    faults.push_back({file, "the measured curve has no rows", "", "one row a reading", ""});
  }
  if (!faults.empty()) throw Error(ErrorKind::config, std::move(faults));
}

std::vector<double> numbers_or_nan(const CsvData& table, const char* name) {
  return table.has(name) ? table.numbers(name) : std::vector<double>(table.rows(), NAN);
}

/// A disc's displacement and load in the terms of its curve.
void convert_disc(MeasuredCurve& curve, double diameter_mm) {
  for (double& x : curve.abscissa) x /= diameter_mm;
  for (double& y : curve.stress_mpa) y *= 2.0 / (std::numbers::pi * diameter_mm);
}

MeasuredCurve whole_file(const CsvData& table, const RunConfig& config, const NeededColumns& needed) {
  MeasuredCurve curve{config.output.measured_name.value_or("measured"),
                      table.numbers(needed.abscissa),
                      table.numbers(needed.stress),
                      numbers_or_nan(table, "lateral_strain"),
                      numbers_or_nan(table, "dilation_mm"),
                      numbers_or_nan(table, "dilation_rear_mm")};
  if (config.experiment.type == ExperimentType::brazilian) convert_disc(curve, config.experiment.diameter_mm);
  return curve;
}

/// The curve's rows of one specimen.
MeasuredCurve of_specimen(const MeasuredCurve& all, const std::vector<std::string>& specimens, const std::string& one) {
  MeasuredCurve curve{all.name + (one.empty() ? "" : ", " + one), {}, {}, {}, {}, {}};
  for (std::size_t i = 0; i < specimens.size(); ++i) {
    if (specimens[i] != one) continue;
    curve.abscissa.push_back(all.abscissa[i]);
    curve.stress_mpa.push_back(all.stress_mpa[i]);
    curve.lateral_strain.push_back(all.lateral_strain[i]);
    curve.dilation_mm.push_back(all.dilation_mm[i]);
    curve.dilation_rear_mm.push_back(all.dilation_rear_mm[i]);
  }
  return curve;
}

}  // namespace

std::vector<MeasuredCurve> read_measured_curves(const RunConfig& config) {
  if (!config.output.measured_curve) return {};
  const CsvData table = read_csv(*config.output.measured_curve);
  const NeededColumns needed = needed_columns(config.experiment.type);
  require_columns(table, needed, *config.output.measured_curve);
  const MeasuredCurve all = whole_file(table, config, needed);
  if (!table.has("specimen")) return {all};
  const std::vector<std::string> specimens = table.words("specimen");
  std::vector<std::string> names;
  std::vector<MeasuredCurve> curves;
  for (const std::string& name : specimens) {
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    names.push_back(name);
    curves.push_back(of_specimen(all, specimens, name));
  }
  return curves;
}

}  // namespace asperity
