#include <catch2/catch.hpp>

#include "tests/unit/experiment/boundary_runs.hpp"

using namespace asperity;
using namespace asperity::testing;

namespace {

double dilation_at_end(const BoundaryRun& run) { return run.state.samples.back().joint.dilation.mean; }

/// The positions after so many steps.
std::vector<Vec2> positions_after(const RunConfig& config, std::int64_t steps) {
  BoundaryRun run(config);
  step_until(run.model, run.state.loading, [&] { return run.model.system.step == steps; });
  return run.model.system.particles.position;
}

}  // namespace

TEST_CASE("the normal load follows the dilation by its spring, down to a fixed height") {
  const BoundaryRun free = run_of(sliding_joint(1.0));
  REQUIRE(dilation_at_end(free) > 0.2);
  for (const double stiffness : {2.0, 1e5}) {
    RunConfig c = sliding_joint(1.0);
    c.extensions.normal_stiffness_mpa_per_mm = stiffness;
    if (stiffness == 1e5) c.experiment.stop.shear_displacement_mm = 0.05;  // the flanks bear what the height forbids
    const BoundaryRun run = run_of(c);
    const RigidBlock& upper = run.model.system.blocks[kUpperBlock];
    const double length = run.model.joint.profile.length(), rise = dilation_at_end(run);
    WARN("K_n " << stiffness << ": dilation " << rise << " mm, free " << dilation_at_end(free) << "; normal stress "
                << run.state.samples.back().joint.normal_stress_mpa << " MPa; energy error " << run.energy_error());
    CHECK(upper.load == Approx(-length * (1.0 + stiffness * rise)).epsilon(1e-9));
    CHECK(run.energy_error() < 5e-3);
    if (stiffness == 1e5) CHECK(std::abs(rise) < 0.01 * dilation_at_end(free));
    if (stiffness == 2.0) CHECK(rise < 0.995 * dilation_at_end(free));
  }
}

TEST_CASE("a block that may turn against a stiff spring is the base") {
  RunConfig c = sliding_joint(0.3);
  c.integration.local_damping = 0.0;  // its changes of sign would magnify rounding
  const Model fresh = small_model(c);
  const std::vector<Vec2> base = positions_after(c, 1500);
  c.extensions.rotation_stiffness_n_mm_per_rad = 1e12;
  const std::vector<Vec2> turned = positions_after(c, 1500);
  double moved = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < base.size(); ++i) {
    moved = std::max(moved, norm(base[i] - fresh.system.particles.reference(i)));
    apart = std::max(apart, norm(base[i] - turned[i]));
  }
  WARN("1e12: positions within " << apart / moved << " of the largest displacement, " << moved << " mm");
  CHECK(apart < 1e-6 * moved);
  const BoundaryRun run = run_of(c);
  CHECK(std::abs(run.model.system.blocks[kUpperBlock].turn.angle) < 1e-9);
}

TEST_CASE("a block that turns freely dilates differently at its ends") {
  RunConfig soft = small_joint();
  soft.experiment.stop.shear_displacement_mm = 1.0;
  soft.extensions.rotation_stiffness_n_mm_per_rad = 2000.0;
  const BoundaryRun loose = run_of(soft);
  const DilationReading dilation = loose.state.samples.back().joint.dilation;
  const RigidBlock& upper = loose.model.system.blocks[kUpperBlock];
  const double length = loose.model.joint.profile.length();
  WARN("2000: angle " << upper.turn.angle << " rad, front " << dilation.front << ", rear " << dilation.rear
                      << " mm; energy error " << loose.energy_error());
  CHECK(std::abs(upper.turn.angle) > 1e-3);
  CHECK(std::abs(dilation.front - dilation.rear) > 0.9 * length * std::abs(upper.turn.angle));
  CHECK(loose.energy_error() < 5e-3);
}

TEST_CASE("the nodes of a block that turns stay on a rigid body") {
  RunConfig c = small_joint();
  c.experiment.stop.shear_displacement_mm = 0.5;
  c.extensions.rotation_stiffness_n_mm_per_rad = 2000.0;
  const BoundaryRun run = run_of(c);
  const RigidBlock& block = run.model.system.blocks[kUpperBlock];
  const Particles& p = run.model.system.particles;
  const Vec2 middle = Vec2{0.5 * run.model.joint.profile.length(), 6.0} + block.displacement;
  double worst = 0.0;
  for (std::size_t i = 0; i < block.nodes.size(); ++i) {
    const double x = block.turn.arms[i].x;
    const Vec2 at = middle + Vec2{std::cos(block.turn.angle) * x, std::sin(block.turn.angle) * x};
    worst = std::max(worst, norm(p.position[block.nodes[i]] - at));
  }
  INFO("farthest node " << worst << " mm");
  CHECK(std::abs(block.turn.angle) > 1e-4);
  CHECK(worst < 1e-9);
}

