#include "core/config/cross_checks.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string_view>

#include "core/config/applicability.hpp"
#include "core/config/bindings.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/estimates.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {

namespace {

constexpr std::string_view kType = "/experiment/type";
constexpr std::string_view kPlane = "/experiment/plane";
constexpr std::string_view kConfiningPressure = "/experiment/confining_pressure_mpa";
constexpr std::string_view kNormalStress = "/experiment/normal_stress_mpa";
constexpr std::string_view kProfile = "/joint/profile";
constexpr std::string_view kPoints = "/joint/points_mm";
constexpr std::string_view kDamageDepth = "/joint/damage_depth_lower_mm";
constexpr std::string_view kCoarseEdge = "/joint/coarse_edge_mm";
constexpr std::string_view kLowerHeight = "/joint/lower_height_mm";
constexpr std::string_view kWidth = "/experiment/width_mm";
constexpr std::string_view kHeight = "/experiment/height_mm";
constexpr std::string_view kDiameter = "/experiment/diameter_mm";
constexpr std::string_view kEdge = "/particles/edge_mm";
constexpr std::string_view kEdgeDeviation = "/particles/edge_deviation_mm";
constexpr std::string_view kGrainSize = "/particles/grain_size_mm";
constexpr std::string_view kKind = "/particles/kind";
constexpr std::string_view kFractureEnergy = "/contacts/fracture_energy_n_per_mm";
constexpr std::string_view kTimeStep = "/integration/time_step_s";
constexpr std::string_view kMassScaling = "/integration/mass_scaling_time_step_s";
constexpr std::string_view kUniformMass = "/integration/mass_scaling/uniform";
constexpr std::string_view kElasticStart = "/experiment/loading/elastic_start_fraction";
constexpr std::string_view kUnloading = "/experiment/loading/unloading";
constexpr std::string_view kShape = "/experiment/platens/shape";
constexpr std::string_view kJawRadius = "/experiment/platens/jaw_radius_mm";
constexpr std::string_view kPlatenFriction = "/experiment/platens/friction_coefficient";
constexpr std::string_view kWindow = "/measurement/modulus_window";
constexpr std::string_view kAxialGauge = "/measurement/axial_gauge_mm";
constexpr std::string_view kLateralGauge = "/measurement/lateral_gauge_mm";

using Result = std::optional<Fault>;

/// One contradiction between keys: the keys it reads, and the fault it finds.
struct Check {
  std::vector<std::string_view> keys;
  Result (*find)(const RunConfig& config);
};

/// Three significant digits, for derived bounds.
std::string rounded(double number) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.3g", number);
  return buffer;
}

Fault fault_at(const RunConfig& config, std::string_view pointer, std::string what, std::string allowed,
               std::string hint) {
  return {std::string(pointer), std::move(what), value_text(config, pointer), std::move(allowed), std::move(hint)};
}

bool is_compression(const RunConfig& config) { return is_compression(config.experiment.type); }
bool is_shear(const RunConfig& config) { return config.experiment.type == ExperimentType::direct_shear; }

Result triaxial_without_pressure(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  if (e.type != ExperimentType::triaxial || e.confining_pressure_mpa > 0.0) return {};
  return fault_at(config, kConfiningPressure, "a triaxial test needs a confining pressure", "above 0 MPa",
                  "set it, or set /experiment/type to \"uniaxial\"");
}

/// Where a test ends, mm of closure or shear displacement.
double stop_displacement(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  if (is_shear(config)) return e.stop.shear_displacement_mm;
  return e.stop.axial_strain * (is_compression(config) ? e.height_mm : e.diameter_mm);
}

Result unloading_out_of_order(const RunConfig& config) {
  const std::vector<UnloadingConfig>& loops = config.experiment.loading.unloading;
  double before = 0.0;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const double at = loops[i].at_mm, end = stop_displacement(config);
    if (at > before && at < end) {
      before = at;
      continue;
    }
    return Fault{std::string(kUnloading) + "/" + std::to_string(i) + "/at_mm",
                 "does not lie behind the loop before it and before the test's end", number_text(at),
                 "above " + rounded(before) + ", below " + rounded(end) + " mm",
                 "the displacements at which loops begin ascend; /experiment/stop says where the test ends"};
  }
  return {};
}

