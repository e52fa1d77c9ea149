#include "core/config/applicability.hpp"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

constexpr std::string_view kType = "/experiment/type";
constexpr std::string_view kMode = "/experiment/loading/mode";
constexpr std::string_view kShape = "/experiment/platens/shape";
constexpr std::string_view kReading = "/contacts/law/reading";
constexpr std::string_view kKind = "/particles/kind";

bool is_disc(const RunConfig& config) { return config.experiment.type == ExperimentType::brazilian; }
bool is_compression(const RunConfig& config) { return is_compression(config.experiment.type); }
bool is_shear(const RunConfig& config) { return config.experiment.type == ExperimentType::direct_shear; }
bool has_platens(const RunConfig& config) { return !is_shear(config); }
bool has_jaws(const RunConfig& config) { return config.experiment.platens.shape == PlatenShape::curved; }
bool is_triaxial(const RunConfig& config) { return config.experiment.type == ExperimentType::triaxial; }
bool has_first_stage(const RunConfig& config) { return is_triaxial(config) || is_shear(config); }
bool starts_from_rest(const RunConfig& config) { return is_disc(config) || is_shear(config); }
bool is_staged(const RunConfig& config) { return config.experiment.loading.mode == LoadingMode::staged; }
bool has_holds(const RunConfig& config) { return is_staged(config) || has_first_stage(config); }
bool is_continuous(const RunConfig& config) { return !is_staged(config); }
bool is_default_law(const RunConfig& config) { return config.contacts.law.reading == LawReading::consistent; }
bool is_voronoi(const RunConfig& config) { return config.particles.kind == ParticleKind::voronoi; }

/// Keys that only a joint has, and keys that a joint has not.
constexpr std::array<std::string_view, 12> kJointKeys{"/experiment/normal_stress_mpa",
                                                      "/experiment/loading/shear_rate_mm_per_s",
                                                      "/experiment/stop/shear_displacement_mm",
                                                      "/joint/profile",
                                                      "/joint/end_gap_mm",
                                                      "/joint/points_mm",
                                                      "/joint/lower_height_mm",
                                                      "/joint/upper_height_mm",
                                                      "/joint/damage_depth_lower_mm",
                                                      "/joint/damage_depth_upper_mm",
                                                      "/joint/coarse_edge_mm",
                                                      "/joint/breakable"};
constexpr std::array<std::string_view, 9> kPlatenKeys{"/experiment/platens/friction_coefficient",
                                                      "/experiment/platens/stiffness_mpa_per_mm",
                                                      "/experiment/loading/closing_rate_mm_per_s",
                                                      "/experiment/loading/rate_control/enabled",
                                                      "/experiment/loading/rate_control/kinetic_ratio_bound",
                                                      "/experiment/loading/rate_control/slowest_rate_factor",
                                                      "/experiment/loading/rate_control/fastest_rate_factor",
                                                      "/experiment/loading/elastic_start_fraction",
                                                      "/experiment/stop/axial_strain"};

std::vector<ConditionalKey> joint_and_platen_keys() {
  std::vector<ConditionalKey> keys;
  for (const std::string_view key : kJointKeys) {
    keys.push_back(
        {key, kType, is_shear, "only in direct shear", "remove it, or set /experiment/type to \"direct_shear\""});
  }
  for (const std::string_view key : kPlatenKeys) {
    keys.push_back({key, kType, has_platens, "only in tests between platens",
                    "remove it: a joint's halves are bonded to rigid blocks; it has loading/shear_rate_mm_per_s and "
                    "stop/shear_displacement_mm"});
  }
  return keys;
}

}  // namespace

