#include "core/experiment/elastic_start.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/error.hpp"
#include "core/experiment/softening.hpp"
#include "core/integrator/static_stiffness.hpp"

namespace asperity {
namespace {

constexpr int kIterations = 60;          // for one equilibrium
constexpr double kBalance = 1e-7;        // out-of-balance force on any node over the platens' load
constexpr double kFirstClosure = 1e-4;   // of the height: the first increment, before anything is known
constexpr double kLeastClosure = 1e-9;   // of the height: an increment halved this far has no equilibrium
constexpr double kLeastStiffness = 0.1;  // of the initial one: keeps the factorised stiffness positive

/// Slope of x exp(-x), Eqs 3 and 6, over its initial one.
double softened(double x) { return std::max(kLeastStiffness, (1.0 - x) * std::exp(-x)); }

std::vector<EdgeStiffness> tangent_stiffness(const BondedContacts& contacts) {
  std::vector<EdgeStiffness> stiffness(contacts.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    for (std::size_t q = 0; q < 2; ++q) {
      const NormalisedSeparation s = normalised_separation(contacts.memory.load(c)[q], contacts, c);
      stiffness[c][q] = {contacts.law.k_t * softened(s.opening), contacts.law.k_s * softened(s.shear)};
    }
  }
  return stiffness;
}

double largest(const std::vector<Vec2>& force) {
  double square = 0.0;
  for (Vec2 f : force) square = std::max(square, dot(f, f));
  return std::sqrt(square);
}

/// Rigid motions that frictionless platens leave to inertia: along flat ones, and a disc's rolling.
struct FreeMotions {
  bool along_platens, rolling;
};

/// The forces without those that only inertia can balance, spread over the masses: the net force along flat platens
/// and, where the specimen may roll, the net moment; Eq. (E7).
std::vector<Vec2> relieved(std::vector<Vec2> force, const Particles& p, const FreeMotions& free) {
  double mass = 0.0, sideways = 0.0;
  Vec2 centre;
  for (std::size_t i = 0; i < force.size(); ++i) {
    mass += p.mass[i];
    centre += p.mass[i] * p.position[i];
    sideways += force[i].x;
  }
  centre = (1.0 / mass) * centre;
  if (free.along_platens) {
    for (std::size_t i = 0; i < force.size(); ++i) force[i].x -= sideways / mass * p.mass[i];
  }
  if (!free.rolling) return force;
  double moment = 0.0, inertia = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Vec2 arm = p.position[i] - centre;
    moment += cross(arm, force[i]);
    inertia += p.mass[i] * dot(arm, arm);
  }
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Vec2 arm = p.position[i] - centre;
    force[i] += (-moment / inertia * p.mass[i]) * Vec2{-arm.y, arm.x};
  }
  return force;
}

/// An equilibrium on the path: what changes from one to the next, and the forces there.
struct Equilibrium {
  std::vector<Vec2> position;
  BondedContacts contacts;
  std::array<double, 2> platens{0, 0};
  std::vector<Vec2> unbalanced, pressure;
  PlatenLoad load;
};

std::vector<Vec2> external_forces(const System& system) {
  std::vector<Vec2> forces(system.particles.node_count());
  for (std::size_t i = 0; i < system.loads.nodes.size(); ++i) forces[system.loads.nodes[i]] = system.loads.forces[i];
  return forces;
}

Equilibrium present(const System& system) {
  return {system.particles.position, system.contacts,         system.platens.y,
          out_of_balance(system),    external_forces(system), platen_load(system)};
}

void restore(System& system, const Equilibrium& e) {
  system.particles.position = e.position;
  system.contacts = e.contacts;
  system.platens.y = e.platens;
}

void close_platens(System& system, double closure) {
  system.platens.y[0] += 0.5 * closure;
  system.platens.y[1] -= 0.5 * closure;
}

/// Takes what moves at the start of the path to rest; its kinetic energy is booked as damping.
void bring_to_rest(System& system, const ParallelLoops& loops) {
  compute_forces(system, loops);
  update_velocities(system, loops);
  system.damping_energy += system.sums.kinetic;
  std::fill(system.particles.velocity.begin(), system.particles.velocity.end(), Vec2{});
  system.platens.velocity = system.platens.last_velocity = {0, 0};
}

/// Aitken's factor on the next correction, from the last one and the factor it had: it calms corrections that change
/// sign because a contact unloads more stiffly than it was loaded.
double relaxation(double factor, const std::vector<Vec2>& last, const std::vector<Vec2>& correction) {
  double along = 0.0, square = 0.0;
  for (std::size_t i = 0; i < correction.size(); ++i) {
    const Vec2 change = correction[i] - last[i];
    along += dot(last[i], change);
    square += dot(change, change);
  }
  return std::clamp(-factor * along / square, 0.1, 1.5);
}

