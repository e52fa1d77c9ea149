#include "core/experiment/drive_train.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/base/units.hpp"
#include "core/contact/closed_forms.hpp"

namespace asperity {
namespace {

/// Of a frame of which only the seats are asked for, over the specimen's estimated stiffness: a fiftieth of its
/// compliance is lost in it.
constexpr double kStiffFrame = 50.0;
/// Of the specimen's mass, in each platen: light enough to follow a crack, heavy against the nodes that it meets.
constexpr double kPlatenMass = 0.5;

bool sheared(const Model& model) { return model.config.experiment.type == ExperimentType::direct_shear; }

double modulus(const Model& model) {
  const ParticleConfig& p = model.config.particles;
  return closed_forms::effective_modulus(p.youngs_modulus_gpa * units::kMpaPerGpa, p.poissons_ratio,
                                         model.config.experiment.plane);
}

/// Width over height: of the block of material that the drive strains, or of a disc, whose stiffness is about its
/// modulus.
double slenderness(const Model& model) {
  const ExperimentConfig& e = model.config.experiment;
  if (is_compression(e.type)) return e.width_mm / e.height_mm;
  if (!sheared(model)) return 1.0;
  const JointConfig& joint = model.config.joint;
  return model.joint.profile.length() / (joint.lower_height_mm + joint.upper_height_mm);
}

/// Estimated, N/mm per mm of thickness.
double specimen_stiffness(const Model& model) { return modulus(model) * slenderness(model); }

/// The load at a nominal stress of 1 MPa, N per mm of thickness.
double nominal_area(const Model& model) {
  const ExperimentConfig& e = model.config.experiment;
  if (is_compression(e.type)) return e.width_mm;
  return sheared(model) ? model.joint.profile.length() : 0.5 * std::numbers::pi * e.diameter_mm;
}

/// The whole train, of one strip.
DriveLine train(const Model& model) {
  const ModelExtensions& x = model.config.extensions;
  DriveLine line;
  if (!std::isfinite(x.frame_stiffness_n_per_mm) && x.seating_mm == 0.0) return line;
  line.stiffness = std::isfinite(x.frame_stiffness_n_per_mm)
                       ? x.frame_stiffness_n_per_mm / model.config.experiment.thickness_mm
                       : kStiffFrame * specimen_stiffness(model);
  line.seating = x.seating_mm;
  line.half_load = x.seating_stress_mpa * nominal_area(model);
  return line;
}

double specimen_mass(const System& system) {
  const std::vector<double>& mass = system.particles.mass;
  return std::accumulate(mass.begin(), mass.end(), 0.0);
}

/// Least mass (tonne per mm of thickness) of a platen on a line that the time step can follow, from Gershgorin's bound
/// with the springs of all nodes that it may meet: half of those of the ends or the rim.
double least_platen_mass(const System& system, const DriveLine& line) {
  double springs = 0.0;
  for (const PlatenSpring& spring : system.platen_springs.springs) springs += 0.5 * spring.stiffness;
  return system.time_step * system.time_step * (4.0 * springs + line.stiffness);
}

}  // namespace

void make_drive_lines(Model& model) {
  System& system = model.system;
  DriveLine line = train(model);
  if (line.stiffness == 0.0) return;
  if (sheared(model)) {
    const double strips = model.joint.gauge.strips.count;
    line.stiffness *= strips;
    line.half_load *= strips;
    system.lines[0] = line;
    return;
  }
  line.stiffness *= 2.0;
  line.seating *= 0.5;
  line.mass = std::max(kPlatenMass * specimen_mass(system), least_platen_mass(system, line));
  system.lines = {line, line};
}

void tie_drive(System& system) {
  for (std::size_t i = 0; i < system.lines.size(); ++i) {
    DriveLine& line = system.lines[i];
    if (line.stiffness == 0.0) continue;
    line.tied = 1;
    line.preload = system.platens.present ? system.sums.reaction[i] : -system.blocks[i].reaction.x;
  }
}

void set_closing_rate(System& system, double rate) {
  if (!is_tied(system)) {
    system.platens.velocity = {0.5 * rate, -0.5 * rate};
    return;
  }
  for (DriveLine& line : system.lines) line.drive_velocity = 0.5 * rate;
}

void set_shear_rate(System& system, double rate) {
  if (is_tied(system)) {
    system.lines[0].drive_velocity = rate;
  } else {
    system.blocks[kLowerBlock].velocity = {rate, 0.0};
  }
}

double drive_displacement(const System& system) { return system.lines[0].drive + system.lines[1].drive; }

double specimen_share(const Model& model) {
  if (!is_tied(model.system)) return 1.0;
  const double lines = 0.5 * first_stiffness(model.system.lines[0]);
  return lines / (lines + specimen_stiffness(model));
}

}  // namespace asperity
