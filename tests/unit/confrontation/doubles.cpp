#include <catch2/catch.hpp>
#include <cmath>

#include "core/confrontation/conclusion.hpp"
#include "core/confrontation/known_confusions.hpp"
#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::VectorXd;

namespace {

constexpr Index kTruth = 0, kOther = 1, kAside = 2;
constexpr double kAmplitude = 0.8;
constexpr int kLaboratories = 12;

/// A laboratory in which one cause acts, and a second one whose effect is the first's, turned by an angle of this sine.
Evidence laboratory(double sine, std::uint64_t draw) {
  const toy::World world;
  toy::Hidden hidden = toy::nothing(world);
  hidden.amplitudes(kTruth) = kAmplitude;
  Evidence evidence = toy::evidence(world, hidden, draw);
  const toy::Directions d = toy::directions(world);
  const VectorXd turned = std::sqrt(1.0 - sine * sine) * d.fingerprint.col(kTruth) + sine * d.fingerprint.col(kAside);
  const VectorXd moved = 0.6 * (turned - d.fingerprint.col(kOther));
  for (std::size_t t = 0; t < evidence.tests.size(); ++t)
    evidence.tests[t].mechanism[kOther].rowwise() +=
        moved.segment(static_cast<Index>(t) * world.features, world.features).transpose();
  return evidence;
}

Conclusion concluded(const Evidence& evidence, double level = NamingOptions().level) {
  const Comparison comparison = compare(evidence, TestUse::fit);
  const Scatter scatter = scatter_of(comparison, {});
  const BaseFit base = calibrate_base(comparison, scatter.covariance, evidence.parameters);
  NamingOptions options;
  options.draws.draws = 200;
  options.level = level;
  options.near = 1e3;  // all are refitted
  const Gate found = gate(comparison, scatter, base, evidence.candidates, options.draws);
  const HypothesisMaker make = [&](const std::vector<std::vector<Index>>& lists) {
    std::vector<Hypothesis> hypotheses;
    for (const auto& causes : lists) hypotheses.push_back(linear_hypothesis(comparison, base, causes));
    return hypotheses;
  };
  return conclude(comparison, scatter, base, found, evidence.candidates, make, options);
}

const HypothesisFit* single(const Conclusion& c, Index cause) {
  for (const HypothesisFit& fit : c.singles) {
    if (fit.causes.front() == cause) return &fit;
  }
  return nullptr;
}

/// How often the truth was named, and became a tie where the other is known to be taken for it.
struct Counts {
  int named = 0, fits_by_itself = 0, ties = 0, still_named = 0;
};

Counts count(double sine) {
  Counts n;
  for (int draw = 0; draw < kLaboratories; ++draw) {
    Evidence evidence = laboratory(sine, static_cast<std::uint64_t>(draw));
    const Conclusion alone = concluded(evidence);
    const HypothesisFit* other = single(alone, kOther);
    if (alone.status != VerdictStatus::named || alone.kept.front().causes.front() != kTruth || !other) continue;
    evidence.candidates[kTruth].doubles = {evidence.candidates[kOther].id};
    const Conclusion together = concluded(evidence);
    ++n.named;
    n.fits_by_itself += other->p_misfit >= NamingOptions().level;
    n.ties += together.status == VerdictStatus::indistinguishable && together.kept.size() == 2;
    n.still_named += together.status == VerdictStatus::named && together.kept.front().causes.front() == kTruth;
  }
  return n;
}

}  // namespace

TEST_CASE("what is known to be taken for a cause is kept beside it where it fits by itself, and only there") {
  const Counts near = count(0.3);
  CAPTURE(near.named, near.fits_by_itself, near.ties, near.still_named);
  CHECK(near.named >= 4);
  CHECK(near.fits_by_itself >= 3);
  CHECK(near.ties == near.fits_by_itself);
  CHECK(near.still_named == near.named - near.ties);
  const Counts far = count(0.7);
  CAPTURE(far.named, far.fits_by_itself, far.ties, far.still_named);
  CHECK(far.named >= 4);
  CHECK(far.ties == far.fits_by_itself);
  CHECK(far.ties < far.named);
}

