#include "core/experiment/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/units.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/experiment/drive_train.hpp"
#include "core/geometry/specimen.hpp"
#include "core/integrator/time_step.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity {
namespace {

/// Node of the triangle to the left of a boundary edge that sits on the given vertex.
int node_of(const Particles& p, int triangle, int vertex) {
  for (int node : p.triangles[triangle]) {
    if (p.vertex[node] == vertex) return node;
  }
  return -1;
}

FlankPressure find_flanks(const Mesh& mesh, const Particles& p) {
  FlankPressure flank;
  for (const MeshEdge& e : mesh_edges(mesh)) {
    if (e.boundary == Boundary::none) continue;
    const std::array<int, 2> nodes{node_of(p, e.left, e.a), node_of(p, e.left, e.b)};
    const bool flank_edge = e.boundary == Boundary::left || e.boundary == Boundary::right;
    flank.outline.push_back({nodes, e.left, !flank_edge});
    if (flank_edge) flank.edges.push_back({nodes, 1.0});
  }
  return flank;
}

/// The arc is as wide as the disc, or spans 45 degrees to either side where that is less, so that the jaws stay apart.
JawFace make_jaw(const ExperimentConfig& experiment) {
  if (experiment.platens.shape == PlatenShape::flat) return {};
  const double radius = experiment.jaw_radius();
  const double half_width = std::min(0.5 * experiment.diameter_mm, radius / std::numbers::sqrt2);
  return {radius, 0.0, half_width, radius - std::sqrt(radius * radius - half_width * half_width)};
}

/// Corners of a compression specimen's upper end from where its face turns, mm.
std::array<double, 2> corner_arms(const RunConfig& config) {
  const double half = 0.5 * config.experiment.width_mm, pivot = config.extensions.hinge_offset_mm.value_or(0.0);
  return {-half - pivot, half - pivot};
}

/// Tilt and hinge of the upper platen, which stands so that the specimen's highest corner just touches it; I24
/// and I25 of core/integrator.
void turn_upper_face(const RunConfig& config, Platens& platens) {
  const ModelExtensions& x = config.extensions;
  if (x.tilt_deg == 0.0 && !x.hinge_offset_mm) return;
  const auto [left, right] = corner_arms(config);
  platens.upper.slope = std::tan(x.tilt_deg * units::kRadPerDeg);
  platens.upper.pivot_x = x.hinge_offset_mm.value_or(0.0);
  platens.upper.reach = std::max(std::abs(left), std::abs(right));
  platens.y[1] += std::max(-left * platens.upper.slope, -right * platens.upper.slope);
}

/// Inertia of a hinged platen, a bar as heavy as half the specimen and as long as it is wide, more where the time step
/// asks for it.
void steady_platen(Model& model) {
  System& system = model.system;
  if (!model.config.extensions.hinge_offset_mm) return;
  double mass = 0.0, springs = 0.0;
  for (double m : system.particles.mass) mass += 0.5 * m;
  for (std::size_t i = 0; i < system.platen_springs.nodes.size(); ++i) {
    const double arm = system.particles.reference(system.platen_springs.nodes[i]).x - system.platens.upper.pivot_x;
    springs += 0.5 * system.platen_springs.springs[i].stiffness * arm * arm;
  }
  const double width = model.config.experiment.width_mm, offset = *model.config.extensions.hinge_offset_mm;
  const double bar = mass * (width * width / 12.0 + offset * offset);
  system.platens.upper.inertia = std::max(bar, 4.0 * springs * system.time_step * system.time_step);
}

Platens make_platens(const RunConfig& config) {
  Platens platens;
  platens.present = true;
  platens.y = {0.0, specimen_length(config)};
  platens.friction = config.experiment.platens.friction_coefficient;
  platens.jaw = make_jaw(config.experiment);
  turn_upper_face(config, platens);
  return platens;
}

/// Depth, over the edge length, from which nodes that own no loaded edge feel a platen: far beyond elastic overlaps, so
/// that the pressure on an intact end is uniform, and small enough that no loose piece passes through.
constexpr double kSkin = 0.02;

/// Springs that spread the penalty over the loaded edges (ends or rim), half an edge on each of its nodes.
PlatenSprings make_platen_springs(const RunConfig& config, const Mesh& mesh, const Particles& p, double k_t) {
  const double penalty = config.experiment.platens.stiffness_mpa_per_mm.value_or(k_t);
  std::map<int, PlatenSpring> loaded;
  for (const MeshEdge& e : mesh_edges(mesh)) {
    if (e.boundary != Boundary::bottom && e.boundary != Boundary::top && e.boundary != Boundary::rim) continue;
    const double half = 0.5 * norm(mesh.vertices[e.b] - mesh.vertices[e.a]) * penalty;
    loaded[node_of(p, e.left, e.a)].stiffness += half;
    loaded[node_of(p, e.left, e.b)].stiffness += half;
  }
  PlatenSprings springs;
  springs.other = {0.5 * config.particles.edge_mm * penalty, kSkin * config.particles.edge_mm};
  for (const auto& [node, spring] : loaded) {
    springs.nodes.push_back(node);
    springs.springs.push_back(spring);
  }
  return springs;
}

void choose_time_step(Model& model, const ParallelLoops& loops) {
  const IntegrationConfig& c = model.config.integration;
  if (c.mass_scaling_time_step_s.value_or(0.0) > 0.0) {
    model.added_mass_fraction = scale_masses(model.system, *c.mass_scaling_time_step_s, c.safety_factor);
  }
  model.critical_time_step = critical_time_step(model.system, loops);
  if (c.mass_scaling.uniform) {
    const double scaled = c.mass_scaling.time_step_factor * model.critical_time_step;
    model.added_mass_fraction = scale_masses_uniformly(model.system, scaled, loops);
    model.critical_time_step = critical_time_step(model.system, loops);
  }
  const bool given = c.mass_scaling_time_step_s && model.added_mass_fraction > 0.0;
  const double automatic = given ? *c.mass_scaling_time_step_s : c.safety_factor * model.critical_time_step;
  model.system.time_step = c.time_step_s.value_or(automatic);
  if (model.system.time_step > model.critical_time_step) {
    throw Error(ErrorKind::config, {{"/integration/time_step_s", "is above the stable time step of this mesh",
                                     std::to_string(model.system.time_step * 1e9) + " ns",
                                     "at most " + std::to_string(model.critical_time_step * 1e9) + " ns",
                                     "leave it out: it is then safety_factor times the stable one"}});
  }
}

}  // namespace

