#include "core/confrontation/proposed_split.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

namespace {

MeasuredTest compression(const std::string& id, double pressure) {
  MeasuredTest test;
  test.id = id;
  test.experiment = pressure > 0.0 ? ExperimentType::triaxial : ExperimentType::uniaxial;
  if (pressure > 0.0) test.confining_pressure_mpa = pressure;
  return test;
}

MeasuredTest joint(const std::string& id, double stress) {
  MeasuredTest test;
  test.id = id;
  test.experiment = ExperimentType::direct_shear;
  test.normal_stress_mpa = stress;
  return test;
}

std::string kept_back(std::vector<MeasuredTest> tests) {
  MeasuredData data;
  data.tests = std::move(tests);
  propose_split(data);
  std::string ids;
  for (const MeasuredTest& test : data.tests) ids += test.use == TestUse::hold_out ? test.id : "";
  return ids;
}

}  // namespace

TEST_CASE("every third distinct pressure is kept back, neither the lowest nor the highest") {
  CHECK(kept_back({compression("u", 0), compression("a", 1), compression("b", 2), compression("c", 3)}) == "b");
  CHECK(kept_back({compression("c", 3), compression("b", 2), compression("u", 0), compression("a", 1)}) == "b");
  CHECK(kept_back({compression("u", 0), compression("a", 1), compression("c", 3)}).empty());
  CHECK(kept_back({compression("u", 0), compression("a", 10), compression("b", 20), compression("c", 30),
                   compression("d", 40), compression("e", 50), compression("f", 60)}) == "be");
}

TEST_CASE("joints have their own levels, discs none, and all tests of a level go together") {
  MeasuredTest disc;
  disc.id = "D";
  disc.experiment = ExperimentType::brazilian;
  CHECK(kept_back({disc, joint("p", 1), joint("q", 2), joint("r", 3), joint("s", 4)}) == "r");
  CHECK(kept_back({compression("u", 0), compression("v", 0), compression("a", 1), compression("b", 2),
                   compression("B", 2), compression("c", 3)}) == "bB");
}

TEST_CASE("twice as many tests stay fitted as are kept back") {
  CHECK(kept_back(
            {compression("u", 0), compression("a", 1), compression("b", 2), compression("B", 2), compression("c", 3)})
            .empty());
}
