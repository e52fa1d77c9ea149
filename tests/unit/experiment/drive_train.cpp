#include "core/experiment/drive_train.hpp"

#include <catch2/catch.hpp>
#include <numbers>

#include "tests/unit/experiment/boundary_runs.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

/// The drive, the platens and the load at one sample.
struct Row {
  double drive_mm, platens_mm, load;
};

/// Rows of a run behind a train; load and places are those of the sample's instant.
std::vector<Row> rows_of(const RunConfig& config) {
  BoundaryRun run(config);
  std::vector<Row> rows;
  RunObserver observer;
  observer.on_sample = [&](const Sample& s) {
    const System& system = run.model.system;
    const double distance = system.platens.y[1] - system.platens.y[0];
    rows.push_back({s.closure_mm, run.state.loading.zero_distance_mm - distance,
                    0.5 * (system.sums.reaction[0] + system.sums.reaction[1])});
  };
  run_experiment(run.model, run.state, ParallelLoops(), observer);
  return rows;
}

/// Least-squares slope of a place over the load, mm per N/mm, between two loads.
double compliance(const std::vector<Row>& rows, double Row::*place, double low, double high) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const Row& r : rows) {
    if (r.load < low || r.load > high) continue;
    n += 1, x += r.load, y += r.*place, xx += r.load * r.load, xy += r.load * r.*place;
  }
  REQUIRE(n > 20);
  return (n * xy - x * y) / (n * xx - x * x);
}

/// Strong and slow, up to a load well below the peak.
RunConfig slow_column() {
  RunConfig c = small_config(ExperimentType::uniaxial);
  c.experiment.plane = PlaneCondition::stress;
  c.experiment.loading.closing_rate_mm_per_s = 60;
  c.experiment.stop.axial_strain = 0.012;
  return c;
}

constexpr double kArea = 27.0;        // mm2 per mm of thickness
constexpr double kStiffness = 500.0;  // N/mm per mm: about the specimen's

double nominal_closing(double load, double seating, double half) { return seating * load / (load + half); }

}  // namespace

TEST_CASE("a compliant frame is a spring in series with the specimen before the peak") {
  RunConfig base = slow_column(), framed = base;
  framed.extensions.frame_stiffness_n_per_mm = kStiffness;
  const auto bare = rows_of(base), behind = rows_of(framed);
  const double low = 2.0 * kArea, high = 5.0 * kArea;
  const double specimen = compliance(bare, &Row::platens_mm, low, high);
  const double both = compliance(behind, &Row::drive_mm, low, high);
  const double exact = specimen + 1.0 / kStiffness;
  WARN("compliance of specimen " << specimen << ", with frame " << both << " mm/(N/mm), over the exact series "
                                 << both / exact - 1.0);
  CHECK(both == Approx(exact).epsilon(1e-3));
  CHECK(compliance(behind, &Row::platens_mm, low, high) == Approx(specimen).epsilon(1e-3));
}

TEST_CASE("the frame's stiffness counts for the specimen's thickness, and its train is shared by both platens") {
  RunConfig c = weak_column();
  c.experiment.thickness_mm = 4.0;
  c.extensions.frame_stiffness_n_per_mm = 1000.0;
  c.extensions.seating_mm = 0.1;
  c.extensions.seating_stress_mpa = 2.0;
  const Model model = small_model(c);
  for (const DriveLine& line : model.system.lines) {
    CHECK(line.stiffness == 2.0 * 250.0);
    CHECK(line.seating == 0.05);
    CHECK(line.half_load == 2.0 * kArea);
    CHECK(line.mass > 0.0);
  }
  RunConfig disc = weak_disc();
  disc.extensions.seating_mm = 0.1;
  const Model second = small_model(disc);
  CHECK(second.system.lines[0].half_load == Approx(0.5 * std::numbers::pi * disc.experiment.diameter_mm));
  CHECK(second.system.lines[0].stiffness > 0.0);
  CHECK(small_model(weak_column()).system.lines[0].stiffness == 0.0);
}

