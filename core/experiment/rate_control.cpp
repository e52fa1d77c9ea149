#include "core/experiment/rate_control.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/units.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/experiment/softening.hpp"

namespace asperity {
namespace {

constexpr double kAim = 0.25;            // of the bound: half the bound's amplitude, which leaves room for cracks
constexpr double kFastestGrowth = 0.25;  // per transit: an acceleration the specimen follows without ringing
constexpr double kNearSoftening = 0.9;   // of the separation at which a contact softens
constexpr double kFastestDecline = 2.0;  // per transit

bool is_compression(const Model& model) { return is_compression(model.config.experiment.type); }

/// Whether cracks run or are about to: a contact point came near softening within the last transit.
bool cracks_run(const Model& model, RateControlState& state, const ParallelLoops& loops) {
  const int separated = count_separated(model.system.contacts, kNearSoftening, loops);
  if (separated > state.separated) state.crack_time = model.system.time;
  state.separated = std::max(state.separated, separated);
  return state.crack_time >= 0.0 && model.system.time - state.crack_time < transit_time(model);
}

/// Closing rate (mm/s) whose effect with the scaled masses is that of the configured one without: waves and cracks are
/// slower by the root of the mass.
double equivalent_closing_rate(const Model& model) {
  return model.config.experiment.loading.closing_rate_mm_per_s / std::sqrt(1.0 + model.added_mass_fraction);
}

}  // namespace

double transit_time(const Model& model) {
  const ParticleConfig& c = model.config.particles;
  const double modulus = closed_forms::effective_modulus(c.youngs_modulus_gpa * units::kMpaPerGpa, c.poissons_ratio,
                                                         model.config.experiment.plane);
  const double density = c.density_kg_per_m3 * units::kTonnePerMm3PerKgPerM3 * (1.0 + model.added_mass_fraction);
  return specimen_length(model.config) * std::sqrt(density / modulus);
}

double relative_kinetic_energy(const Model& model, const ParallelLoops& loops) {
  const System& system = model.system;
  const Platens& platens = system.platens;
  const double bottom = is_compression(model) ? platens.velocity[0] : 0.0;
  const double top = is_compression(model) ? platens.velocity[1] : 0.0;
  const double gradient = (top - bottom) / (platens.y[1] - platens.y[0]);
  const Particles& p = system.particles;
  return loops.sum_blocks<double>(p.node_count(), [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      const Vec2 v = p.velocity[i] - Vec2{0.0, bottom + gradient * (p.position[i].y - platens.y[0])};
      sum += 0.5 * p.mass[i] * dot(v, v);
    }
    return sum;
  });
}

void choose_growth(const Model& model, RateControlState& state, const ParallelLoops& loops) {
  const EnergyBalance energy = energy_balance(model.system, loops);
  const double stored = energy.elastic + energy.recoverable;
  if (stored <= 0.0) return;
  const double bound = model.config.experiment.loading.rate_control.kinetic_ratio_bound;
  state.ratio = relative_kinetic_energy(model, loops) / stored;
  double wanted = 0.5 * std::log(kAim * bound / std::max(state.ratio, 1e-12 * bound));
  if (cracks_run(model, state, loops)) {
    wanted = std::min(wanted, std::log(equivalent_closing_rate(model) / state.rate));
  }
  state.growth = std::clamp(wanted, -kFastestDecline, kFastestGrowth) / transit_time(model);
}

double advance_rate(const Model& model, RateControlState& state) {
  const RateControlConfig& control = model.config.experiment.loading.rate_control;
  const double slowest = control.slowest_rate_factor * equivalent_closing_rate(model);
  const double fastest = control.fastest_rate_factor * equivalent_closing_rate(model);
  state.rate = std::clamp(state.rate * std::exp(state.growth * model.system.time_step), slowest, fastest);
  return state.rate;
}

}  // namespace asperity
