#include "core/confrontation/test_features.hpp"

#include <cmath>

#include "tests/support/measured_folder.hpp"

using namespace asperity;
using namespace asperity::measured;

TEST_CASE("an instrument's errors go into a feature as its equation has them") {
  const Folder folder("errors");
  folder.put("c.csv", triangle("axial_strain,axial_stress_mpa", 0.01));
  json document = uniaxial("c.csv");
  document["tests"][0]["instrument"] = {{"load_noise_percent", 0},
                                        {"load_scale_percent", 3},
                                        {"load_zero_percent", 4},
                                        {"displacement_scale_percent", 1},
                                        {"displacement_zero_mm", 0.5}};
  for (const TestFeature& f : features_of(folder.read(document).tests[0])) {
    const double sd = f.specimens.front().instrument_sd;
    if (f.kind->name == "peak_axial_stress_mpa") CHECK(sd == Approx(0.5));                      // of 10: 0.3 and 0.4
    if (f.kind->name == "peak_axial_strain") CHECK(sd == Approx(std::hypot(1e-4, 0.5 / 100)));  // 0.5 mm of 100 mm
    if (f.kind->name == "peak_strain_from_toe") CHECK(sd == Approx(std::hypot(1e-4, 4e-4)));  // the zeros of path: none
  }
}
