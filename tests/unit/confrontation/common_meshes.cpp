#include <catch2/catch.hpp>

#include "core/confrontation/gate.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::MatrixXd;

namespace {

/// Nothing is hidden, and a mechanism changes the order of breakage, so that its runs have nothing in common with the
/// base's on the same meshes: all that its fingerprint has of the common meshes is what chance made of the base there.
Evidence chaotic(const toy::World& world, Index apart, std::uint64_t draw) {
  Evidence evidence = toy::evidence(world, toy::nothing(world), draw);
  RandomStream random(draw, "chaotic runs");
  for (TestEvidence& test : evidence.tests) {
    test.apart = apart;
    for (Samples& runs : test.mechanism) runs = toy::scatter(world, world.common, random);
  }
  return evidence;
}

struct Alarms {
  int at_one = 0, at_five = 0;  ///< Laboratories with an alarm at the level 0.01, and at 0.05.
  double mean_p = 0;
};

Alarms alarms(const toy::World& world, Index apart) {
  constexpr int kLaboratories = 60;
  Alarms a;
  for (std::uint64_t draw = 0; draw < kLaboratories; ++draw) {
    const Evidence evidence = chaotic(world, apart, draw);
    const Comparison comparison = compare(evidence, TestUse::fit, BaseMean::apart);
    const Scatter scatter = scatter_of(comparison, {});
    const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
    GateOptions options;
    options.draws = 200;
    const double p = gate(comparison, scatter, base, evidence.candidates, options).p_explained;
    a.at_one += p < 0.01;
    a.at_five += p < 0.05;
    a.mean_p += p / kLaboratories;
  }
  return a;
}

}  // namespace

TEST_CASE("chance in the base's runs on common meshes is no discrepancy") {
  toy::World world;
  world.candidates = 20;
  const Alarms together = alarms(world, 0);
  world.meshes += world.common;
  const Alarms apart = alarms(world, world.common);
  CAPTURE(apart.at_one, apart.at_five, apart.mean_p, together.at_one, together.at_five, together.mean_p);
  CHECK(apart.at_one <= 2);
  CHECK(apart.at_five <= 6);
  CHECK(apart.mean_p > 0.4);
  CHECK(together.at_five > 15);
  CHECK(together.mean_p < 0.25);
}

TEST_CASE("apart from effects the base's mean is that of the other rows") {
  const toy::World world;
  Evidence evidence = toy::evidence(world, toy::nothing(world), 1);
  for (TestEvidence& test : evidence.tests) test.apart = world.common;
  const Comparison c = compare(evidence, TestUse::fit, BaseMean::apart), all = compare(evidence, TestUse::fit);
  const MatrixXd others = evidence.tests[0].base.bottomRows(world.meshes - world.common);
  CHECK((c.model.head(world.features) - others.colwise().mean().transpose()).norm() == Approx(0.0).margin(1e-12));
  CHECK((all.model.head(world.features) - evidence.tests[0].base.colwise().mean().transpose()).norm() ==
        Approx(0.0).margin(1e-12));
  CHECK((c.meshes.array() == static_cast<double>(world.meshes - world.common)).all());
  CHECK((all.meshes.array() == static_cast<double>(world.meshes)).all());
  CHECK(c.fingerprint == all.fingerprint);
  CHECK(c.tests.front().meshes.rows() == world.meshes);
  const MatrixXd change = evidence.tests[0].mechanism[0] - evidence.tests[0].base.topRows(world.common);
  CHECK((0.6 * c.fingerprint.col(0).head(world.features) - change.colwise().mean().transpose()).norm() ==
        Approx(0.0).margin(1e-12));
}