Result unloading_under_rate_control(const RunConfig& config) {
  const LoadingConfig& loading = config.experiment.loading;
  if (loading.unloading.empty() || !loading.rate_control.enabled) return {};
  return fault_at(config, "/experiment/loading/rate_control/enabled", "cannot go with loops of unloading", "false",
                  "a controlled rate only ever goes forward; leave out one of the two");
}

Result shear_without_normal_stress(const RunConfig& config) {
  if (!is_shear(config) || config.experiment.normal_stress_mpa > 0.0) return {};
  return fault_at(config, kNormalStress, "a direct shear test needs a normal stress", "above 0 MPa", "set it");
}

Result profile_given_twice(const RunConfig& config) {
  const JointConfig& joint = config.joint;
  if (!is_shear(config) || joint.points_mm.empty() || joint.profile == JointConfig().profile) return {};
  return fault_at(config, kProfile, "is given beside /joint/points_mm", "one of the two", "remove one of them");
}

Result damage_zone_without_coarse_part(const RunConfig& config) {
  const JointConfig& j = config.joint;
  if (!is_shear(config) || j.damage_depth_lower_mm + j.coarse_edge_mm < j.lower_height_mm) return {};
  return fault_at(config, kDamageDepth, "leaves no elastic part below",
                  "below lower_height_mm less coarse_edge_mm, " + rounded(j.lower_height_mm - j.coarse_edge_mm) + " mm",
                  "make the lower half higher, or the zone less deep");
}

Result edges_not_graded(const RunConfig& config) {
  if (!is_shear(config) || config.joint.coarse_edge_mm >= config.particles.edge_mm) return {};
  return fault_at(config, kCoarseEdge, "is shorter than the particles' edges",
                  "at least /particles/edge_mm, " + number_text(config.particles.edge_mm) + " mm",
                  "lengthen it, or shorten /particles/edge_mm");
}

Result edge_too_long(const RunConfig& config) {
  constexpr double kEdgesAcross = 5.0;
  const double dimension = smallest_dimension(config);
  if (config.particles.edge_mm <= dimension / kEdgesAcross) return {};
  return fault_at(config, kEdge, "is too long for the specimen",
                  "at most " + rounded(dimension / kEdgesAcross) +
                      " mm, a fifth of the specimen's smallest dimension, " + number_text(dimension) + " mm",
                  "shorten the edges, or make the specimen larger");
}

Result too_many_triangles(const RunConfig& config) {
  constexpr double kMostTriangles = 5e6;  // some kB each: the memory of a large workstation
  const double triangles = estimated_triangles(config);
  if (triangles <= kMostTriangles) return {};
  return fault_at(config, kEdge, "makes about " + rounded(triangles) + " triangles",
                  "up to " + rounded(kMostTriangles) + " triangles",
                  "lengthen the edges, or make the specimen smaller");
}

Result edges_scatter_too_much(const RunConfig& config) {
  constexpr double kLargestScatter = 0.3;
  const ParticleConfig& p = config.particles;
  if (p.edge_deviation() < kLargestScatter * p.edge_mm) return {};
  return fault_at(config, kEdgeDeviation, "the edges would scatter too much to be meshed",
                  "below " + rounded(kLargestScatter * p.edge_mm) + " mm, 30 % of edge_mm " + number_text(p.edge_mm),
                  "the paper has 10 % of edge_mm");
}

Result edges_scatter_too_little(const RunConfig& config) {
  constexpr double kSmallestScatter = 0.07;  // what an irregular arrangement of triangles can be relaxed to
  const ParticleConfig& p = config.particles;
  if (p.kind == ParticleKind::voronoi || p.edge_deviation() >= kSmallestScatter * p.edge_mm) return {};
  return fault_at(config, kEdgeDeviation, "no irregular arrangement has edges so equal",
                  "at least " + rounded(kSmallestScatter * p.edge_mm) + " mm, 7 % of edge_mm " + number_text(p.edge_mm),
                  "leave it out: it is then a tenth of edge_mm");
}