TEST_CASE("seats follow their curve at first loading and are gone on reloading") {
  RunConfig c = slow_column();
  c.extensions.seating_mm = 0.1;
  c.extensions.seating_stress_mpa = 1.0;
  c.extensions.frame_stiffness_n_per_mm = 5000.0;
  c.experiment.loading.unloading = {{0.4, 0.1}};
  const auto rows = rows_of(c);
  double highest = 0.0, worst = 0.0, least_on_reload = 1e9;
  for (const Row& r : rows) {
    highest = std::max(highest, r.load);
    const double train = r.drive_mm - r.platens_mm;
    const double exact = r.load / 5000.0 + nominal_closing(highest, 0.1, kArea);
    if (r.load > 0.2 * kArea) worst = std::max(worst, std::abs(train - exact));
    if (r.load < 0.98 * highest) least_on_reload = std::min(least_on_reload, r.load);
  }
  WARN("largest deviation from the exact curve " << worst << " mm, of 0.1; unloaded to " << least_on_reload / highest);
  CHECK(worst < 1e-3);
  CHECK(least_on_reload < 0.2 * highest);  // there was a loop
}

TEST_CASE("what the train stores stays outside: the account of a specimen that fails behind it is closed") {
  for (const ExperimentType type : {ExperimentType::uniaxial, ExperimentType::triaxial, ExperimentType::brazilian}) {
    RunConfig c = type == ExperimentType::brazilian ? weak_disc() : weak_column(type);
    c.extensions.frame_stiffness_n_per_mm = 300.0;
    c.extensions.seating_mm = 0.02;
    c.experiment.stop.axial_strain = 0.03;
    const BoundaryRun run = run_of(c);
    WARN("energy error " << run.energy_error() << ", cracks " << run.state.samples.back().cracks_shear << ", steps "
                         << run.model.system.step);
    CHECK(run.energy_error() < 1e-3);
    CHECK(run.state.samples.back().cracks_shear + run.state.samples.back().cracks_tension > 0);
  }
}

TEST_CASE("a train is tied under the confining load, without a jump") {
  RunConfig c = weak_column(ExperimentType::triaxial);
  c.extensions.frame_stiffness_n_per_mm = 500.0;
  const BoundaryRun run = run_of(c);
  const double pressure = c.experiment.confining_pressure_mpa;
  for (const DriveLine& line : run.model.system.lines) {
    CHECK(line.tied == 1);
    CHECK(line.preload == Approx(pressure * kArea).epsilon(0.01));
  }
  CHECK(run.state.samples.front().stress_mpa == Approx(pressure).epsilon(0.05));
  CHECK(run.state.samples.front().closure_mm < 1e-3);
  CHECK(run.state.samples.back().axial_strain >= c.experiment.stop.axial_strain);
}

TEST_CASE("a joint behind a compliant frame: the drive leads the block by the line's force") {
  RunConfig c = sliding_joint(0.4);
  c.extensions.frame_stiffness_n_per_mm = 400.0;
  const BoundaryRun run = run_of(c);
  const RigidBlock& lower = run.model.system.blocks[kLowerBlock];
  const Sample& last = run.state.samples.back();
  const double lag = last.closure_mm - lower.displacement.x;
  WARN("drive " << last.closure_mm << ", block " << lower.displacement.x << ", lag times K over load "
                << lag * 400.0 / last.load_n_per_mm << ", energy error " << run.energy_error());
  CHECK(lag * 400.0 == Approx(last.load_n_per_mm - run.state.samples.front().load_n_per_mm)
                           .epsilon(0.01));  // the load is a mean over the sample
  CHECK(run.energy_error() < 5e-3);
}

TEST_CASE("behind a train a run broken off and resumed ends with the same bytes, with any number of threads") {
  RunConfig c = weak_column();
  c.extensions.frame_stiffness_n_per_mm = 300.0;
  c.extensions.seating_mm = 0.05;
  c.experiment.loading.unloading = {{0.3, 0.2}};
  CHECK(resumes_to_the_same_bytes(c, 1500));
  RunConfig joint = sliding_joint(0.3);
  joint.extensions.frame_stiffness_n_per_mm = 300.0;
  joint.extensions.seating_mm = 0.05;
  CHECK(resumes_to_the_same_bytes(joint, 6000));
}