TEST_CASE("halves that do not mate begin lifted, mate while they are sheared, and lag behind those that do") {
  RunConfig c = sliding_joint(0.6);
  const BoundaryRun base = run_of(c);
  c.extensions.mismatch_mm = 0.3;
  const BoundaryRun run = run_of(c);
  const auto at = [](const BoundaryRun& r, double u) {
    for (const Sample& s : r.state.samples) {
      if (s.closure_mm >= u) return s;
    }
    return r.state.samples.back();
  };
  const double tan_i = std::tan(20.0 * std::acos(-1.0) / 180.0);
  const Sample seated = at(run, 0.3), early = at(base, 0.3);
  WARN("dilation when mated " << seated.joint.dilation.mean << " mm, lift " << 0.3 * tan_i << "; stress there "
                              << seated.stress_mpa << " against " << early.stress_mpa << "; energy error "
                              << run.energy_error());
  CHECK(run.model.joint.gauge.strips.upper_shift == Vec2{0.3, mismatch_lift(run.model.joint.profile, 0.3)});
  CHECK(seated.joint.dilation.mean == Approx(-0.3 * tan_i).epsilon(0.1));
  CHECK(seated.stress_mpa < 0.8 * early.stress_mpa);
  CHECK(run.energy_error() < 5e-3);
}

TEST_CASE("a gap beyond half the joint is refused") {
  RunConfig c = sliding_joint(0.6);
  c.extensions.mismatch_mm = 9.0;
  CHECK_THROWS_AS(small_model(c), Error);
}

TEST_CASE("strips are one block each way, and never meet") {
  RunConfig c = small_joint();
  c.experiment.stop.shear_displacement_mm = 1.0;
  c.extensions.strips = 2;
  const BoundaryRun run = run_of(c);
  const System& system = run.model.system;
  const Sample& last = run.state.samples.back();
  CHECK(system.blocks.size() == 2);
  CHECK(run.energy_error() < 5e-3);
  CHECK(system.blocks[kUpperBlock].load == Approx(-2.0 * run.model.joint.profile.length()).epsilon(1e-12));
  CHECK(last.joint.normal_stress_mpa == Approx(1.0).epsilon(0.2));
  for (const int node : system.blocks[kUpperBlock].nodes) {
    CHECK(system.particles.velocity[node] == system.blocks[kUpperBlock].velocity);
  }
  const JointGauge& gauge = run.model.joint.gauge;  // no pair across strips was ever found
  REQUIRE(!system.general.pairs.empty());
  for (const MemberPair& pair : system.general.pairs) {
    CHECK(gauge.strips.of(system.general.members[pair.a].triangle) ==
          gauge.strips.of(system.general.members[pair.b].triangle));
  }
  CHECK(last.energy.external_work > 0.0);
  double attached = 0.0;
  for (const ToothReading& tooth : last.joint.teeth) attached = std::max(attached, tooth.attached_share);
  CHECK(attached <= 1.0 + 1e-12);
  WARN("two strips: energy error " << run.energy_error() << ", work " << last.energy.external_work);
}

TEST_CASE("mean over strips: the elastic response of three strips is that of one") {
  RunConfig c = small_joint();
  c.experiment.stop.shear_displacement_mm = 0.02;
  const BoundaryRun one = run_of(c);
  c.extensions.strips = 3;
  const BoundaryRun three = run_of(c);
  const Sample &a = one.state.samples.back(), &b = three.state.samples.back();
  WARN("shear stress " << a.stress_mpa << " one, " << b.stress_mpa << " MPa three; work " << a.energy.external_work
                       << ", " << b.energy.external_work);
  CHECK(b.stress_mpa == Approx(a.stress_mpa).epsilon(0.1));
  CHECK(b.energy.external_work == Approx(a.energy.external_work).epsilon(0.1));
}

TEST_CASE("neutral values are the base to the byte") {
  RunConfig c = small_joint();
  c.experiment.stop.shear_displacement_mm = 0.3;
  const BoundaryRun base = run_of(c);
  c.mechanisms = {{"joint_mismatch", std::nullopt, {{"gap_mm", 0.0}}},
                  {"normal_stiffness", std::nullopt, {{"normal_stiffness_mpa_per_mm", 0.0}}},
                  {"out_of_plane_strips", std::nullopt, {{"strips", 1.0}}},
                  {"block_rotation", 0.0, {}},
                  {"seating", std::nullopt, {{"seating_mm", 0.0}}},
                  {"frame_compliance", 0.0, {}}};
  CHECK(same_bits(base, run_of(c)));
  RunConfig column = weak_column();
  column.experiment.stop.axial_strain = 0.008;
  const BoundaryRun level = run_of(column);
  column.mechanisms = {{"eccentric_load", std::nullopt, {{"tilt_deg", 0.0}, {"offset_mm", 0.0}}},
                       {"seating", std::nullopt, {{"seating_mm", 0.0}}},
                       {"frame_compliance", 0.0, {}}};
  CHECK(same_bits(level, run_of(column)));
}

TEST_CASE("a joint with all of it, broken off and resumed, ends with the same bytes, with any number of threads") {
  RunConfig c = small_joint();
  c.experiment.stop.shear_displacement_mm = 0.5;
  c.extensions.strips = 2;
  c.extensions.mismatch_mm = 0.2;
  c.extensions.rotation_stiffness_n_mm_per_rad = 5000.0;
  c.extensions.normal_stiffness_mpa_per_mm = 0.5;
  c.extensions.frame_stiffness_n_per_mm = 400.0;
  CHECK(resumes_to_the_same_bytes(c, 3000));
}
