#include "app/run_frames.hpp"

#include <catch2/catch.hpp>

using namespace asperity::app;

namespace {

/// Frames every 0.5 mm, with a curve that peaks at 2 mm, falls from 3 to 3.3 mm and ends at 12 mm.
struct Course {
  std::vector<double> x, stress;
  std::vector<RunFrame> frames;
  Course() {
    for (int i = 0; i <= 120; ++i) {
      const double u = 0.1 * i;
      x.push_back(u);
      stress.push_back(u <= 2 ? u : u <= 3 ? 2 - 0.1 * (u - 2) : u <= 3.3 ? 1.9 - 3 * (u - 3) : 1);
      if (i % 5 == 0) frames.push_back({i / 5, static_cast<std::size_t>(i), u, stress.back()});
    }
  }
};

std::vector<double> places(const std::vector<RunFrame>& frames) {
  std::vector<double> all;
  for (const RunFrame& frame : frames) all.push_back(frame.abscissa);
  return all;
}

}  // namespace

TEST_CASE("Five frames tell a run: half way up, the peak, behind the largest fall, half way on, the end") {
  const Course c;
  const std::vector<double> chosen = places(telling_frames(c.frames, c.x, c.stress));
  REQUIRE(chosen.size() == 5);
  CHECK(chosen[0] == Approx(1.0));
  CHECK(chosen[1] == Approx(2.0));
  CHECK(chosen[2] == Approx(3.5));  // the fall ends at 3.3
  CHECK(chosen[3] == Approx(7.5));  // 0.5 (3.3 + 12) = 7.65
  CHECK(chosen[4] == Approx(12.0));
}

TEST_CASE("A frame is shown once, and all are where there are no more than five") {
  Course c;
  c.frames.resize(6);
  const std::vector<double> chosen = places(telling_frames(c.frames, c.x, c.stress));
  CHECK(chosen.size() == 5);
  for (std::size_t i = 1; i < chosen.size(); ++i) CHECK(chosen[i] > chosen[i - 1]);
  c.frames.resize(3);
  CHECK(telling_frames(c.frames, c.x, c.stress).size() == 3);
}
