#include "core/confrontation/instrument_errors.hpp"

#include <cmath>

#include "tests/support/measured_folder.hpp"

using namespace asperity;
using namespace asperity::measured;
using Eigen::MatrixXd;

namespace {

/// Peak, its strain and the modulus of a test, with what its instruments may be off.
MeasuredErrors errors_of(const MeasuredTest& test) {
  const std::vector<TestFeature> features = features_of(test);
  std::vector<FeatureSlot> slots;
  std::vector<const TestFeature*> compared;
  for (const char* name : {"peak_axial_stress_mpa", "axial_modulus_gpa", "peak_axial_strain"}) {
    slots.push_back({find_feature_kind(test.experiment, name), std::string(name) != "peak_axial_strain", 0.0, nullptr});
    for (const TestFeature& f : features) {
      if (f.kind == slots.back().kind) compared.push_back(&f);
    }
  }
  return measured_errors(slots, compared, test);
}

/// Two specimens, the second twice as strong and stiff as the first.
json two_specimens(const Folder& folder, json instrument) {
  const std::string first = triangle("specimen,axial_strain,axial_stress_mpa", 0.01, 1.0, "a,");
  const std::string second = triangle("", 0.01, 2.0, "b,");
  folder.put("c.csv", first + second.substr(1));
  json document = uniaxial("c.csv");
  json exact = {{"load_noise_percent", 0},         {"displacement_noise_percent", 0}, {"load_scale_percent", 0},
                {"displacement_scale_percent", 0}, {"load_zero_percent", 0},          {"displacement_zero_mm", 0}};
  exact.update(instrument);
  document["tests"][0]["instrument"] = exact;
  return document;
}

MatrixXd covariance(const MeasuredErrors& errors) { return errors.of_mean.transpose() * errors.of_mean; }

}  // namespace

TEST_CASE("a load cell's scale moves a test's strength and modulus together, and no mean of specimens lessens it") {
  const Folder folder("scale");
  const MeasuredErrors errors = errors_of(folder.read(two_specimens(folder, {{"load_scale_percent", 2}})).tests[0]);
  const MatrixXd c = covariance(errors);
  CHECK(std::sqrt(c(0, 0)) == Approx(0.02));
  CHECK(std::sqrt(c(1, 1)) == Approx(0.02));
  CHECK(c(0, 1) == Approx(c(0, 0)));
  CHECK(c(2, 2) == Approx(0.0).margin(1e-12));
  CHECK(errors.own_sd.norm() == Approx(0.0).margin(1e-12));
}

TEST_CASE("zeros are each specimen's own, and their mean is known better") {
  const Folder folder("zeros");
  const MeasuredErrors errors = errors_of(folder.read(two_specimens(folder, {{"displacement_zero_mm", 0.5}})).tests[0]);
  CHECK(errors.own_sd(2) == Approx(0.005));
  CHECK(std::sqrt(covariance(errors)(2, 2)) == Approx(0.005 / std::sqrt(2.0)));
  CHECK(covariance(errors)(0, 0) == Approx(0.0).margin(1e-12));
}

TEST_CASE("a path's scale moves strains one way and moduli the other") {
  const Folder folder("path_scale");
  const MeasuredErrors errors =
      errors_of(folder.read(two_specimens(folder, {{"displacement_scale_percent", 1}})).tests[0]);
  const MatrixXd c = covariance(errors);
  CHECK(c(1, 2) < 0.0);
  CHECK(c(1, 2) * c(1, 2) == Approx(c(1, 1) * c(2, 2)));
}

TEST_CASE("numbers without a curve have the load cell's scale alone") {
  const Folder folder("numbers");
  json document = {{"tests",
                    {{{"id", "U"},
                      {"experiment", "uniaxial"},
                      {"height_mm", 100},
                      {"instrument", {{"load_scale_percent", 2}}},
                      {"results", {{"peak_axial_stress_mpa", {10, 12}}}}}}}};
  const MeasuredErrors errors = errors_of(folder.read(document).tests[0]);
  CHECK(covariance(errors)(0, 0) == Approx(4e-4));
  CHECK(covariance(errors)(1, 1) == 0.0);
  CHECK(errors.own_sd.norm() == 0.0);
}