TEST_CASE("where the test was made that tells two apart, a fit that is worse by two standard deviations refutes") {
  int near = 0, far = 0;
  constexpr double kLevel = 0.2;  // at which a fit that is hardly worse is refuted, too
  for (const double sine : {0.2, 0.5}) {
    for (int draw = 0; draw < kLaboratories; ++draw) {
      Evidence evidence = laboratory(sine, static_cast<std::uint64_t>(draw));
      const Conclusion alone = concluded(evidence, kLevel);
      const HypothesisFit* other = single(alone, kOther);
      if (alone.status != VerdictStatus::named || alone.kept.front().causes.front() != kTruth || !other) continue;
      if (other->p_misfit < kLevel) continue;
      const bool is_near = other->misfit - alone.kept.front().misfit < 4.0;
      evidence.candidates[kTruth].tested_doubles = {evidence.candidates[kOther].id};
      const Conclusion tested = concluded(evidence, kLevel);
      CHECK(tested.status == (is_near ? VerdictStatus::indistinguishable : VerdictStatus::named));
      near += is_near;
      far += !is_near;
    }
  }
  CAPTURE(near, far);
  CHECK(far >= 3);
  CHECK(near >= 1);
}

TEST_CASE("doubles are those that were named for one another, either way") {
  const MeasuredData none;
  CHECK(doubles_of("strength_scatter", none) == std::vector<std::string>{"initial_defects", "weak_plane"});
  CHECK(doubles_of("weak_plane", none) == std::vector<std::string>{"strength_scatter"});
  CHECK(doubles_of("initial_defects", none) == std::vector<std::string>{"strength_scatter", "mesh_size"});
  CHECK(doubles_of("seating", none).empty());
}

TEST_CASE("doubles are none where the laboratory made the test that tells them apart") {
  using Names = std::vector<std::string>;
  MeasuredTest straight;
  straight.width_mm = 50.0;
  straight.height_mm = 100.0;
  MeasuredTest turned = straight, low = straight, small = straight, disc = straight;
  turned.preparation.core_angle_deg = 90.0;
  low.height_mm = 50.0;
  small.width_mm = 25.0;
  small.height_mm = 50.0;
  disc.experiment = ExperimentType::brazilian;
  disc.preparation.core_angle_deg = 90.0;
  const auto of = [&](const std::string& id, const MeasuredTest& other) {
    MeasuredData data;
    data.tests = {straight, other};
    return doubles_of(id, data);
  };
  CHECK(of("strength_scatter", low) == Names{"initial_defects", "weak_plane"});
  CHECK(of("strength_scatter", disc) == Names{"initial_defects", "weak_plane"});
  CHECK(of("strength_scatter", turned) == Names{"initial_defects"});
  CHECK(of("strength_scatter", small) == Names{"weak_plane"});
  CHECK(of("initial_defects", small).empty());
  MeasuredData both_sizes;
  both_sizes.tests = {straight, small};
  CHECK(tested_doubles_of("initial_defects", both_sizes) == Names{"strength_scatter", "mesh_size"});
  CHECK(tested_doubles_of("weak_plane", both_sizes).empty());
  MeasuredTest kept_back = turned, same_line = turned;
  kept_back.use = TestUse::hold_out;
  same_line.preparation.core_angle_deg = -90.0;
  CHECK(of("weak_plane", kept_back) == Names{"strength_scatter"});
  MeasuredData one_line;
  one_line.tests = {turned, same_line};
  CHECK(!is_made("rotated_core", one_line));
  CHECK(is_made("half_size", both_sizes));
  CHECK(!is_made("seating", both_sizes));
  CHECK(decides("rotated_core", "weak_plane", "strength_scatter"));
  CHECK(!decides("half_size", "weak_plane", "strength_scatter"));
  CHECK(decides("half_size", "initial_defects", "mesh_size"));
}