Result grains_too_small(const RunConfig& config) {
  constexpr double kEdgesPerGrain = 1.5;
  const ParticleConfig& p = config.particles;
  if (p.kind != ParticleKind::voronoi || p.grain_size_mm >= kEdgesPerGrain * p.edge_mm) return {};
  return fault_at(
      config, kGrainSize, "a grain would be no larger than its triangles",
      "at least " + rounded(kEdgesPerGrain * p.edge_mm) + " mm, 1.5 times edge_mm " + number_text(p.edge_mm),
      "enlarge the grains, or shorten edge_mm");
}

Result grains_too_large(const RunConfig& config) {
  constexpr double kGrainsAcross = 3.0;
  const ParticleConfig& p = config.particles;
  const double dimension = smallest_dimension(config);
  if (p.kind != ParticleKind::voronoi || p.grain_size_mm <= dimension / kGrainsAcross) return {};
  return fault_at(config, kGrainSize, "the grains are too large for the specimen",
                  "at most " + rounded(dimension / kGrainsAcross) +
                      " mm, a third of the specimen's smallest dimension, " + number_text(dimension) + " mm",
                  "make the grains smaller, or the specimen larger");
}

Result fracture_energy_too_small(const RunConfig& config) {
  const double least = hardening_energy(config);
  if (estimated_fracture_energy(config) >= least) return {};
  Fault fault = fault_at(config, kFractureEnergy, "less energy than the hardening branch alone takes",
                         "at least " + rounded(least) + " N/mm, e (e - 2) t_c^2 / k_t (Eqs 4, 10)",
                         "raise it, lower /contacts/tensile_strength_mpa, or raise the tensile stiffness");
  if (fault.value.empty()) fault.value = rounded(estimated_fracture_energy(config)) + " from the material (Eq 34)";
  return fault;
}

Result time_step_unstable(const RunConfig& config) {
  constexpr double kCertainlyUnstable = 2.0;  // the estimate is good to some 10 %
  const double step = estimated_critical_step(config);
  if (config.integration.time_step_s.value_or(0.0) <= kCertainlyUnstable * step) return {};
  return fault_at(config, kTimeStep, "is above the stable time step", "up to about " + rounded(step) + " s here",
                  "remove it (then safety_factor times the critical step is taken), or set mass_scaling_time_step_s");
}

Result mass_scaled_twice(const RunConfig& config) {
  const IntegrationConfig& c = config.integration;
  if (!c.mass_scaling.uniform || c.mass_scaling_time_step_s.value_or(0.0) == 0.0) return {};
  return fault_at(config, kMassScaling, "masses cannot be scaled to a given step and to a uniform one at once",
                  "unset while /integration/mass_scaling/uniform is true",
                  "remove it, or set /integration/mass_scaling/uniform to false");
}

Result elastic_start_with_friction(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  if (e.loading.elastic_start_fraction == 0.0 || e.platens.friction_coefficient == 0.0) return {};
  return fault_at(config, kElasticStart, "an elastic start has frictionless platens only",
                  "0 while /experiment/platens/friction_coefficient is above 0",
                  "remove it, or set /experiment/platens/friction_coefficient to 0");
}

Result jaws_too_narrow(const RunConfig& config) {
  const ExperimentConfig& e = config.experiment;
  const double radius = 0.5 * e.diameter_mm;
  if (is_compression(config) || e.platens.shape == PlatenShape::flat || e.jaw_radius() > radius) return {};
  return fault_at(config, kJawRadius, "the jaws are not wider than the disc, which would stand on their edges",
                  "above the disc's radius, " + number_text(radius) + " mm",
                  "leave it out: it is then 1.5 times the disc's radius (ISRM 1978)");
}

Result window_reversed(const RunConfig& config) {
  const MeasurementConfig& m = config.measurement;
  if (m.modulus_window_low < m.modulus_window_high) return {};
  return fault_at(config, kWindow, "the window's low end is not below its high end", "[low, high] with low below high",
                  "for example [0.2, 0.5]");
}

Result gauge_too_long(const RunConfig& config, std::string_view pointer, double length) {
  const double height = config.experiment.height_mm;
  if (!is_compression(config) || length <= height) return {};
  return fault_at(config, pointer, "the gauge is longer than the specimen",
                  "at most height_mm " + number_text(height) + " mm", "shorten the gauge");
}
Result axial_gauge_too_long(const RunConfig& config) {
  return gauge_too_long(config, kAxialGauge, config.measurement.axial_gauge_mm);
}
Result lateral_gauge_too_long(const RunConfig& config) {
  return gauge_too_long(config, kLateralGauge, config.measurement.lateral_gauge_mm);
}

