#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <string>

#include "core/base/instruction_set.hpp"
#include "core/base/unit_exp.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

namespace {

const ParallelLoops kLoops;

/// A state that a path could have led to: opened, closed, hardened, damaged or handing its shear over.
PointState random_point(RandomStream& random, const LawParameters& law) {
  PointState s;
  const auto kind = random.below(4);
  s.normal = law.delta_ct * random.uniform(kind == 0 ? -1.0 : -0.2, kind == 3 ? 0.5 * law.kappa_ut : 0.6);
  s.hardening = random.uniform() * (kind == 0 ? 0.9 : 0.6);
  s.slip = law.delta_cs * random.uniform(-0.5, 0.5);
  s.shear = s.slip + law.delta_cs * random.uniform(-0.3, 0.3);
  if (kind >= 1) s.integrity_n = random.uniform(0.3, 1.0);
  if (kind >= 2) {
    s.integrity_s = random.uniform(0.3, 1.0);
    s.friction = (1.0 - s.integrity_s) * law.c_c * random.uniform(-0.2, 0.2);
  }
  if (kind == 3) s.damage = random.uniform(0.0, 0.95);
  s.fracture_energy = random.uniform();
  return s;
}

struct Trial {
  BondedContacts contacts;
  std::vector<Vec2> position;
};

/// Random states in all contacts of a mesh, every tenth contact with a broken point or two, at positions that give most
/// points another step of opening, closing or shear.
Trial random_trial(std::uint64_t seed) {
  RandomStream random(seed, "fast kernel");
  const System system = test::make_system(test::grid_mesh({7, 5}));
  Trial trial{system.contacts, system.particles.position};
  for (std::size_t c = 0; c < trial.contacts.size(); ++c) {
    std::array<PointState, 2> points{random_point(random, system.contacts.law),
                                     random_point(random, system.contacts.law)};
    for (PointState& s : points) {
      if (random.below(20) == 0) s.broken = random.below(2) ? BreakMode::shear : BreakMode::tension;
    }
    trial.contacts.set_points(c, points);
  }
  const double reach = 2.0 * system.contacts.law.delta_ct;
  for (Vec2& x : trial.position) {
    x = test::turned(x, 0.4) + Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)};
  }
  if (seed % 3 == 0) trial.contacts.law.kappa_us = 6.0;  // shear softens
  trial.contacts.hand_over_range = seed % 2 ? kHandOverRange : 0.0;
  return trial;
}

/// Differences over the size that each field has in this model.
double difference(const PointState& a, const PointState& b, const LawParameters& p) {
  const double stress = p.c_c + p.t_c, energy = stress * p.delta_ut;
  double worst = 0.0;
  const auto compare = [&](double x, double y, double size) { worst = std::max(worst, std::abs(x - y) / size); };
  compare(a.normal, b.normal, p.delta_ct);
  compare(a.shear, b.shear, p.delta_cs);
  compare(a.slip, b.slip, p.delta_cs);
  compare(a.hardening, b.hardening, 1.0);
  compare(a.integrity_n, b.integrity_n, 1.0);
  compare(a.integrity_s, b.integrity_s, 1.0);
  compare(a.friction, b.friction, stress);
  compare(a.damage, b.damage, 1.0);
  compare(a.fracture_energy, b.fracture_energy, energy);
  compare(a.traction_n, b.traction_n, stress);
  compare(a.traction_s, b.traction_s, stress);
  return worst;
}

/// What makes a trial's contacts differ from the base law's, by bits.
constexpr unsigned kStrengths = 1, kEnvelope = 2, kClosure = 4;

/// A random trial whose contacts have what the bits say: Eqs. (C57), (D10), (D11).
Trial varied_trial(std::uint64_t seed, unsigned variation) {
  Trial trial = random_trial(seed);
  RandomStream random(seed, "varied kernel");
  if (variation & kStrengths) {
    std::vector<double> factors(trial.contacts.size());
    for (double& factor : factors) factor = random.uniform(0.4, 1.8);
    set_strengths(trial.contacts, factors);
  }
  if (variation & kEnvelope) {
    trial.contacts.law.envelope_exponent = 0.6;
    trial.contacts.law.tan_phi_peak *= 1.3;
  }
  if (variation & kClosure) {
    trial.contacts.law.closure_share = 0.7;
    trial.contacts.law.closure_length = 0.5 * trial.contacts.law.delta_ct;
  }
  return trial;
}

/// Both kernels on the same trials, and what was tried.
struct Comparison {
  double state = 0, force = 0, energy = 0;
  int broke = 0, with_record = 0, softening = 0;

