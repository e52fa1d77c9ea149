#include <catch2/catch.hpp>

#include "tests/unit/experiment/boundary_runs.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

RunConfig tilted(double degrees, std::optional<double> offset = std::nullopt) {
  RunConfig c = weak_column();
  c.extensions.tilt_deg = degrees;
  c.extensions.hinge_offset_mm = offset;
  return c;
}

/// Stress at the first sample of at least this strain, MPa.
double stress_at(const BoundaryRun& run, double strain) {
  for (const Sample& s : run.state.samples) {
    if (s.axial_strain >= strain) return s.stress_mpa;
  }
  return 0.0;
}

/// Mean shortening of the left half less that of the right one between the ends, over the specimen's height.
double bending(const Model& model) {
  const Particles& p = model.system.particles;
  double sum = 0.0, count = 0.0;
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    if (p.reference(i).y < 64.9) continue;
    sum += (p.reference(i).y - p.position[i].y) * (p.reference(i).x < 0.0 ? 1.0 : -1.0);
    count += 0.5;
  }
  return sum / count;
}

}  // namespace

TEST_CASE("a tilted platen begins where it touches the specimen's highest corner") {
  for (const double degrees : {0.5, -0.5}) {
    const Model model = small_model(tilted(degrees));
    const double slope = std::tan(0.5 * std::acos(-1.0) / 180.0);
    CHECK(std::abs(model.system.platens.upper.slope) == Approx(slope).epsilon(1e-12));
    CHECK(model.system.platens.y[1] == Approx(65.0 + 13.5 * slope).epsilon(1e-12));
    CHECK(model.system.platens.upper.inertia == 0.0);
  }
  const Model hinged = small_model(tilted(0.5, 4.0));  // the left corner is 17.5 mm from the hinge
  CHECK(hinged.system.platens.y[1] == Approx(65.0 + 17.5 * hinged.system.platens.upper.slope).epsilon(1e-12));
  CHECK(hinged.system.platens.upper.inertia > 0.0);
}

TEST_CASE("a tilted platen strains one side more, keeps the specimen in place and the account closed") {
  const BoundaryRun base = run_of(weak_column()), run = run_of(tilted(0.3));
  const auto& moved = run.model.system.particles;
  double aside = 0.0;
  for (std::size_t i = 0; i < moved.node_count(); ++i) {
    aside += (moved.position[i].x - moved.reference(i).x) / static_cast<double>(moved.node_count());
  }
  WARN("at 0.002 " << stress_at(base, 0.002) << " level, " << stress_at(run, 0.002) << " MPa tilted; energy error "
                   << run.energy_error() << "; moved aside by " << aside << " mm");
  CHECK(stress_at(run, 0.002) < 0.7 * stress_at(base, 0.002));  // a toe while the face comes to lie on the end
  CHECK(bending(run.model) > 0.02);
  CHECK(std::abs(aside) < 1.0);
  CHECK(run.energy_error() < 1e-3);
}

TEST_CASE("tilts to the left and to the right by the same angle load different corners") {
  RunConfig left = tilted(0.3), right = tilted(-0.3);
  left.experiment.stop.axial_strain = right.experiment.stop.axial_strain = 0.006;
  CHECK(bending(run_of(left).model) > 0.01);
  CHECK(bending(run_of(right).model) < -0.01);
}

TEST_CASE("a hinged platen lies down on the end, and beside the axis it leans to the loaded side") {
  RunConfig centred = tilted(0.3, 1e-9), beside = tilted(0.0, 5.0);
  centred.experiment.stop.axial_strain = beside.experiment.stop.axial_strain = 0.008;
  const BoundaryRun lies = run_of(centred), leans = run_of(beside);
  WARN("slope left of 0.0052: " << lies.model.system.platens.upper.slope << "; beside the axis "
                                << leans.model.system.platens.upper.slope << "; energy errors " << lies.energy_error()
                                << ", " << leans.energy_error());
  CHECK(std::abs(lies.model.system.platens.upper.slope) < 0.0015);
  CHECK(leans.model.system.platens.upper.slope < -0.001);  // the right side is pressed down
  CHECK(lies.energy_error() < 1e-3);
  CHECK(leans.energy_error() < 1e-3);
}

TEST_CASE("under a tilted or hinged platen a run broken off and resumed ends with the same bytes") {
  CHECK(resumes_to_the_same_bytes(tilted(0.2), 1500));
  CHECK(resumes_to_the_same_bytes(tilted(0.2, 3.0), 1500));
}