/// Newton's iteration with a stiffness that is factorised once, and anew where platens meet other nodes: Eq. (E7). The
/// contacts' memory is taken forward from `from` at every trial. False where it does not converge.
bool find_equilibrium(System& system, const Equilibrium& from, const FreeMotions& free, const ParallelLoops& loops,
                      ElasticStart& count) {
  std::unique_ptr<StaticStiffness> stiffness;
  std::vector<Vec2> last;
  double factor = 1.0;
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    system.contacts = from.contacts;
    compute_forces(system, loops);
    const PlatenLoad load = platen_load(system);
    const std::vector<Vec2> unbalanced = relieved(out_of_balance(system), system.particles, free);
    const double size = largest(unbalanced);
    if (!std::isfinite(size)) return false;
    if (iteration > 0 && size <= kBalance * (load.reaction[0] + load.reaction[1])) return true;
    if (!stiffness || stiffness->on_platens() != nodes_on_platens(system)) {
      stiffness = std::make_unique<StaticStiffness>(system, tangent_stiffness(system.contacts));
      ++count.factorisations;
      last.clear();
    }
    const std::vector<Vec2> correction = stiffness->solve(unbalanced);
    factor = last.empty() ? 1.0 : relaxation(factor, last, correction);
    for (std::size_t i = 0; i < correction.size(); ++i) system.particles.position[i] += factor * correction[i];
    last = correction;
    ++count.iterations;
  }
  return false;
}

/// Books the work of an increment by the trapezoidal rule, Eq. (E8): of the platens and the pressure as external, of
/// the out-of-balance forces, which the static solution takes out, as damping.
void book_increment(System& system, const Equilibrium& from, const Equilibrium& to) {
  for (std::size_t i = 0; i < to.position.size(); ++i) {
    const Vec2 moved = to.position[i] - from.position[i];
    system.external_work += 0.5 * dot(from.pressure[i] + to.pressure[i], moved);
    system.damping_energy += 0.5 * dot(from.unbalanced[i] + to.unbalanced[i], moved);
  }
  for (int side = 0; side < 2; ++side) {
    const double inward = (side == 0 ? 1.0 : -1.0) * (to.platens[side] - from.platens[side]);
    system.external_work += 0.5 * (from.load.reaction[side] + to.load.reaction[side]) * inward;
  }
  system.sums = {};
  system.sums.reaction = to.load.reaction;
  system.sums.platen_energy = to.load.energy;
}

/// The specimen moves on as it did in the last increment, at the closing rate. The half step before the present
/// instant, which the next step's account adds, has not been travelled: its work is taken off.
void set_in_motion(System& system, const Equilibrium& before, const Equilibrium& last, double closure, double rate) {
  Particles& p = system.particles;
  system.platens.velocity = {0.5 * rate, -0.5 * rate};
  system.platens.last_velocity = {0, 0};
  for (std::size_t i = 0; i < p.node_count(); ++i) {
    p.velocity[i] = (rate / closure) * (last.position[i] - before.position[i]);
    system.initial_kinetic += 0.5 * p.mass[i] * dot(p.velocity[i], p.velocity[i]);
    system.external_work -= 0.5 * system.time_step * dot(last.pressure[i], p.velocity[i]);
  }
}

/// The next increment's closure (mm), so that the separation rises by `increment` and ends at `wanted`.
double next_closure(double closure, double rise, double separation, double wanted, double increment) {
  const double step = std::min(increment, wanted - separation);
  return closure * std::clamp(step / std::max(rise, 1e-12), 0.2, 5.0);
}

}  // namespace

ElasticStart solve_elastic_start(Model& model, const ParallelLoops& loops, const std::function<bool()>& on_equilibrium,
                                 int increments) {
  constexpr double kReached = 0.995;  // of the separation wanted
  constexpr double kPassed = 1.01;
  System& system = model.system;
  const LoadingConfig& loading = model.config.experiment.loading;
  const double height = specimen_length(model.config);
  const double wanted = loading.elastic_start_fraction;
  const FreeMotions free{system.platens.jaw.radius == 0.0, model.config.experiment.type == ExperimentType::brazilian};
  ElasticStart result;
  bring_to_rest(system, loops);
  Equilibrium from = present(system);
  std::vector<Vec2> trend(from.position.size());  // displacements per closure in the last increment
  double closure = kFirstClosure * height;
  result.separation = largest_separation(system.contacts);
  while (result.separation < kReached * wanted) {
    close_platens(system, closure);
    for (std::size_t i = 0; i < trend.size(); ++i) system.particles.position[i] += closure * trend[i];
    const bool found = find_equilibrium(system, from, free, loops, result);
    const double separation = largest_separation(system.contacts);
    if (!found || separation > kPassed * wanted) {
      restore(system, from);
      closure *= 0.5;
      if (closure < kLeastClosure * height) {
        throw Error(ErrorKind::numerical, "the elastic start finds no equilibrium at a closure of " +
                                              std::to_string(height - (from.platens[1] - from.platens[0])) +
                                              " mm; lower experiment.loading.elastic_start_fraction");
      }
      continue;
    }
    const Equilibrium to = present(system);
    book_increment(system, from, to);
    for (std::size_t i = 0; i < trend.size(); ++i) trend[i] = (1.0 / closure) * (to.position[i] - from.position[i]);
    ++result.increments;
    system.general.search_due = 1;
    system.time += closure / loading.closing_rate_mm_per_s;
    const bool go_on = on_equilibrium();
    const double rise = separation - result.separation;
    result.separation = separation;
    if (!go_on || separation >= kReached * wanted) {
      set_in_motion(system, from, to, closure, loading.closing_rate_mm_per_s);
      return result;
    }
    closure = next_closure(closure, rise, separation, wanted, wanted / increments);
    from = to;
  }
  return result;
}

}  // namespace asperity
