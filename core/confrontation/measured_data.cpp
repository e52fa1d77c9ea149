#include "core/confrontation/measured_data.hpp"

#include <algorithm>

namespace asperity {

bool path_is_gauge(const MeasuredTest& test) {
  if (!test.axial_gauge_mm || test.curves.empty()) return false;
  // Of two strains axial_strain is the platens'; alone it is the gauge's, and stands in both columns.
  return test.curves.front().curve.gauge_strain == test.curves.front().curve.path;
}

CurveReading reading_of(const MeasuredTest& test) {
  constexpr double kShare = 0.01;
  CurveReading reading;
  reading.experiment = test.experiment;
  reading.plane = test.plane;
  reading.path_is_gauge = path_is_gauge(test);
  reading.diameter_mm = test.diameter_mm;
  reading.confining_pressure_mpa = test.confining_pressure_mpa.value_or(0.0);
  reading.load_noise = kShare * test.instrument.load_noise_percent;
  reading.path_noise = kShare * test.instrument.displacement_noise_percent;
  return reading;
}

std::vector<std::string> specimens_of(const MeasuredTest& test) {
  std::vector<std::string> names;
  for (const SpecimenCurve& curve : test.curves) names.push_back(curve.specimen);
  std::size_t most = 0;
  for (const auto& [name, values] : test.results) most = std::max(most, values.size());
  while (names.size() < most) names.push_back(std::to_string(names.size() + 1));
  return names;
}

}  // namespace asperity
