#include "core/experiment/joint_verdict.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace asperity;

namespace {

constexpr double kLength = 50.0;

/// A leading flank whose force rises to `most` (N/mm) at `at` (mm) and falls as it rose; off at `off` (mm).
struct Course {
  double most, at, width, off;
};

/// Samples 0.01 mm apart up to 3 mm.
std::vector<Sample> samples_of(const std::vector<Course>& courses) {
  std::vector<Sample> samples(301);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double u = 0.01 * static_cast<double>(i);
    samples[i].closure_mm = u;
    for (std::size_t k = 0; k < courses.size(); ++k) {
      const Course& c = courses[k];
      samples[i].joint.teeth[k].leading.x = std::max(0.0, c.most * (1.0 - std::abs(u - c.at) / c.width));
      samples[i].joint.teeth[k].attached_share = u >= c.off ? 0.2 : 1.0;
    }
  }
  return samples;
}

TeethVerdict judged(const std::vector<Course>& courses) {
  return judge_teeth(samples_of(courses), courses.size(), kLength);
}

constexpr double kNever = 100.0;

}  // namespace

TEST_CASE("A tooth that is loaded only once the first has gone fails after it") {
  const TeethVerdict verdict = judged({{40, 2.0, 0.5, 2.2}, {80, 0.8, 0.5, 1.0}});
  CHECK(verdict.failure == TeethFailure::one_after_the_other);
  CHECK(verdict.first == 1u);
  // The top of a triangle of 0.5 mm to either side, as the mean over five samples: 1.2 steps of 0.02 below 1.
  CHECK(verdict.teeth[1].largest_mpa == Approx(80 * (1 - 1.2 * 0.02) / kLength));
  CHECK(verdict.teeth[1].largest_at_mm == Approx(0.8));
  CHECK(verdict.teeth[0].largest_at_mm == Approx(2.0));
  CHECK(verdict.teeth[0].share_with_first == 0.0);
  CHECK(verdict.teeth[1].share_with_first == 1.0);
  CHECK(verdict.teeth[0].sheared_off == 220u);
}

TEST_CASE("Teeth that bear at once fail together, also where one goes somewhat later") {
  const TeethVerdict verdict = judged({{40, 0.8, 0.5, 1.0}, {80, 1.0, 0.5, 1.3}});
  CHECK(verdict.failure == TeethFailure::together);
  CHECK(verdict.first == 0u);
  CHECK(verdict.teeth[1].share_with_first == Approx(0.6 / (1 - 1.2 * 0.02)));
}

TEST_CASE("Half of its own most is where together ends") {
  const auto failure = [](double at) { return judged({{40, 0.8, 0.5, 1.0}, {80, at, 0.5, 1.5}}).failure; };
  CHECK(failure(1.05) == TeethFailure::together);
  CHECK(failure(1.07) == TeethFailure::one_after_the_other);
}

TEST_CASE("Teeth that stand, some that stand, and a single one have words of their own") {
  CHECK(judged({{40, 0.8, 0.5, kNever}, {80, 1.0, 0.5, kNever}}).failure == TeethFailure::none);
  CHECK_FALSE(judged({{40, 0.8, 0.5, kNever}}).first);
  CHECK(judged({{40, 0.8, 0.5, kNever}, {80, 1.0, 0.5, 1.2}}).failure == TeethFailure::some);
  CHECK(judged({{40, 0.8, 0.5, 1.2}}).failure == TeethFailure::the_only_one);
}

TEST_CASE("What a tooth's rubble bears after it was sheared off is not the tooth's") {
  std::vector<Sample> samples = samples_of({{40, 0.8, 0.5, 1.0}, {80, 0.9, 0.5, 1.1}});
  for (std::size_t i = 200; i < samples.size(); ++i) samples[i].joint.teeth[1].leading.x = 500.0;
  CHECK(judge_teeth(samples, 2, kLength).failure == TeethFailure::together);
}

TEST_CASE("Two teeth off at the same sample: the first is the one that bore more") {
  CHECK(judged({{40, 0.8, 0.5, 1.0}, {80, 0.8, 0.5, 1.0}}).first == 1u);
  CHECK(judged({{80, 0.8, 0.5, 1.0}, {40, 0.8, 0.5, 1.0}}).first == 0u);
}

TEST_CASE("A tooth that never bore anything was not loaded with the first") {
  const TeethVerdict verdict = judged({{0, 0.8, 0.5, 1.2}, {80, 0.8, 0.5, 1.0}});
  CHECK(verdict.teeth[0].share_with_first == 0.0);
  CHECK(verdict.failure == TeethFailure::one_after_the_other);
}

TEST_CASE("The verdict's words are the enumerators' names") {
  CHECK(teeth_failure_name(TeethFailure::none) == "none");
  CHECK(teeth_failure_name(TeethFailure::some) == "some");
  CHECK(teeth_failure_name(TeethFailure::the_only_one) == "the_only_one");
  CHECK(teeth_failure_name(TeethFailure::one_after_the_other) == "one_after_the_other");
  CHECK(teeth_failure_name(TeethFailure::together) == "together");
}
