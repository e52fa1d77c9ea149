#include "core/calibration/moves.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/unit/calibration/examples.hpp"

using namespace asperity;
using examples::Point;

namespace {

double plane(const Point& x) { return 10.0 + 3.0 * x[0] + 4.0 * x[1]; }

Move move_to(Design design, double target, double most = 1.0) {
  const ResponseSystem system = examples::full_system(design, {examples::response_of("a", design, plane)}, {target});
  return next_centre(design, system, {{}, most});
}

}  // namespace

TEST_CASE("the centre goes along the steepest ascent, at most one alpha") {
  const Design design = examples::plain_design(2);
  const Move move = move_to(design, 100.0);  // far: the desirability is 0, the misfit leads
  CHECK(move.moved_by <= design.alpha);
  CHECK(move.moved_by > design.alpha - 0.05);  // a stride
  CHECK(move.coded[1] / move.coded[0] == Approx(4.0 / 3.0));
  CHECK(move.factors[0].centre == Approx(10.0 + 1.0 * move.coded[0]));
  CHECK(move.factors[1].centre == Approx(20.0 + 2.0 * move.coded[1]));
  CHECK(move.factors[1].step == 2.0);
  CHECK(move.merit_after > move.merit_before);
  CHECK(move_to(design, 100.0, 0.5).moved_by <= 0.5 * design.alpha);
}

TEST_CASE("the centre stops where the target is met") {
  const Move move = move_to(examples::plain_design(2), 12.5);  // 2.5 up a slope of 5: half a coded unit
  CHECK(move.moved_by == Approx(0.5).margin(2e-4));            // the shortest stride and its half
}

TEST_CASE("a centre that is the best already does not move") {
  const Design design = examples::plain_design(2);
  const auto bowl = [](const Point& x) { return 10.0 + x[0] * x[0] + x[1] * x[1]; };
  const Move move =
      next_centre(design, examples::full_system(design, {examples::response_of("a", design, bowl)}, {5.0}), {});
  CHECK(move.moved_by < 1e-3);
}

TEST_CASE("limits hold the star points, and shrink the step where the room is small") {
  Design design = examples::plain_design(2);
  design.factors[0].upper = 11.5;  // star at 10 + 1.414: room for 0.086
  design.factors[1].lower = 18.0;
  design.factors[1].upper = 22.0;  // 4 wide, but the stars need 5.66
  const Move move = move_to(design, 100.0);
  CHECK(move.factors[0].centre + design.alpha * move.factors[0].step == Approx(11.5));
  CHECK(move.factors[0].step == 1.0);
  CHECK(move.factors[1].centre == Approx(20.0));
  CHECK(move.factors[1].step == Approx(2.0 / design.alpha));
  CHECK(move.limited == std::vector<bool>{true, true});
  CHECK(move.coded[0] == Approx(1.5 - design.alpha));
}

TEST_CASE("on the logarithmic scale centre and limits go by ratios") {
  Design design = examples::plain_design(2);
  design.factors[0].scale = FactorScale::logarithmic;
  design.factors[0].step = 2.0;
  design.factors[0].upper = 40.0;
  const Move move = move_to(design, 100.0);
  CHECK(move.factors[0].centre * std::pow(2.0, design.alpha) == Approx(40.0));
  CHECK(move.factors[0].step == Approx(2.0));
}
