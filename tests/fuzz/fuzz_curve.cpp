#include <cmath>

#include "core/base/error.hpp"
#include "core/confrontation/measured_curve.hpp"
#include "core/confrontation/test_features.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

namespace {

void read_as(const CsvData& table, ExperimentType experiment) {
  MeasuredTest test;
  test.experiment = experiment;
  test.diameter_mm = test.thickness_mm = test.height_mm = 50.0;
  test.confining_pressure_mpa = 1.0;
  if (!take_in_curves(table, "input.csv", test).empty() || !curve_faults(test).empty()) return;
  for (const TestFeature& feature : features_of(test)) {
    for (const SpecimenValue& s : feature.specimens) {
      fuzz::require(s.value.has_value() == s.absent.empty(), "a feature has a value or a reason");
      fuzz::require(!s.value || std::isfinite(*s.value), "a value is finite");
    }
  }
}

}  // namespace

/// The bytes of a measured curve, read as each experiment's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const CsvData table = parse_csv(fuzz::text_of(data, size), "input.csv");
    using enum ExperimentType;
    for (const ExperimentType type : {uniaxial, triaxial, brazilian, direct_shear}) read_as(table, type);
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::config, "a refusal is a fault of the data");
  }
  return 0;
}