const std::vector<ConditionalKey>& conditional_keys() {
  constexpr std::string_view compression = "only in uniaxial and triaxial compression";
  constexpr std::string_view triaxial = "only in a triaxial test";
  constexpr std::string_view disc = "only for a Brazilian disc";
  constexpr std::string_view staged = "only in staged loading";
  constexpr std::string_view continuous = "only in continuous loading";
  constexpr std::string_view size_hint = "a Brazilian disc has diameter_mm";
  constexpr std::string_view gauge_hint = "remove it: a disc has no gauges and no modulus";
  constexpr std::string_view staged_hint = "remove it, or set /experiment/loading/mode to \"staged\"";
  constexpr std::string_view stage_hint = "remove it, or set /experiment/loading/mode to \"continuous\"";
  constexpr std::string_view shear = "only in direct shear";
  constexpr std::string_view platens = "only in tests between platens";
  static const std::vector<ConditionalKey> table = [&] {
    std::vector<ConditionalKey> keys{
        {"/experiment/width_mm", kType, is_compression, compression, size_hint},
        {"/experiment/height_mm", kType, is_compression, compression, size_hint},
        {"/experiment/diameter_mm", kType, is_disc, disc, "compression has width_mm and height_mm"},
        {"/experiment/confining_pressure_mpa", kType, is_triaxial, triaxial,
         "remove it, or set /experiment/type to \"triaxial\""},
        {"/material/cohesion_mpa", kType, is_shear, shear, "remove it: only a joint's closed forms use it"},
        {"/material/friction_angle_deg", kType, is_shear, shear, "remove it: only a joint's closed forms use it"},
        {"/experiment/loading/mode", kType, has_platens, platens, "remove it: a joint is sheared continuously"},
        {"/experiment/platens/shape", kType, is_disc, disc, "remove it: the ends of a compression specimen are level"},
        {"/experiment/platens/jaw_radius_mm", kType, is_disc, disc, "remove it: only a disc has jaws"},
        {"/experiment/platens/jaw_radius_mm", kShape, has_jaws, "only with curved jaws",
         "remove it, or set /experiment/platens/shape to \"curved\""},
        {"/experiment/loading/confinement_time_s", kType, has_first_stage, "only in triaxial tests and direct shear",
         "remove it: there is no confinement"},
        {"/experiment/loading/ramp_time_s", kType, starts_from_rest, "only for a Brazilian disc and in direct shear",
         "remove it: compression starts from a linear velocity field"},
        {"/experiment/loading/ramp_time_s", kMode, is_continuous, continuous, "remove it: stages have no ramp"},
        {"/experiment/loading/stage_displacement_mm", kMode, is_staged, staged, staged_hint},
        {"/experiment/loading/hold_kinetic_ratio", kMode, has_holds,
         "only in staged loading, a triaxial test's confinement and a joint's", staged_hint},
        {"/experiment/loading/hold_time_s", kMode, is_staged, staged, staged_hint},
        {"/experiment/loading/rate_control/enabled", kMode, is_continuous, continuous, stage_hint},
        {"/experiment/loading/rate_control/kinetic_ratio_bound", kMode, is_continuous, continuous, stage_hint},
        {"/experiment/loading/rate_control/slowest_rate_factor", kMode, is_continuous, continuous, stage_hint},
        {"/experiment/loading/rate_control/fastest_rate_factor", kMode, is_continuous, continuous, stage_hint},
        {"/experiment/loading/elastic_start_fraction", kMode, is_continuous, continuous, stage_hint},
        {"/experiment/loading/unloading", kMode, is_continuous, continuous, stage_hint},
        {"/contacts/shear_fracture_energy_n_per_mm", kReading, is_default_law, "only under the default law",
         "remove it, or set /contacts/law/reading to \"default\": the literal law drops at its shear peak"},
        {"/contacts/law/form", kReading, is_default_law, "only under the default law",
         "remove it, or set /contacts/law/reading to \"default\": the literal law has one form"},
        {"/measurement/peak_strain_limit", kType, has_platens, platens,
         "remove it: a joint's peak is that of the whole curve"},
        {"/particles/kind", kType, has_platens, platens, "remove it: a joint's particles are triangles"},
        {"/particles/grain_size_mm", kKind, is_voronoi, "only for voronoi grains",
         "remove it, or set /particles/kind to \"voronoi\""},
        {"/measurement/axial_gauge_mm", kType, is_compression, compression, gauge_hint},
        {"/measurement/lateral_gauge_mm", kType, is_compression, compression, gauge_hint},
        {"/measurement/modulus_window", kType, is_compression, compression, gauge_hint},
    };
    const std::vector<ConditionalKey> shared = joint_and_platen_keys();
    keys.insert(keys.end(), shared.begin(), shared.end());
    return keys;
  }();
  return table;
}

bool applies(const RunConfig& config, std::string_view pointer) {
  const auto& keys = conditional_keys();
  return std::none_of(keys.begin(), keys.end(),
                      [&](const ConditionalKey& key) { return key.pointer == pointer && !key.applies(config); });
}

}  // namespace asperity