double specimen_length(const RunConfig& config) {
  switch (config.experiment.type) {
    case ExperimentType::brazilian:
      return config.experiment.diameter_mm;
    case ExperimentType::direct_shear:
      return joint_profile(config.joint).length();
    default:
      return config.experiment.height_mm;
  }
}

double stop_strain(const RunConfig& config) {
  const StopConfig& stop = config.experiment.stop;
  const bool shear = config.experiment.type == ExperimentType::direct_shear;
  return shear ? stop.shear_displacement_mm / specimen_length(config) : stop.axial_strain;
}

double peak_limit(const RunConfig& config) {
  const bool shear = config.experiment.type == ExperimentType::direct_shear;
  return shear ? std::numeric_limits<double>::infinity() : config.measurement.peak_strain_limit;
}

Model build_model(const RunConfig& given, const ParallelLoops& loops) {
  Model model;
  const RunConfig config = with_mechanisms(given);
  model.config = config;
  const LawParameters law = law_parameters(config);
  const bool shear = config.experiment.type == ExperimentType::direct_shear;
  const JointAssembly joint = shear ? joint_mesh(config) : JointAssembly();
  model.mesh = shear ? joint.joint.mesh : make_mesh(config.experiment, config.particles);
  System& system = model.system;
  system.particles = make_particles(model.mesh, config.particles, config.experiment.plane);
  if (std::isfinite(config.extensions.yield_stress_mpa)) {
    set_yield_stress(system.particles, config.extensions.yield_stress_mpa);
  }
  if (shear) model.joint = make_joint(config, joint, system);
  system.contacts =
      make_contacts(model.mesh, system.particles, law, config.contacts.law.reading, config.contacts.law.form);
  mark_contacts(config, model.mesh, system.particles, system.contacts);
  system.general = make_general_contacts(system.particles, general_contact_law(config, law));
  if (config.contacts.general.enabled) system.contacts.hand_over_range = kHandOverRange;
  if (!shear) {
    system.platens = make_platens(config);
    system.platen_springs = make_platen_springs(config, model.mesh, system.particles, law.k_t);
  }
  if (system.platens.friction > 0.0) system.platen_shear.assign(system.particles.node_count(), 0.0);
  system.local_damping = config.integration.local_damping;
  if (is_compression(config.experiment.type)) {
    system.flank = find_flanks(model.mesh, system.particles);
    model.gauges = make_gauges(system.particles, config.experiment, config.measurement, config.particles.edge_mm);
  } else if (!shear) {
    model.disc = make_disc_gauge(system.contacts, system.particles, config.experiment.diameter_mm);
  }
  prepare(system);
  choose_time_step(model, loops);
  make_drive_lines(model);
  shear ? steady_blocks(config, model.joint, system) : steady_platen(model);
  return model;
}

int default_threads(std::size_t triangles) {
  return triangles < 20000 ? 1 : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace asperity
