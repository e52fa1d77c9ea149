#include "core/measurement/failure_mode.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "tests/unit/measurement/patterns.hpp"
#include "tests/unit/measurement/small_specimen.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

constexpr double kDiameter = 54, kWidth = 54, kHeight = 130;
constexpr BreakMode kTension = BreakMode::tension, kShear = BreakMode::shear;

DiscFailure disc(const CrackPattern& pattern) { return disc_failure(pattern, kDiameter); }
CompressionFailure compression(const CrackPattern& pattern) { return compression_failure(pattern, kWidth, kHeight); }

CrackPattern oblique_band() { return straight({-27, 30}, {27, 105}, 50, kShear, 0, 0.8); }

}  // namespace

TEST_CASE("a straight split of a disc: tension along the loaded diameter, from platen to platen") {
  const DiscFailure d = disc(straight({0, 0}, {0, kDiameter}, 28, kTension, 0, 0.5));
  CHECK(d.verdict() == std::string("tension split"));
  CHECK(d.cracks.tension == 28);
  CHECK(d.cracks.shear == 0);
  CHECK(d.cracks.tension_share == 1.0);
  CHECK(d.tension_in_central_band == Approx(1.0));
  CHECK(d.splits());
  CHECK(d.path_tension_share() == 1.0);
  CHECK(d.path_offset_mm() == Approx(0.5));
  CHECK(total_length(d.path) >= 0.7 * kDiameter);  // between the two ends
  CHECK(total_length(d.path) < 0.95 * kDiameter);
  CHECK(d.near_platens == Approx(0.3).margin(0.04));  // 0.15 at either end; a crack is 2 mm
  CHECK(d.orientation.mean_deg == Approx(0.0).margin(1));
}

TEST_CASE("an oblique shear crack from wedge to wedge splits the disc, but not by tension nor along the diameter") {
  const CrackPattern wedges = straight({-8, 0}, {0, 7}, 4, kShear, 100) + straight({0, 7}, {8, 0}, 4, kShear, 200);
  const DiscFailure d =
      disc(wedges + straight({0, 7}, {14, 48}, 20, kShear, 0) + straight({14, 20}, {14, 24}, 2, kTension, 300));
  CHECK(d.verdict() == std::string("shear split"));
  CHECK(d.path_tension_share() == 0.0);
  CHECK(d.path_offset_mm() > 0.2 * kDiameter);
  CHECK(d.tension_in_central_band == 0.0);
}

TEST_CASE("crushed ends alone, a gap, or no crack: no split") {
  const CrackPattern wedge = straight({-8, 0}, {0, 7}, 4, kShear) + straight({-5, 53}, {0, 48}, 4, kShear, 100);
  CHECK(disc(wedge).verdict() == std::string("no split"));
  CHECK(disc(wedge).near_platens == Approx(1.0));
  CHECK(std::isnan(disc(wedge).path_tension_share()));
  CHECK(std::isnan(disc(wedge).path_offset_mm()));
  CrackPattern split = straight({0, 0}, {0, kDiameter}, 27, kTension);
  split.erase(split.begin() + 13);
  CHECK(disc(split).verdict() == std::string("no split"));
  CHECK(disc({}).verdict() == std::string("none"));
  CHECK(std::isnan(disc({}).cracks.tension_share));
}

TEST_CASE("a way that is mostly shear is a shear split, and the tension share is by length") {
  const DiscFailure d = disc(straight({0, 5}, {0, 20}, 3, kTension) + straight({0, 20}, {0, 50}, 3, kShear, 3));
  CHECK(d.path_tension_share() == Approx(1.0 / 3.0));
  CHECK(d.verdict() == std::string("shear split"));
}

