#include <catch2/catch.hpp>
#include <cmath>

#include "core/integrator/drive_line.hpp"

using namespace asperity;

namespace {

constexpr double kRounding = 1e-12;

/// 200 N/mm, 0.1 mm of seating, half of it closed at 5 N, all per mm of thickness.
DriveLine line() {
  DriveLine l;
  l.stiffness = 200.0;
  l.seating = 0.1;
  l.half_load = 5.0;
  l.tied = 1;
  return l;
}

double pull_at(DriveLine& l, double stretch) {
  l.stretch = stretch;
  return pull(l);
}

}  // namespace

TEST_CASE("a line without seats is its spring, both ways") {
  DriveLine l = line();
  l.seating = 0.0;
  CHECK(pull_at(l, 0.03) == 6.0);
  CHECK(pull_at(l, -0.01) == -2.0);
  CHECK(l.closed == 0.0);
  CHECK(first_stiffness(l) == Approx(200.0).epsilon(kRounding));
}

TEST_CASE("first loading follows the stretch of spring and seats, by hand") {
  DriveLine l = line();
  // At 5 N: 5/200 in the spring, half of 0.1 in the seats. At 20 N: 0.1 and 0.08. At 0.5 N: 0.0025 and 0.05/5.5.
  for (const auto& [load, stretch] :
       {std::pair{0.5, 0.0025 + 0.05 / 5.5}, std::pair{5.0, 0.025 + 0.05}, std::pair{20.0, 0.1 + 0.08}}) {
    CHECK(pull_at(l, stretch) == Approx(load).epsilon(kRounding));
    CHECK(l.closed == Approx(stretch - load / 200.0).epsilon(kRounding));
  }
  CHECK(first_stiffness(l) == Approx(1.0 / (1.0 / 200.0 + 0.1 / 5.0)).epsilon(kRounding));
  CHECK(pull_at(l, 1e3) == Approx(200.0 * (1e3 - 0.1)).epsilon(1e-6));  // all closed
}

TEST_CASE("seats that have closed stay closed: unloading and reloading are the spring's, then first loading goes on") {
  DriveLine l = line();
  CHECK(pull_at(l, 0.18) == Approx(20.0).epsilon(kRounding));
  CHECK(pull_at(l, 0.13) == Approx(10.0).epsilon(kRounding));
  CHECK(pull_at(l, 0.08) == Approx(0.0).margin(1e-12));
  CHECK(pull_at(l, 0.07) == Approx(-2.0).epsilon(1e-10));
  CHECK(pull_at(l, 0.155) == Approx(15.0).epsilon(kRounding));
  CHECK(l.closed == Approx(0.08).epsilon(kRounding));
  const double at_45 = 45.0 / 200.0 + 0.1 * 45.0 / 50.0;
  CHECK(pull_at(l, at_45) == Approx(45.0).epsilon(kRounding));
}

TEST_CASE("a soft first loading keeps its figures where the load is a millionth") {
  DriveLine l = line();
  const double load = 1e-6;
  CHECK(pull_at(l, load / 200.0 + 0.1 * load / (load + 5.0)) == Approx(load).epsilon(1e-9));
}

TEST_CASE("the stretch is the drive's way less the body's") {
  DriveLine l = line();
  l.drive_velocity = 100.0;
  advance_line(l, 40.0, 1e-3);
  CHECK(l.drive == Approx(0.1).epsilon(kRounding));
  CHECK(l.stretch == Approx(0.06).epsilon(kRounding));
}
