#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/vec2.hpp"
#include "core/config/mechanism_config.hpp"

/// One run, as plain data. Every member keeps the unit in its name, as its JSON key does; read_run_config fills and
/// checks it. The JSON Schema configs/schema/run.schema.json describes every key.
namespace asperity {

enum class ExperimentType { uniaxial, triaxial, brazilian, direct_shear };
inline bool is_compression(ExperimentType type) {
  return type == ExperimentType::uniaxial || type == ExperimentType::triaxial;
}
enum class PlaneCondition { stress, strain };
enum class PlatenShape { flat, curved };
enum class ParticleKind { triangle, voronoi };
enum class LoadingMode { continuous, staged };
enum class LawReading { literal, consistent };            ///< JSON: "literal", "default".
enum class LawForm { damage_slip, cohesive_frictional };  ///< Of the default law.
enum class ShearPeak { cohesion, coulomb };               ///< Eq 6's peak: c_c, or c_c + sigma_n tan(phi_c).
enum class OpeningShearStiffness { k_t, k_s };  ///< Stiffness of the shear component while the contact is open.

struct PlatenConfig {
  PlatenShape shape = PlatenShape::flat;  ///< Curved: the jaws of a Brazilian disc.
  std::optional<double> jaw_radius_mm;    ///< Of curved jaws; unset: 1.5 times the disc's radius.
  double friction_coefficient = 0.0;
  std::optional<double> stiffness_mpa_per_mm;  ///< Penalty; unset: the contact's tensile stiffness.
  bool operator==(const PlatenConfig&) const = default;
};

/// Continuous loading at a rate that follows the kinetic energy; core/experiment README, Eqs E4 and E5.
struct RateControlConfig {
  bool enabled = false;
  double kinetic_ratio_bound = 0.02;  ///< Kinetic over strain energy that the rate keeps below.
  double slowest_rate_factor = 0.25;  ///< Times the closing rate.
  double fastest_rate_factor = 8.0;   ///< Times the closing rate.
  bool operator==(const RateControlConfig&) const = default;
};

/// One loop of unloading and reloading.
struct UnloadingConfig {
  double at_mm = 0.0;         ///< Closure of the platens, or shear displacement, at which it begins.
  double stress_ratio = 0.1;  ///< Unloading ends at this share of the (deviator or shear) stress it began at.
  bool operator==(const UnloadingConfig&) const = default;
};

struct LoadingConfig {
  LoadingMode mode = LoadingMode::continuous;
  double shear_rate_mm_per_s = 100.0;    ///< Direct shear: of the lower half.
  double closing_rate_mm_per_s = 100.0;  ///< Of the two platens together.
  double ramp_time_s = 0.0;  ///< From rest to the closing rate (Brazilian); the uniaxial test starts from a linear
                             ///< velocity field instead.
  double stage_displacement_mm = 0.02;  ///< Staged: closure of one stage (the paper's Sect. 3.1.2).
  double hold_kinetic_ratio = 1e-4;     ///< A stage, or the confinement, is over when kinetic / strain energy is below.
  double hold_time_s = 2e-3;            ///< Staged: a stage is over after this time at the latest.
  double confinement_time_s = 1.5e-3;   ///< Triaxial: duration of the hydrostatic stage's ramp.
  RateControlConfig rate_control;
  std::vector<UnloadingConfig> unloading;  ///< Loops, in the order of the displacements at which they begin.
  double elastic_start_fraction = 0.0;     ///< Share of first softening that a static solution reaches; 0: none.
  bool operator==(const LoadingConfig&) const = default;
};

struct StopConfig {
  double axial_strain = 0.03;              ///< Closure over height (compression) or over diameter (disc).
  double shear_displacement_mm = 12.0;     ///< Direct shear.
  std::optional<double> fraction_of_peak;  ///< Stop when the stress has fallen below this fraction of its peak.
  std::optional<double> time_s;
  bool operator==(const StopConfig&) const = default;
};

struct ExperimentConfig {
  ExperimentType type = ExperimentType::brazilian;
  PlaneCondition plane = PlaneCondition::stress;
  double width_mm = 54.0;               ///< Compression.
  double height_mm = 130.0;             ///< Compression.
  double diameter_mm = 54.0;            ///< Brazilian disc.
  double thickness_mm = 1.0;            ///< Out of plane.
  double confining_pressure_mpa = 0.0;  ///< Triaxial.
  double normal_stress_mpa = 0.0;       ///< Direct shear: on the joint's plan area.
  PlatenConfig platens;
  LoadingConfig loading;
  StopConfig stop;
  double jaw_radius() const { return platens.jaw_radius_mm.value_or(1.5 * 0.5 * diameter_mm); }  ///< mm
  bool operator==(const ExperimentConfig&) const = default;
};

/// One symmetric saw tooth of a joint.
struct ToothConfig {
  double angle_deg = 30.0;     ///< Of both flanks against the joint's plane.
  double height_mm = 5.0;      ///< Of the crest above the plane.
  double gap_before_mm = 3.5;  ///< Flat part between the tooth and the one before it, or the joint's beginning.
  bool operator==(const ToothConfig&) const = default;
};

/// A rock joint in direct shear. x runs along the joint from 0 to its length, in the direction in which the lower half
/// is driven; y = 0 is its plane.
struct JointConfig {
  std::vector<ToothConfig> profile{ToothConfig{}};  ///< Teeth of the lower half, in the order of x.
  double end_gap_mm = 3.5;                          ///< Flat part after the last tooth.
  std::vector<Vec2> points_mm;  ///< Profile as a line of points with ascending x, in place of the teeth; empty: teeth.
  double lower_height_mm = 20.0, upper_height_mm = 20.0;  ///< Of the halves, from the joint's plane.
  /// Breakable particles reach this far below the lower half's lowest point, and above the profile in the upper half.
  double damage_depth_lower_mm = 2.0, damage_depth_upper_mm = 2.0;
  double coarse_edge_mm = 4.0;  ///< Usual edge far from the joint, in the elastic rest of the halves.
  bool breakable = true;        ///< False: both halves are elastic throughout.
  bool operator==(const JointConfig&) const = default;
};

/// The intact material's laboratory properties: input of the closed forms (Eqs 10-14).
struct MaterialConfig {
  double youngs_modulus_gpa = 1.3;
  double poissons_ratio = 0.2;
  double mode_i_toughness_mpa_sqrt_m = 0.9;
  double mode_ii_toughness_mpa_sqrt_m = 1.1;
  double tensile_strength_mpa = 1.6;
  double beta = 0.25;                                      ///< Eq 33.
  std::optional<double> cohesion_mpa, friction_angle_deg;  ///< Mohr-Coulomb, for a joint's closed forms.
  bool operator==(const MaterialConfig&) const = default;
};

struct ParticleConfig {
  ParticleKind kind = ParticleKind::triangle;
  double edge_mm = 2.0;
  std::optional<double> edge_deviation_mm;  ///< Unset: a tenth of edge_mm, as in the paper.
  double grain_size_mm = 4.0;               ///< Voronoi: mean grain diameter.
  std::uint64_t seed = 1;
  double youngs_modulus_gpa = 1.3;
  double poissons_ratio = 0.2;
  double density_kg_per_m3 = 1200.0;
  double edge_deviation() const { return edge_deviation_mm.value_or(0.1 * edge_mm); }  ///< mm
  bool operator==(const ParticleConfig&) const = default;
};

struct LawConfig {
  LawReading reading = LawReading::consistent;
  LawForm form = LawForm::damage_slip;                           ///< Default law only.
  std::optional<ShearPeak> shear_peak;                           ///< Departure; unset: the reading's own.
  std::optional<OpeningShearStiffness> opening_shear_stiffness;  ///< Departure; unset: the reading's own.
  bool operator==(const LawConfig&) const = default;
};

/// One kind of surface in general contact.
struct SurfaceConfig {
  std::optional<double> friction_angle_deg;           ///< Unset: the contacts' phi_c.
  std::optional<double> normal_stiffness_mpa_per_mm;  ///< Unset: k_t.
  std::optional<double> shear_stiffness_mpa_per_mm;   ///< Unset: k_s.
  bool operator==(const SurfaceConfig&) const = default;
};

struct GeneralContactConfig {
  bool enabled = true;         ///< False: a broken contact touches its own pair alone, for good.
  double damping_ratio = 0.0;  ///< Of the normal approach, over critical damping.
  SurfaceConfig outline, fracture;
  bool operator==(const GeneralContactConfig&) const = default;
};

struct ContactConfig {
  std::optional<double> tensile_stiffness_mpa_per_mm;    ///< k_t; unset: Eq 12 (plane stress) or 13 (plane strain).
  std::optional<double> shear_stiffness_mpa_per_mm;      ///< k_s; unset: the same equations.
  double tensile_strength_mpa = 6.89;                    ///< t_c
  double cohesion_mpa = 5.02;                            ///< c_c
  double friction_angle_deg = 36.5;                      ///< phi_c
  std::optional<double> fracture_energy_n_per_mm;        ///< G_f; unset: K_IC^2 / E~ (Eq 34).
  std::optional<double> shear_fracture_energy_n_per_mm;  ///< G_II at no pressure; unset: Eq 6's drop, no softening.
  LawConfig law;
  GeneralContactConfig general;
  bool operator==(const ContactConfig&) const = default;
};

/// Masses raised until every node has the same critical time step.
struct MassScalingConfig {
  bool uniform = false;
  double time_step_factor = 1.5;  ///< Critical time step over that of the unscaled specimen.
  double added_mass_bound = 2.0;  ///< Added mass over the specimen's above which a run warns.
  bool operator==(const MassScalingConfig&) const = default;
};

struct IntegrationConfig {
  double safety_factor = 0.7;         ///< Time step over the critical step.
  std::optional<double> time_step_s;  ///< Unset: safety_factor times the critical step.
  double local_damping = 0.7;
  std::optional<double> mass_scaling_time_step_s;  ///< Nodes whose own critical step is smaller are made heavier.
  int guard_interval_steps = 100;                  ///< Steps between looks for a state gone wrong.
  MassScalingConfig mass_scaling;
  bool operator==(const IntegrationConfig&) const = default;
};

struct MeasurementConfig {
  int samples = 1000;  ///< Rows of curves.csv up to the stop strain; reactions are means over a sample's steps.
  double axial_gauge_mm = 60.0;  ///< Compression: central gauge length on the specimen.
  double lateral_gauge_mm =
      20.0;  ///< Compression: height of the band at mid-height whose flank displacement is averaged.
  double modulus_window_low = 0.2;  ///< E and nu: fractions of the peak stress.
  double modulus_window_high = 0.5;
  double peak_strain_limit = 0.02;  ///< Peak: largest stress up to this axial strain.
  bool operator==(const MeasurementConfig&) const = default;
};

struct OutputConfig {
  int frames = 24;  ///< With the first and the last; 1: the last alone; 0: none, and no plots.
  std::vector<std::string> fields{"cracks", "contacts", "damage", "stress", "fragments"};
  int width_px = 1600;
  int height_px = 1200;
  double checkpoint_interval_s = 60.0;        ///< Wall time; 0: after every step.
  std::optional<std::string> measured_curve;  ///< CSV file drawn into the plots; read_run_config makes it absolute.
  std::optional<std::string> measured_name;   ///< In legends; read_run_config takes the file's name where unset.
  bool operator==(const OutputConfig&) const = default;
};

struct RunConfig {
  std::string name = "run";  ///< Unset in the file: the file's name without .json.
  std::string description;
  ExperimentConfig experiment;
  JointConfig joint;
  MaterialConfig material;
  ParticleConfig particles;
  ContactConfig contacts;
  IntegrationConfig integration;
  MeasurementConfig measurement;
  OutputConfig output;
  std::vector<MechanismConfig> mechanisms;
  ModelExtensions extensions;  ///< Made of the mechanisms before a model is built; no key of the file.
  bool operator==(const RunConfig&) const = default;
};

/// Thickness (mm) that each of a joint's strips stands for: all of the specimen's where there is one.
inline double strip_thickness(const RunConfig& config) {
  return config.experiment.thickness_mm / config.extensions.strips;
}

}  // namespace asperity
