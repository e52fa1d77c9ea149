#include "core/measurement/acoustic.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace asperity;

namespace {

/// Particles of 2 mm edges: cracks join within 6 mm, and within 6 mm / c_s in time.
const RunConfig& config() {
  static const RunConfig c;
  return c;
}

constexpr double kDistance = 6.0;

/// c_s = sqrt(G / rho) = sqrt(1300 MPa / 2.4 / 1.2e-9 t/mm3) of the default plaster.
double delay() { return kDistance / std::sqrt(1300.0 / 2.4 / 1.2e-9); }

Crack crack(double time, Vec2 place, BreakMode mode = BreakMode::tension, double energy = 1.0) {
  return {0, mode, time, place, 0.0, 2.0, energy};
}

}  // namespace

TEST_CASE("no cracks, no events") { CHECK(group_events({}, config()).empty()); }

TEST_CASE("the default particles are those the figures here are made for") {
  CHECK(config().particles.edge_mm * 3 == kDistance);
  CHECK(config().particles.youngs_modulus_gpa == 1.3);
  CHECK(config().particles.density_kg_per_m3 == 1200.0);
}

TEST_CASE("cracks near in space and time are one event") {
  const double t = 0.9 * delay();
  const std::vector<Crack> cracks{crack(1.0, {0, 0}, BreakMode::tension, 1.0),
                                  crack(1.0 + t, {5.9, 0}, BreakMode::shear, 3.0)};
  const std::vector<AcousticEvent> events = group_events(cracks, config());
  REQUIRE(events.size() == 1);
  CHECK(events[0].time_s == 1.0);
  CHECK(events[0].duration_s == (1.0 + t) - 1.0);
  CHECK(events[0].cracks == 2);
  CHECK(events[0].tension == 1);
  CHECK(events[0].shear == 1);
  CHECK(events[0].energy_n_mm == 4.0);
}

TEST_CASE("cracks too far apart in space or in time are two events") {
  const std::vector<Crack> in_space{crack(1.0, {0, 0}), crack(1.0, {6.1, 0})};
  CHECK(group_events(in_space, config()).size() == 2);
  const std::vector<Crack> in_time{crack(1.0, {0, 0}), crack(1.0 + 1.1 * delay(), {1, 0})};
  CHECK(group_events(in_time, config()).size() == 2);
}

TEST_CASE("a chain of near cracks is one event though its ends are far apart") {
  const std::vector<Crack> cracks{crack(1.0, {0, 0}), crack(1.0, {10, 0}), crack(1.0 + 0.5 * delay(), {5, 0})};
  CHECK(group_events(cracks, config()).size() == 1);
}

TEST_CASE("events come in the order of their first cracks") {
  const double t = 0.1 * delay();
  const std::vector<Crack> cracks{crack(1.0, {0, 0}), crack(1.0 + t, {50, 0}), crack(1.0 + 2 * t, {1, 0})};
  const std::vector<AcousticEvent> events = group_events(cracks, config());
  REQUIRE(events.size() == 2);
  CHECK(events[0].cracks == 2);
  CHECK(events[1].time_s == 1.0 + t);
}

TEST_CASE("an event lies at its cracks' mean place weighted by length") {
  std::vector<Crack> cracks{crack(1.0, {0, 0}), crack(1.0, {4, 4})};
  cracks[1].length_mm = 6.0;
  const AcousticEvent event = group_events(cracks, config()).at(0);
  CHECK(event.place == Vec2{3, 3});
}

TEST_CASE("cracks that spent no energy still have a place") {
  const std::vector<Crack> cracks{crack(1.0, {2, 4}, BreakMode::shear, 0.0)};
  CHECK(group_events(cracks, config()).at(0).place == Vec2{2, 4});
}