const std::vector<Check>& checks() {
  static const std::vector<Check> table{
      {{kType, kConfiningPressure}, triaxial_without_pressure},
      {{kType, kNormalStress}, shear_without_normal_stress},
      {{kType, kProfile, kPoints}, profile_given_twice},
      {{kType, kDamageDepth, kCoarseEdge, kLowerHeight}, damage_zone_without_coarse_part},
      {{kType, kCoarseEdge, kEdge}, edges_not_graded},
      {{kType, kWidth, kHeight, kDiameter, kEdge}, edge_too_long},
      {{kType, kWidth, kHeight, kDiameter, kEdge}, too_many_triangles},
      {{kEdge, kEdgeDeviation}, edges_scatter_too_much},
      {{kEdge, kEdgeDeviation}, edges_scatter_too_little},
      {{kKind, kEdge, kGrainSize}, grains_too_small},
      {{kType, kWidth, kHeight, kDiameter, kKind, kGrainSize}, grains_too_large},
      {{kType, kPlane, "/material", "/contacts"}, fracture_energy_too_small},
      {{kType, kPlane, "/material", "/contacts", "/particles", kTimeStep, kMassScaling, "/integration/mass_scaling"},
       time_step_unstable},
      {{kUniformMass, kMassScaling}, mass_scaled_twice},
      {{kElasticStart, kPlatenFriction}, elastic_start_with_friction},
      {{kType, kUnloading, kHeight, kDiameter, "/experiment/stop"}, unloading_out_of_order},
      {{kUnloading, "/experiment/loading/rate_control"}, unloading_under_rate_control},
      {{kType, kDiameter, kShape, kJawRadius}, jaws_too_narrow},
      {{kWindow}, window_reversed},
      {{kType, kHeight, kAxialGauge}, axial_gauge_too_long},
      {{kType, kHeight, kLateralGauge}, lateral_gauge_too_long},
  };
  return table;
}

bool any_faulty(const std::vector<std::string_view>& keys, const KeyNotes& notes) {
  for (const std::string_view key : keys)
    for (const std::string& faulty : notes.faulty)
      if (pointers_overlap(key, faulty)) return true;
  return false;
}

bool is_given(const RunConfig& config, std::string_view pointer, const KeyNotes& notes) {
  return notes.given.contains(std::string(pointer)) || differs_from_default(config, pointer);
}

/// "has no meaning when /experiment/type is "brazilian"".
Fault misplaced(const RunConfig& config, const ConditionalKey& key) {
  const std::string what =
      "has no meaning when " + std::string(key.decided_by) + " is " + value_text(config, key.decided_by);
  return fault_at(config, key.pointer, what, std::string(key.allowed), std::string(key.hint));
}

std::vector<Fault> misplaced_keys(const RunConfig& config, const KeyNotes& notes) {
  std::vector<Fault> faults;
  for (const ConditionalKey& key : conditional_keys()) {
    if (key.applies(config) || any_faulty({key.pointer, key.decided_by, kType}, notes)) continue;
    const bool named = !faults.empty() && faults.back().where == key.pointer;
    if (!named && is_given(config, key.pointer, notes)) faults.push_back(misplaced(config, key));
  }
  return faults;
}

}  // namespace

bool pointers_overlap(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  return b.starts_with(a) && (a.size() == b.size() || b[a.size()] == '/');
}

std::vector<Fault> cross_check(const RunConfig& config, const KeyNotes& notes) {
  std::vector<Fault> faults = misplaced_keys(config, notes);
  for (const Check& check : checks()) {
    if (any_faulty(check.keys, notes)) continue;
    if (Result fault = check.find(config)) faults.push_back(std::move(*fault));
  }
  if (!any_faulty({"/mechanisms", kType}, notes)) {
    for (Fault& fault : mechanism_faults(config)) faults.push_back(std::move(fault));
  }
  return faults;
}

}  // namespace asperity
