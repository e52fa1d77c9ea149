#include "core/measurement/band_fit.hpp"

#include <catch2/catch.hpp>

#include "tests/unit/measurement/patterns.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr double kWidth = 54, kHeight = 130;

/// A zigzag through the specimen's middle from flank to flank, or from end to end where it is steeper than that.
CrackPattern band_at(double angle_deg, int first = 0, double shift = 0.0) {
  const double angle = angle_deg * std::numbers::pi / 180;
  const Vec2 along{std::sin(angle), std::cos(angle)}, middle{shift, 0.5 * kHeight};
  const double half = std::min(0.5 * kHeight / along.y, std::abs(along.x) > 0 ? 0.5 * kWidth / std::abs(along.x) : 1e9);
  return straight(middle - half * along, middle + half * along, 60, BreakMode::shear, first, 0.6);
}

}  // namespace

TEST_CASE("a band is found at its angle") {
  const double angle = GENERATE(0.0, 5.0, -20.0, 28.0, -37.0, 45.0, 58.0);
  const FailureBands band = fit_bands(band_at(angle), kWidth, kHeight);
  INFO(angle);
  CHECK(band.angle_deg[0] == Approx(angle).margin(1.01));  // whole degrees
  CHECK(band.share[0] == Approx(1.0));
  CHECK(band.concentration > 4.0);  // the whole specimen over a band of a tenth of the width
}

TEST_CASE("among scattered cracks the band is still found") {
  const FailureBands band = fit_bands(band_at(30) + scattered(40, kWidth, kHeight, 2), kWidth, kHeight);
  CHECK(band.angle_deg[0] == Approx(30).margin(2.01));
  CHECK(band.share[0] > 0.55);
  CHECK(band.concentration > 3.0);
}

TEST_CASE("of conjugate bands the longer is the first, the other the second") {
  const CrackPattern second = band_at(-30, 1000);
  const CrackPattern cracks = band_at(30) + CrackPattern(second.begin(), second.begin() + 40);
  const FailureBands band = fit_bands(cracks, kWidth, kHeight);
  CHECK(band.angle_deg[0] == Approx(30).margin(2.01));
  CHECK(band.angle_deg[1] == Approx(-30).margin(2.01));
  CHECK(band.share[0] + band.share[1] == Approx(1.0).margin(0.02));
  CHECK(band.concentration > 4.0);
}

TEST_CASE("evenly scattered cracks are concentrated only by chance") {
  for (const int count : {60, 150, 500}) {
    double concentration = 0.0, significance = 0.0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const FailureBands bands = fit_bands(scattered(count, kWidth, kHeight, 2, seed), kWidth, kHeight);
      concentration = std::max(concentration, bands.concentration);
      significance = std::max(significance, bands.significance);
    }
    WARN(count << " scattered cracks: concentration up to " << concentration << ", significance " << significance);
    CHECK(significance < 5.0);  // what the verdict asks of a band
    CHECK(concentration > 1.0);
  }
  CHECK(fit_bands(band_at(30), kWidth, kHeight).significance > 10.0);
}

TEST_CASE("a cut off corner is no band") {
  const CrackPattern corner = straight({10, 0}, {27, 17}, 20, BreakMode::shear);  // 24 mm long
  const FailureBands band = fit_bands(corner, kWidth, kHeight);
  // The specimen over a band of at least its width in length. The corner's own 24 mm would give 7020 / (10.8 x 24)
  // = 27.
  CHECK(band.concentration <= 1.001 * kHeight / (kBandWidth * kWidth));
}

TEST_CASE("no cracks, no band") { CHECK(std::isnan(fit_bands({}, kWidth, kHeight).angle_deg[0])); }
