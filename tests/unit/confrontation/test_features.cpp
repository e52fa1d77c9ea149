#include "core/confrontation/test_features.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/random.hpp"
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

namespace {

/// Specimens that differ by the noise of their rows alone: up to 10 MPa at a strain of 0.01, down to 2 MPa,
/// widening by a quarter of the strain.
std::string noisy_specimens(int specimens, double noise) {
  RandomStream random(20261127, "specimens");
  std::string text = "specimen,axial_strain,axial_stress_mpa,lateral_strain\n";
  for (int s = 0; s < specimens; ++s) {
    for (int i = 0; i <= 300; ++i) {
      const double path = 1e-4 * i, load = i <= 100 ? 0.1 * i : std::max(2.0, 10.0 - 0.1 * (i - 100));
      text += fmt::format("{},{:.8f},{:.6f},{:.8f}\n", s, path + 0.1 * noise * 0.03 * random.normal(),
                          load + noise * 10.0 * random.normal(), 0.25 * path + noise * 0.0075 * random.normal());
    }
  }
  return text;
}

json with_noise_of(double percent) {
  json document = uniaxial("c.csv");
  document["tests"][0]["instrument"] = {{"load_noise_percent", percent},
                                        {"displacement_noise_percent", 0.1 * percent},
                                        {"transverse_noise_percent", percent}};
  return document;
}

}  // namespace

TEST_CASE("what rows' noise is said to make of a feature is what specimens scatter that differ by it alone") {
  const Folder folder("rows");
  folder.put("c.csv", noisy_specimens(150, 0.005));
  int compared = 0;
  for (const TestFeature& f : features_of(folder.read(with_noise_of(0.5)).tests[0])) {
    if (f.kind->name != "peak_axial_stress_mpa" && f.kind->name != "axial_modulus_gpa" &&
        f.kind->name != "lateral_ratio" && f.kind->name != "drop_share")
      continue;
    double square = 0.0;
    for (const SpecimenValue& s : f.specimens) square += s.noise_sd * s.noise_sd / static_cast<double>(f.count);
    CAPTURE(f.kind->name, f.mean, f.sd, std::sqrt(square));
    CHECK(f.count == 150);
    CHECK(std::sqrt(square) / f.sd == Approx(1.0).margin(0.2));
    ++compared;
  }
  CHECK(compared == 4);
}

TEST_CASE("rows without noise make no scatter") {
  const Folder folder("exact_rows");
  folder.put("c.csv", noisy_specimens(1, 0.0));
  for (const TestFeature& f : features_of(folder.read(with_noise_of(0.0)).tests[0]))
    CHECK(f.specimens.front().noise_sd == Approx(0.0).margin(1e-12));  // rounding of the draws' mean
}
