#include "core/measurement/crack_stresses.hpp"

#include <algorithm>

#include "core/base/units.hpp"
#include "core/measurement/line_fit.hpp"

namespace asperity {
namespace {

/// Rows up to the peak at which the platens have closed farther than ever before.
std::vector<std::size_t> first_loading(std::span<const double> path, std::size_t peak) {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i <= peak; ++i)
    if (rows.empty() || path[i] > path[rows.back()]) rows.push_back(i);
  return rows;
}

/// As elastic_slopes without a plane condition: the slopes as recorded, which the area's strain follows.
std::optional<ElasticResult> recorded_slopes(const ElasticColumns& columns, std::vector<std::size_t> rows,
                                             const StressRange& window) {
  rows.pop_back();  // the peak
  const std::vector<double> stress = gather(columns.stress_mpa, rows), axial = gather(columns.axial_strain, rows),
                            lateral = gather(columns.lateral_strain, rows);
  return elastic_slopes({stress, axial, lateral, columns.axial_noise}, rows.size(), window, std::nullopt);
}

std::size_t row_of_largest(const std::vector<std::size_t>& rows, const std::vector<double>& values) {
  return *std::max_element(rows.begin(), rows.end(),
                           [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
}

/// The last of the rows up to `end` at which the crack volumetric strain is still at its largest.
std::size_t dilation_onset(const CrackStresses& strains, const std::vector<std::size_t>& rows, std::size_t end) {
  double largest = strains.crack_volumetric[rows.front()], contraction = 0.0;
  for (const std::size_t row : rows) {
    if (row > end) break;
    largest = std::max(largest, strains.crack_volumetric[row]);
    contraction = std::max(contraction, strains.volumetric[row]);
  }
  std::size_t onset = rows.front();
  for (const std::size_t row : rows)
    if (row <= end && strains.crack_volumetric[row] >= largest - kDilationOnset * contraction) onset = row;
  return onset;
}

}  // namespace

StressRange elastic_window(const RunConfig& config, double peak_mpa) {
  const double base = config.experiment.confining_pressure_mpa, deviator = peak_mpa - base;
  return {base + config.measurement.modulus_window_low * deviator,
          base + config.measurement.modulus_window_high * deviator};
}

std::optional<CrackStresses> crack_stresses(const CompressionColumns& columns, std::size_t peak,
                                            const StressRange& window, double confining_pressure_mpa) {
  const ElasticColumns& c = columns.elastic;
  const std::vector<std::size_t> rows = first_loading(columns.path, peak);
  const auto slopes = recorded_slopes(c, rows, window);
  if (!slopes) return std::nullopt;
  const double compliance = (1.0 - slopes->poissons_ratio) / (slopes->youngs_modulus_gpa * units::kMpaPerGpa);
  CrackStresses result;
  for (std::size_t i = 0; i < c.stress_mpa.size(); ++i) {
    result.volumetric.push_back(c.axial_strain[i] - c.lateral_strain[i]);
    result.crack_volumetric.push_back(result.volumetric.back() -
                                      compliance * (c.stress_mpa[i] - confining_pressure_mpa));
  }
  result.damage_row = row_of_largest(rows, result.volumetric);
  if (result.damage_row < rows.back()) result.damage_mpa = c.stress_mpa[result.damage_row];
  result.initiation_row = dilation_onset(result, rows, result.damage_row);
  if (result.initiation_row < result.damage_row) result.initiation_mpa = c.stress_mpa[result.initiation_row];
  return result;
}

}  // namespace asperity
