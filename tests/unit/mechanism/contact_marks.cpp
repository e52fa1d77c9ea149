#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "core/base/units.hpp"
#include "core/mechanism/mechanism.hpp"
#include "tests/support/models.hpp"

using namespace asperity;

/// What mechanisms do to single contacts: X9 to X12.
namespace {

constexpr double kWidth = 80, kHeight = 60;  // mm

struct Marked {
  Particles particles;
  BondedContacts contacts;
};

/// Some 3500 contacts of a jittered grid, marked by mechanisms.
Marked marked(const std::vector<MechanismConfig>& mechanisms, LawReading reading = LawReading::consistent,
              std::uint64_t seed = 1) {
  RunConfig config = test::plaster();
  config.particles.seed = seed;
  config.mechanisms = mechanisms;
  const Mesh mesh = test::grid_mesh({40, 30});
  Marked result;
  result.particles = make_particles(mesh, config.particles, config.experiment.plane);
  result.contacts = make_contacts(mesh, result.particles, law_parameters(config), reading);
  mark_contacts(config, mesh, result.particles, result.contacts);
  return result;
}

std::vector<double> strengths(const BondedContacts& contacts) {
  std::vector<double> factors;
  for (std::size_t c = 0; c < contacts.size(); ++c) factors.push_back(contacts.strength(c));
  return factors;
}

/// sqrt(n) times the largest distance of the sample's distribution from a Weibull law of modulus m and mean 1.
double kolmogorov_smirnov(std::vector<double> sample, double m) {
  std::sort(sample.begin(), sample.end());
  const auto n = static_cast<double>(sample.size());
  const double mean = std::tgamma(1.0 + 1.0 / m);
  double distance = 0.0;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const double law = 1.0 - std::exp(-std::pow(sample[i] * mean, m)), below = static_cast<double>(i) / n;
    distance = std::max({distance, law - below, below + 1.0 / n - law});
  }
  return std::sqrt(n) * distance;
}

/// Of the statistic above: passed once in a thousand by the right law.
constexpr double kOnceInThousand = 1.95;

double distance_to_outline(Vec2 x) { return std::min({x.x, x.y, kWidth - x.x, kHeight - x.y}); }

}  // namespace

TEST_CASE("strength_scatter: the contacts follow its Weibull law, and another modulus is refused") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const std::vector<double> factors =
        strengths(marked({{"strength_scatter", 1.0, {}}}, LawReading::consistent, seed).contacts);
    REQUIRE(factors.size() > 3000);
    const double right = kolmogorov_smirnov(factors, 3.0);
    double mean = 0.0, neighbours = 0.0;
    for (const double f : factors) mean += f / static_cast<double>(factors.size());
    for (std::size_t c = 1; c < factors.size(); ++c) neighbours += (factors[c] - mean) * (factors[c - 1] - mean);
    neighbours /= static_cast<double>(factors.size()) * 0.363 * 0.363;  // variation at m = 3: 36.3 %
    WARN("seed " << seed << ", " << factors.size() << " contacts: Kolmogorov-Smirnov " << right << " for m = 3, "
                 << kolmogorov_smirnov(factors, 2.25) << " for 2.25, " << kolmogorov_smirnov(factors, 3.75)
                 << " for 3.75; mean " << mean << ", correlation of neighbours " << neighbours);
    CHECK(right < kOnceInThousand);
    CHECK(kolmogorov_smirnov(factors, 2.25) > kOnceInThousand);
    CHECK(kolmogorov_smirnov(factors, 3.75) > kOnceInThousand);
    CHECK(mean == Approx(1.0).margin(4 * 0.363 / std::sqrt(3000.0)));
    CHECK(std::abs(neighbours) < 4 / std::sqrt(3000.0));
  }
  CHECK(kolmogorov_smirnov(strengths(marked({{"strength_scatter", 0.5, {}}}).contacts), 6.0) < kOnceInThousand);
}

TEST_CASE("the same seed gives the same strengths, another seed others; off there are none") {
  const auto factors = [](std::uint64_t seed) {
    return strengths(marked({{"strength_scatter", 1.0, {}}}, LawReading::consistent, seed).contacts);
  };
  CHECK(factors(4) == factors(4));
  CHECK(factors(4) != factors(5));
  CHECK(marked({}).contacts.strengths.empty());
  CHECK(marked({{"strength_scatter", 0.0, {}}, {"weak_skin", 0.0, {}}, {"weak_plane", 0.0, {}}})
            .contacts.strengths.empty());
}

