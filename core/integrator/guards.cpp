#include "core/integrator/guards.hpp"

#include <cmath>
#include <cstdio>

#include "core/base/error.hpp"

namespace asperity {
namespace {

[[noreturn]] void stop(const System& system, Vec2 place, const char* what, const char* cause) {
  char text[320];
  std::snprintf(text, sizeof text, "step %lld, t = %.6g s, near (%.4g, %.4g) mm: %s. Likely cause: %s",
                static_cast<long long>(system.step), system.time, place.x, place.y, what, cause);
  throw Error(ErrorKind::numerical, text);
}

/// Share of the inradius beyond which general contact no longer pushes pieces apart reliably; core/contact README,
/// deepest overlap.
constexpr double kDeepest = 0.75;

/// A joint between blocks has a shear rate, a specimen between platens a closing rate.
const char* step_hint(const System& system) {
  return system.blocks.empty()
             ? "a time step above the stable one, or a loading rate the specimen cannot follow; lower "
               "integration.safety_factor or experiment.loading.closing_rate_mm_per_s"
             : "a time step above the stable one, or a shear rate the joint cannot follow; lower "
               "integration.safety_factor or experiment.loading.shear_rate_mm_per_s";
}

constexpr double kNoEnergy = 1e-9;  // N mm per mm of thickness

/// The first node whose velocity is not finite, else the one with most kinetic energy.
std::size_t most_energetic_node(const Particles& p) {
  std::size_t most = 0;
  double largest = -1.0;
  for (std::size_t node = 0; node < p.node_count(); ++node) {
    const double energy = 0.5 * p.mass[node] * dot(p.velocity[node], p.velocity[node]);
    if (!std::isfinite(energy)) return node;
    if (energy <= largest) continue;
    largest = energy;
    most = node;
  }
  return most;
}

}  // namespace

void check_state(const System& system) {
  const Particles& p = system.particles;
  for (std::size_t t = 0; t < p.triangle_count(); ++t) {
    const double jacobian = deformation_gradient(p.shape(t), p.corners(t)).jacobian();
    const Vec2 place = p.reference(p.triangles[t][0]);
    if (!std::isfinite(jacobian)) stop(system, place, "a position is not finite", step_hint(system));
    if (jacobian <= 0.0) stop(system, place, "a particle has turned over", step_hint(system));
  }
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const ContactEdge& e = system.contacts.edges[c];
    for (const PointState& s : system.contacts.memory.load(c)) {
      if (-s.normal > 0.5 * e.length) {
        stop(system, p.reference(e.left1), "two faces overlap by more than half their edge",
             "stresses far above k_t times the edge length; check units of stiffness and confining pressure");
      }
    }
  }
}

void check_overlaps(const System& system) {
  const DeepestTouch deepest = deepest_touch(system.general);
  if (deepest.share > kDeepest) {
    stop(system, deepest.place, "a piece has pressed through three quarters of another's inradius",
         "contact stresses far above the penalty times the edge length: raise "
         "contacts.general.fracture.normal_stiffness_mpa_per_mm, or load more slowly");
  }
}

void check_energy(const System& system, const EnergyBalance& energy) {
  const double given = energy.external_work + std::max(0.0, energy.created_by_law);
  if (energy.kinetic <= given || energy.kinetic <= kNoEnergy) return;
  const Vec2 place = system.particles.reference(most_energetic_node(system.particles));
  if (!std::isfinite(energy.kinetic)) stop(system, place, "a velocity is not finite", step_hint(system));
  stop(system, place, "kinetic energy exceeds the work done on the model", step_hint(system));
}

void check_all(const System& system, const ParallelLoops& loops) {
  check_state(system);
  check_overlaps(system);
  EnergyBalance energy;
  energy.external_work = system.external_work + system.initial_kinetic;
  energy.kinetic = system.sums.kinetic;
  if (system.contacts.reading == LawReading::literal) {
    energy.created_by_law = contact_energies(system.contacts, loops).created;
  }
  check_energy(system, energy);
}

}  // namespace asperity
