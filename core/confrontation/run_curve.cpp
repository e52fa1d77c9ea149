#include "core/confrontation/run_curve.hpp"

#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/confrontation/curve_columns.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

namespace fs = std::filesystem;

/// Cracks of both modes stand for acoustic events.
std::vector<double> cracks(const CsvData& table) {
  std::vector<double> events = table.numbers("cracks_tension");
  const std::vector<double> shear = table.numbers("cracks_shear");
  for (std::size_t i = 0; i < events.size(); ++i) events[i] += shear[i];
  return events;
}

}  // namespace

Curve curve_of_run(const CsvData& table, const RunConfig& config) {
  Curve curve;
  for (const ColumnKind& kind : curve_columns(config.experiment.type)) {
    const std::string name = std::string(kind.base) + std::string(unit_suffixes(kind.quantity).front().suffix);
    if (kind.member != &Curve::events) curve.*(kind.member) = table.numbers(name);
  }
  curve.events = cracks(table);
  return curve;
}

CurveReading reading_of_run(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  CurveReading reading;
  reading.experiment = e.type;
  reading.plane = e.plane;
  reading.confining_pressure_mpa = e.confining_pressure_mpa;
  reading.modulus_window_low = config.measurement.modulus_window_low;
  reading.modulus_window_high = config.measurement.modulus_window_high;
  if (e.type == ExperimentType::brazilian) reading.diameter_mm = e.diameter_mm;
  if (e.type == ExperimentType::direct_shear) return reading;
  const double over = e.type == ExperimentType::brazilian ? e.diameter_mm : 1.0;
  reading.path_limit = config.measurement.peak_strain_limit * over;
  return reading;
}

RunCurve read_run_curve(const fs::path& folder) {
  const fs::path config = folder / "config.effective.json", curves = folder / "curves.csv";
  if (!fs::exists(config) || !fs::exists(curves)) {
    throw Error(ErrorKind::config,
                {{folder.string(), "is no run folder: config.effective.json or curves.csv is missing", "",
                  "a folder that `asperity run` has written", ""}});
  }
  RunCurve run{with_mechanisms(read_run_config(config)), {}};
  run.curve = curve_of_run(read_csv(curves), run.config);
  return run;
}

}  // namespace asperity
