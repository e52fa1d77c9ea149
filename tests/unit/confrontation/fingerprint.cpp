#include "core/confrontation/fingerprint.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace asperity;

namespace {

constexpr ExperimentType kType = ExperimentType::uniaxial;

std::size_t place_of(std::string_view name) {
  const auto kinds = feature_kinds(kType);
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    if (kinds[k].name == name) return k;
  }
  FAIL("no such feature");
  return 0;
}

std::vector<FeatureValue> row(double peak, std::optional<double> strain) {
  std::vector<FeatureValue> values(feature_kinds(kType).size(), FeatureValue{std::nullopt, "not given"});
  values[place_of("peak_axial_stress_mpa")] = {peak, ""};
  values[place_of("peak_axial_strain")] = {strain, strain ? "" : "not given"};
  return values;
}

}  // namespace

TEST_CASE("changes are means of differences mesh by mesh, with their error and against the meshes' scatter") {
  // peaks 8, 10, 12 become 9, 11, 13 + (0, 0, 0.3): differences 1, 1, 1.3
  const std::vector<std::vector<FeatureValue>> base{row(8, 0.01), row(10, {}), row(12, 0.03)};
  const std::vector<std::vector<FeatureValue>> with{row(9, 0.02), row(11, 0.02), row(13.3, 0.02)};
  const std::vector<FeatureChange> changes = feature_changes(kType, base, with);
  REQUIRE(changes.size() == feature_kinds(kType).size());
  const FeatureChange& peak = changes[place_of("peak_axial_stress_mpa")];
  CHECK(peak.meshes == 3);
  CHECK(peak.base == Approx(10.0));
  CHECK(peak.base_sd == Approx(2.0));
  CHECK(peak.change == Approx(1.1));
  const double sd = std::sqrt(0.03);  // of 1, 1, 1.3
  CHECK(peak.change_error == Approx(sd / std::sqrt(3.0)));
  CHECK(peak.scatter_ratio == Approx(1.1 / std::hypot(2.0, sd)));
  const FeatureChange& strain = changes[place_of("peak_axial_strain")];
  CHECK(strain.meshes == 2);  // the second mesh has none without the mechanism
  CHECK(strain.change == Approx(0.0).margin(1e-15));
  CHECK(changes[place_of("loop_count")].meshes == 0);
}

TEST_CASE("only changes beyond their own error and of some size are told, the strongest against the scatter first") {
  const std::vector<std::vector<FeatureValue>> base{row(8, 0.010), row(10, 0.011), row(12, 0.012)};
  const std::vector<std::vector<FeatureValue>> with{row(9, 0.015), row(11, 0.016), row(13, 0.017)};
  const auto told = telling_changes(feature_changes(kType, base, with), 5, 0.01);
  REQUIRE(told.size() == 2);
  CHECK(told[0].kind->name == "peak_axial_strain");  // 5 scatters against a half
  CHECK(told[1].kind->name == "peak_axial_stress_mpa");
  CHECK(telling_changes(feature_changes(kType, base, with), 1, 0.01).size() == 1);
  CHECK(telling_changes(feature_changes(kType, base, with), 5, 0.2).size() == 1);  // the peak's 10 % are below a fifth
  const std::vector<std::vector<FeatureValue>> unsure{row(12, 0.010), row(8, 0.011), row(12, 0.012)};
  CHECK(telling_changes(feature_changes(kType, base, unsure), 5, 0.01).empty());
  CHECK(telling_changes(feature_changes(kType, base, base), 5, 0.0).empty());
  const std::span<const std::vector<FeatureValue>> one(base.data(), 1), other(with.data(), 1);
  CHECK(telling_changes(feature_changes(kType, one, other), 5, 0.0).empty());  // one mesh says nothing of scatter
}