TEST_CASE("weak_plane: full loss along the plane, none across, half at 23.5 degrees") {
  const double plane = 60.0 * units::kRadPerDeg;
  const Marked m = marked({{"weak_plane", 1.0, {}}});
  double along = 1.0, across = 0.0, half = 1.0, worst = 0.0;
  double nearest_along = 1.0, nearest_across = 1.0, nearest_half = 1.0;
  for (std::size_t c = 0; c < m.contacts.size(); ++c) {
    const Vec2 t = reference_frame(m.contacts.edges[c], m.particles).tangent;
    const double angle = std::abs(std::remainder(std::atan2(t.y, t.x) - plane, std::numbers::pi));
    const double factor = m.contacts.strength(c);
    worst = std::max(worst, std::abs(factor - (1.0 - 0.5 * std::pow(std::cos(angle), 8))));
    const auto keep = [&](double target, double& nearest, double& kept) {
      if (std::abs(angle - target) < nearest) {
        nearest = std::abs(angle - target);
        kept = factor;
      }
    };
    keep(0.0, nearest_along, along);
    keep(0.5 * std::numbers::pi, nearest_across, across);
    keep(23.5 * units::kRadPerDeg, nearest_half, half);
  }
  CHECK(worst < 1e-12);
  CHECK(along == Approx(0.5).margin(1e-3));  // contacts within a degree or so of these directions are there
  CHECK(across == Approx(1.0).margin(1e-3));
  CHECK(half == Approx(0.75).margin(5e-3));
}

TEST_CASE("weak_skin: contacts with an end within the depth of the outline, and no others; marks multiply") {
  const Marked m = marked({{"weak_skin", 1.0, {{"depth_mm", 3.0}}}});
  int inside = 0, skin = 0;
  for (std::size_t c = 0; c < m.contacts.size(); ++c) {
    const ContactEdge& e = m.contacts.edges[c];
    const double depth = std::min(distance_to_outline(m.particles.reference(e.left1)),
                                  distance_to_outline(m.particles.reference(e.left2)));
    CHECK(m.contacts.strength(c) == (depth <= 3.0 ? 0.5 : 1.0));
    (depth <= 3.0 ? skin : inside) += 1;
  }
  CHECK(skin > 200);
  CHECK(inside > 1000);
  const std::vector<double>
      scatter = strengths(marked({{"strength_scatter", 1.0, {}}}).contacts),
      both = strengths(marked({{"strength_scatter", 1.0, {}}, {"weak_skin", 1.0, {{"depth_mm", 3.0}}}}).contacts);
  for (std::size_t c = 0; c < scatter.size(); ++c) CHECK(both[c] == Approx(scatter[c] * m.contacts.strength(c)));
}

TEST_CASE("initial_defects: the declared share of the contacts, broken, known as defects and no cracks") {
  for (const double fraction : {0.05, 0.1, 0.4}) {
    const Marked m = marked({{"initial_defects", std::nullopt, {{"fraction", fraction}}}});
    int defects = 0;
    for (std::size_t c = 0; c < m.contacts.size(); ++c) {
      defects += m.contacts.is_defect(c);
      CHECK(m.contacts.is_defect(c) == m.contacts.is_broken(c));
      CHECK_FALSE(m.contacts.is_crack(c));
    }
    const auto n = static_cast<double>(m.contacts.size());
    CHECK(defects / n == Approx(fraction).margin(3.5 * std::sqrt(fraction * (1.0 - fraction) / n)));  // 1 in 2000
    CHECK(static_cast<int>(m.contacts.broken.size()) == defects);
  }
  CHECK(marked({{"initial_defects", std::nullopt, {{"fraction", 0.0}}}}).contacts.broken.empty());
}

TEST_CASE("a defect transmits pressure and friction and no tension, under each law") {
  for (const LawReading reading : {LawReading::consistent, LawReading::literal}) {
    Marked m = marked({{"initial_defects", std::nullopt, {{"fraction", 0.1}}}}, reading);
    const auto c = static_cast<std::size_t>(
        std::find_if(m.contacts.broken_index.begin(), m.contacts.broken_index.end(), [](int b) { return b >= 0; }) -
        m.contacts.broken_index.begin());
    const LawParameters& law = m.contacts.law;
    const ContactEdge e = m.contacts.edges[c];
    const ContactFrame frame = reference_frame(e, m.particles);
    const auto traction_at = [&](double normal, double shear) {
      std::vector<Vec2> x = m.particles.position;
      for (const int node : {e.right1, e.right2}) x[node] += normal * frame.normal + shear * frame.tangent;
      std::vector<Vec2> forces(2 * m.contacts.slot_count());
      update_contacts(m.contacts, x, 0.0, ParallelLoops(), forces);
      return m.contacts.points(c)[0];
    };
    const double d = 0.1 * law.delta_ct, slip = 100.0 * law.delta_cs;
    CHECK(traction_at(-d, 0.0).traction_n == Approx(-law.k_t * d));
    CHECK(traction_at(-d, slip).traction_s == Approx(law.k_t * d * law.tan_phi));
    CHECK(traction_at(d, slip).traction_n == 0.0);
    CHECK(traction_at(d, slip).traction_s == 0.0);
    CHECK(m.contacts.is_defect(c));
  }
}