  void add(Trial fast, Trial reference) {
    const LawParameters& law = fast.contacts.law;
    std::vector<Vec2> fast_forces(2 * fast.contacts.slot_count()), forces(fast_forces);
    with_record += static_cast<int>(fast.contacts.broken.size());
    const std::size_t before = fast.contacts.broken.size();
    const int changes = update_contacts(fast.contacts, fast.position, 1.0, kLoops, fast_forces, Kernel::fast);
    CHECK(update_contacts(reference.contacts, reference.position, 1.0, kLoops, forces, Kernel::reference) == changes);
    REQUIRE(fast.contacts.broken_index == reference.contacts.broken_index);
    broke += static_cast<int>(fast.contacts.broken.size() - before);
    for (std::size_t c = 0; c < fast.contacts.size(); ++c) {
      const auto a = fast.contacts.points(c), b = reference.contacts.points(c);
      for (std::size_t q = 0; q < 2; ++q) {
        REQUIRE(a[q].broken == b[q].broken);
        softening += a[q].damage > 0.0 && a[q].damage < 1.0;
        state = std::max(state, difference(a[q], b[q], law));
      }
      const double spent = a[0].friction_energy - b[0].friction_energy;
      energy = std::max(energy, std::abs(spent) / (law.c_c * law.delta_ut));
    }
    const double size = (law.t_c + law.c_c) * 2.0;
    for (std::size_t i = 0; i < 2 * contact_slot_count(fast.contacts.size()); ++i) {
      if (contact_of_slot(i / 2) >= fast.contacts.size()) continue;
      force = std::max(force, norm(fast_forces[i] - forces[i]) / size);
    }
  }

  void check(const std::string& name) const {
    WARN(name << ": states " << state << ", forces " << force << ", friction energy " << energy << "; " << broke
              << " edges broke, " << with_record << " were broken, " << softening << " points soften");
    CHECK(state < 1e-12);
    CHECK(force < 1e-12);
    CHECK(energy < 1e-12);
    CHECK(broke > 50);  // otherwise nothing was tried
    CHECK(with_record > 1000);
    CHECK(softening > 1000);
  }
};

/// Everything the fast kernel writes of contacts; what it writes into the last register's other lanes is nobody's. To
/// be compared by value: whether friction that has become nothing is 0 or -0 depends on a register's other lanes.
std::vector<double> after_update(Trial trial) {
  std::vector<Vec2> forces(2 * trial.contacts.slot_count());
  update_contacts(trial.contacts, trial.position, 1.0, kLoops, forces, Kernel::fast);
  std::vector<double> all;
  for (std::size_t c = 0; c < trial.contacts.size(); ++c) {
    for (const PointState& s : trial.contacts.memory.load(c)) {
      all.insert(all.end(), {s.normal, s.shear, s.slip, s.hardening, s.integrity_n, s.integrity_s, s.friction, s.damage,
                             s.fracture_energy, s.friction_energy});
    }
    for (const ContactNode node : {ContactNode::left1, ContactNode::left2, ContactNode::right1, ContactNode::right2}) {
      all.insert(all.end(), {forces[force_index(c, node)].x, forces[force_index(c, node)].y});
    }
  }
  return all;
}

}  // namespace

TEST_CASE("the polynomial for exp(-x) on [0, 1] errs by less than 8e-16") {
  double worst = 0.0;
  for (int i = 0; i <= 1000000; ++i) {
    const long double x = i * 1e-6L;
    const long double exact = std::exp(-static_cast<long double>(static_cast<double>(x)));
    worst = std::max(worst, static_cast<double>(std::abs((unit_exp(static_cast<double>(x)) - exact) / exact)));
  }
  WARN("exp(-x) on [0, 1]: largest relative error " << worst);
  CHECK(worst < 8e-16);
}

TEST_CASE("the fast contact kernel does what the reference does, to rounding, on random states and broken contacts") {
  Comparison comparison;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) comparison.add(random_trial(seed), random_trial(seed));
  comparison.check("fast kernel against the reference");
}

TEST_CASE("the varied kernel does what the reference does, to rounding: strengths, envelope, closure, all together") {
  for (const unsigned variation : {kStrengths, kEnvelope, kClosure, kStrengths | kEnvelope | kClosure}) {
    Comparison comparison;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
      comparison.add(varied_trial(seed, variation), varied_trial(seed, variation));
    }
    comparison.check("varied kernel " + std::to_string(variation) + " against the reference");
  }
}

TEST_CASE("the varied kernel gives the same on every instruction set, and those of the base for factors of 1") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Trial varied = varied_trial(seed, kStrengths | kEnvelope | kClosure);
    const std::vector<double> best = after_update(varied);
    for (const InstructionSet& set : instruction_sets()) {
      const ForcedInstructionSet forced(set);
      INFO(set.name);
      CHECK(after_update(varied) == best);
    }
    Trial ones = random_trial(seed);
    const std::vector<double> base = after_update(ones);
    CHECK_FALSE(base == best);
    set_strengths(ones.contacts, std::vector<double>(ones.contacts.size(), 1.0));
    CHECK(after_update(ones) == base);
  }
}