TEST_CASE("an oblique band: its angle by fit and by second moments, and it spans the width") {
  const CompressionFailure c = compression(oblique_band());
  const double angle = std::atan2(54, 75) * 180 / std::numbers::pi;
  CHECK(c.verdict() == std::string("oblique band"));
  CHECK(c.bands.angle_deg[0] == Approx(angle).margin(1.01));
  CHECK(c.cluster.angle_deg == Approx(angle).margin(0.5));
  CHECK(c.cluster.elongation > 20);
  CHECK(c.cluster_share == Approx(1.0));
  CHECK(c.spans_width());
  CHECK_FALSE(c.spans_height());
  CHECK(c.cluster_height_share == Approx(75.0 / 130.0).margin(0.02));
}

TEST_CASE("a band of cracks that do not hang together is a band too") {
  CrackPattern gaps = oblique_band();
  for (std::size_t i = 0; i < gaps.size(); i += 3)
    gaps[i].vertex = {1000 + static_cast<int>(i), 2000 + static_cast<int>(i)};
  const CompressionFailure c = compression(gaps);
  CHECK(c.verdict() == std::string("oblique band"));
  CHECK_FALSE(c.spans_width());
  CHECK(c.cluster_share < 0.1);
}

TEST_CASE("conjugate bands are told by the fit, not by the cluster that holds both") {
  const CrackPattern second = straight({-27, 105}, {0, 67.5}, 25, kShear, 1000, 0.8);
  CrackPattern both = oblique_band() + second;
  both.back().vertex[1] = 25;  // where they cross
  const CompressionFailure c = compression(both);
  CHECK(c.verdict() == std::string("oblique band"));
  CHECK(c.bands.angle_deg[0] == Approx(36).margin(2));
  CHECK(c.cluster.elongation < 5);
}

TEST_CASE("axial splits, one or several, from end to end") {
  const CompressionFailure one = compression(straight({3, 0}, {5, kHeight}, 60, kTension, 0, 0.6));
  CHECK(one.verdict() == std::string("axial splitting"));
  CHECK(one.spans_height());
  CrackPattern columns;
  for (int i = 0; i < 5; ++i) {
    const double x = -22.0 + 11.0 * i;
    columns = columns + straight({x, 0}, {x + 1, kHeight}, 60, kTension, 100 * i, 0.6);
  }
  const CompressionFailure several = compression(columns);
  CHECK(several.verdict() == std::string("axial splitting"));
  CHECK(several.cracks.tension_share == 1.0);
}

TEST_CASE("a steep band broken in shear is no split") {
  const CompressionFailure c = compression(straight({-3, 0}, {20, kHeight}, 60, kShear, 0, 0.6));  // 10 degrees
  CHECK(c.bands.angle_deg[0] == Approx(10).margin(1.01));
  CHECK(c.spans_height());
  CHECK_FALSE(c.spans_width());
  CHECK(c.verdict() == std::string("oblique band"));
}

TEST_CASE("scattered cracks are diffuse, a few none") {
  const CompressionFailure many = compression(scattered(300, kWidth, kHeight, 2));
  CHECK(many.verdict() == std::string("diffuse"));
  CHECK(many.cluster_share < 0.02);
  CHECK(compression(scattered(26, kWidth, kHeight, 2)).verdict() == std::string("none"));  // 52 mm
  CHECK(compression({}).verdict() == std::string("none"));
  CHECK(compression({}).cluster_width_share == 0.0);
}

TEST_CASE("fragments' shares, and fragments at an earlier time") {
  SmallSpecimen s = small_specimen(3, 1);
  break_contact(s.contacts, contact_between(s.contacts, 0, 3), kTension, 1.0);
  const FragmentShares end = fragment_shares(find_fragments(s.contacts, s.particles));
  CHECK(end.largest == Approx(2.0 / 3.0));
  CHECK(end.second == Approx(1.0 / 3.0));
  const FragmentShares before = fragment_shares(find_fragments(s.contacts, s.particles, 0.5));
  CHECK(before.largest == 1.0);
  CHECK(before.second == 0.0);
}
