#include "core/config/bindings.hpp"

#include <optional>

#include "core/config/enum_words.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {

using nlohmann::json;

namespace {

template <class T>
void read_value(const json& value, T& member) {
  if constexpr (ConfigEnum<T>)
    member = from_word<T>(value.get<std::string>());
  else
    member = value.get<T>();
}
template <class T>
void read_value(const json& value, std::optional<T>& member) {
  read_value(value, member.emplace());
}

template <class T>
json write_value(const T& member) {
  if constexpr (ConfigEnum<T>)
    return std::string(word(member));
  else
    return member;
}
template <class T>
json write_value(const std::optional<T>& member) {
  return member ? write_value(*member) : json();
}

/// Binds a JSON pointer to the member that the chain of member pointers leads to.
template <auto... Members>
Binding bind(std::string_view pointer) {
  return {pointer, [](RunConfig& config, const json& value) { read_value(value, (config.*....*Members)); },
          [](const RunConfig& config) { return write_value((config.*....*Members)); }};
}

void read_modulus_window(RunConfig& config, const json& value) {
  config.measurement.modulus_window_low = value.at(0).get<double>();
  config.measurement.modulus_window_high = value.at(1).get<double>();
}
json write_modulus_window(const RunConfig& config) {
  return json::array({config.measurement.modulus_window_low, config.measurement.modulus_window_high});
}

void read_unloading(RunConfig& config, const json& value) {
  config.experiment.loading.unloading.clear();
  for (const json& loop : value) {
    UnloadingConfig u;
    u.at_mm = loop.value("at_mm", u.at_mm);
    u.stress_ratio = loop.value("stress_ratio", u.stress_ratio);
    config.experiment.loading.unloading.push_back(u);
  }
}
json write_unloading(const RunConfig& config) {
  if (config.experiment.loading.unloading.empty()) return {};
  json loops = json::array();
  for (const UnloadingConfig& u : config.experiment.loading.unloading) {
    loops.push_back({{"at_mm", u.at_mm}, {"stress_ratio", u.stress_ratio}});
  }
  return loops;
}

void read_profile(RunConfig& config, const json& value) {
  config.joint.profile.clear();
  for (const json& tooth : value) {
    ToothConfig t;
    t.angle_deg = tooth.value("angle_deg", t.angle_deg);
    t.height_mm = tooth.value("height_mm", t.height_mm);
    t.gap_before_mm = tooth.value("gap_before_mm", t.gap_before_mm);
    config.joint.profile.push_back(t);
  }
}
json write_profile(const RunConfig& config) {
  json teeth = json::array();
  for (const ToothConfig& t : config.joint.profile) {
    teeth.push_back({{"angle_deg", t.angle_deg}, {"height_mm", t.height_mm}, {"gap_before_mm", t.gap_before_mm}});
  }
  return teeth;
}

void read_points(RunConfig& config, const json& value) {
  config.joint.points_mm.clear();
  for (const json& point : value)
    config.joint.points_mm.push_back({point.at(0).get<double>(), point.at(1).get<double>()});
}
json write_points(const RunConfig& config) {
  if (config.joint.points_mm.empty()) return {};
  json points = json::array();
  for (const Vec2 p : config.joint.points_mm) points.push_back(json::array({p.x, p.y}));
  return points;
}

void read_mechanisms(RunConfig& config, const json& value) {
  config.mechanisms.clear();
  for (const json& entry : value) {
    MechanismConfig& m = config.mechanisms.emplace_back();
    for (const auto& [key, member] : entry.items()) {
      if (key == "type") {
        m.type = member.get<std::string>();
      } else if (key == "amplitude") {
        m.amplitude = member.get<double>();
      } else {
        m.parameters[key] = member.get<double>();
      }
    }
  }
}
json write_mechanisms(const RunConfig& config) {
  if (config.mechanisms.empty()) return {};
  json entries = json::array();
  for (const MechanismConfig& m : config.mechanisms) {
    json& entry = entries.emplace_back(json{{"type", m.type}});
    if (m.amplitude) entry["amplitude"] = *m.amplitude;
    for (const auto& [key, value] : m.parameters) entry[key] = value;
  }
  return entries;
}

const Binding* find_binding(std::string_view pointer) {
  for (const Binding& binding : bindings())
    if (binding.pointer == pointer) return &binding;
  return nullptr;
}

}  // namespace

const std::vector<Binding>& bindings() {
  using Run = RunConfig;
  using Experiment = ExperimentConfig;
  using Platens = PlatenConfig;
  using Loading = LoadingConfig;
  using RateControl = RateControlConfig;
  using Stop = StopConfig;
  using Joint = JointConfig;
  using Material = MaterialConfig;
  using Particles = ParticleConfig;
  using Contacts = ContactConfig;
  using Law = LawConfig;
  using General = GeneralContactConfig;
  using Surface = SurfaceConfig;
  using Integration = IntegrationConfig;
  using MassScaling = MassScalingConfig;
  using Measurement = MeasurementConfig;
  using Output = OutputConfig;
  static const std::vector<Binding> table{
      bind<&Run::name>("/name"),
      bind<&Run::description>("/description"),
      bind<&Run::experiment, &Experiment::type>("/experiment/type"),
      bind<&Run::experiment, &Experiment::plane>("/experiment/plane"),
      bind<&Run::experiment, &Experiment::width_mm>("/experiment/width_mm"),
      bind<&Run::experiment, &Experiment::height_mm>("/experiment/height_mm"),
      bind<&Run::experiment, &Experiment::diameter_mm>("/experiment/diameter_mm"),
      bind<&Run::experiment, &Experiment::thickness_mm>("/experiment/thickness_mm"),
      bind<&Run::experiment, &Experiment::confining_pressure_mpa>("/experiment/confining_pressure_mpa"),
      bind<&Run::experiment, &Experiment::normal_stress_mpa>("/experiment/normal_stress_mpa"),
      bind<&Run::experiment, &Experiment::platens, &Platens::shape>("/experiment/platens/shape"),
      bind<&Run::experiment, &Experiment::platens, &Platens::jaw_radius_mm>("/experiment/platens/jaw_radius_mm"),
      bind<&Run::experiment, &Experiment::platens, &Platens::friction_coefficient>(
          "/experiment/platens/friction_coefficient"),
      bind<&Run::experiment, &Experiment::platens, &Platens::stiffness_mpa_per_mm>(
          "/experiment/platens/stiffness_mpa_per_mm"),
      bind<&Run::experiment, &Experiment::loading, &Loading::mode>("/experiment/loading/mode"),
      bind<&Run::experiment, &Experiment::loading, &Loading::closing_rate_mm_per_s>(
          "/experiment/loading/closing_rate_mm_per_s"),
      bind<&Run::experiment, &Experiment::loading, &Loading::shear_rate_mm_per_s>(
          "/experiment/loading/shear_rate_mm_per_s"),
      bind<&Run::experiment, &Experiment::loading, &Loading::ramp_time_s>("/experiment/loading/ramp_time_s"),
      bind<&Run::experiment, &Experiment::loading, &Loading::stage_displacement_mm>(
          "/experiment/loading/stage_displacement_mm"),
      bind<&Run::experiment, &Experiment::loading, &Loading::hold_kinetic_ratio>(
          "/experiment/loading/hold_kinetic_ratio"),
      bind<&Run::experiment, &Experiment::loading, &Loading::hold_time_s>("/experiment/loading/hold_time_s"),
      bind<&Run::experiment, &Experiment::loading, &Loading::confinement_time_s>(
          "/experiment/loading/confinement_time_s"),
      bind<&Run::experiment, &Experiment::loading, &Loading::rate_control, &RateControl::enabled>(
          "/experiment/loading/rate_control/enabled"),
      bind<&Run::experiment, &Experiment::loading, &Loading::rate_control, &RateControl::kinetic_ratio_bound>(
          "/experiment/loading/rate_control/kinetic_ratio_bound"),
      bind<&Run::experiment, &Experiment::loading, &Loading::rate_control, &RateControl::slowest_rate_factor>(
          "/experiment/loading/rate_control/slowest_rate_factor"),
      bind<&Run::experiment, &Experiment::loading, &Loading::rate_control, &RateControl::fastest_rate_factor>(
          "/experiment/loading/rate_control/fastest_rate_factor"),
      bind<&Run::experiment, &Experiment::loading, &Loading::elastic_start_fraction>(
          "/experiment/loading/elastic_start_fraction"),
      {"/experiment/loading/unloading", read_unloading, write_unloading},
      bind<&Run::experiment, &Experiment::stop, &Stop::axial_strain>("/experiment/stop/axial_strain"),
      bind<&Run::experiment, &Experiment::stop, &Stop::shear_displacement_mm>("/experiment/stop/shear_displacement_mm"),
      bind<&Run::experiment, &Experiment::stop, &Stop::fraction_of_peak>("/experiment/stop/fraction_of_peak"),
      bind<&Run::experiment, &Experiment::stop, &Stop::time_s>("/experiment/stop/time_s"),
      {"/joint/profile", read_profile, write_profile},
      bind<&Run::joint, &Joint::end_gap_mm>("/joint/end_gap_mm"),
      {"/joint/points_mm", read_points, write_points},
      bind<&Run::joint, &Joint::lower_height_mm>("/joint/lower_height_mm"),
      bind<&Run::joint, &Joint::upper_height_mm>("/joint/upper_height_mm"),
      bind<&Run::joint, &Joint::damage_depth_lower_mm>("/joint/damage_depth_lower_mm"),
      bind<&Run::joint, &Joint::damage_depth_upper_mm>("/joint/damage_depth_upper_mm"),
      bind<&Run::joint, &Joint::coarse_edge_mm>("/joint/coarse_edge_mm"),
      bind<&Run::joint, &Joint::breakable>("/joint/breakable"),
      bind<&Run::material, &Material::youngs_modulus_gpa>("/material/youngs_modulus_gpa"),
      bind<&Run::material, &Material::poissons_ratio>("/material/poissons_ratio"),
      bind<&Run::material, &Material::mode_i_toughness_mpa_sqrt_m>("/material/mode_i_toughness_mpa_sqrt_m"),
      bind<&Run::material, &Material::mode_ii_toughness_mpa_sqrt_m>("/material/mode_ii_toughness_mpa_sqrt_m"),
      bind<&Run::material, &Material::tensile_strength_mpa>("/material/tensile_strength_mpa"),
      bind<&Run::material, &Material::beta>("/material/beta"),
      bind<&Run::material, &Material::cohesion_mpa>("/material/cohesion_mpa"),
      bind<&Run::material, &Material::friction_angle_deg>("/material/friction_angle_deg"),
      bind<&Run::particles, &Particles::kind>("/particles/kind"),
      bind<&Run::particles, &Particles::edge_mm>("/particles/edge_mm"),
      bind<&Run::particles, &Particles::edge_deviation_mm>("/particles/edge_deviation_mm"),
      bind<&Run::particles, &Particles::grain_size_mm>("/particles/grain_size_mm"),
      bind<&Run::particles, &Particles::seed>("/particles/seed"),
      bind<&Run::particles, &Particles::youngs_modulus_gpa>("/particles/youngs_modulus_gpa"),
      bind<&Run::particles, &Particles::poissons_ratio>("/particles/poissons_ratio"),
      bind<&Run::particles, &Particles::density_kg_per_m3>("/particles/density_kg_per_m3"),
      bind<&Run::contacts, &Contacts::tensile_stiffness_mpa_per_mm>("/contacts/tensile_stiffness_mpa_per_mm"),
      bind<&Run::contacts, &Contacts::shear_stiffness_mpa_per_mm>("/contacts/shear_stiffness_mpa_per_mm"),
      bind<&Run::contacts, &Contacts::tensile_strength_mpa>("/contacts/tensile_strength_mpa"),
      bind<&Run::contacts, &Contacts::cohesion_mpa>("/contacts/cohesion_mpa"),
      bind<&Run::contacts, &Contacts::friction_angle_deg>("/contacts/friction_angle_deg"),
      bind<&Run::contacts, &Contacts::fracture_energy_n_per_mm>("/contacts/fracture_energy_n_per_mm"),
      bind<&Run::contacts, &Contacts::shear_fracture_energy_n_per_mm>("/contacts/shear_fracture_energy_n_per_mm"),
      bind<&Run::contacts, &Contacts::law, &Law::reading>("/contacts/law/reading"),
      bind<&Run::contacts, &Contacts::law, &Law::form>("/contacts/law/form"),
      bind<&Run::contacts, &Contacts::law, &Law::shear_peak>("/contacts/law/shear_peak"),
      bind<&Run::contacts, &Contacts::law, &Law::opening_shear_stiffness>("/contacts/law/opening_shear_stiffness"),
      bind<&Run::contacts, &Contacts::general, &General::enabled>("/contacts/general/enabled"),
      bind<&Run::contacts, &Contacts::general, &General::damping_ratio>("/contacts/general/damping_ratio"),
      bind<&Run::contacts, &Contacts::general, &General::outline, &Surface::friction_angle_deg>(
          "/contacts/general/outline/friction_angle_deg"),
      bind<&Run::contacts, &Contacts::general, &General::outline, &Surface::normal_stiffness_mpa_per_mm>(
          "/contacts/general/outline/normal_stiffness_mpa_per_mm"),
      bind<&Run::contacts, &Contacts::general, &General::outline, &Surface::shear_stiffness_mpa_per_mm>(
          "/contacts/general/outline/shear_stiffness_mpa_per_mm"),
      bind<&Run::contacts, &Contacts::general, &General::fracture, &Surface::friction_angle_deg>(
          "/contacts/general/fracture/friction_angle_deg"),
      bind<&Run::contacts, &Contacts::general, &General::fracture, &Surface::normal_stiffness_mpa_per_mm>(
          "/contacts/general/fracture/normal_stiffness_mpa_per_mm"),
      bind<&Run::contacts, &Contacts::general, &General::fracture, &Surface::shear_stiffness_mpa_per_mm>(
          "/contacts/general/fracture/shear_stiffness_mpa_per_mm"),
      bind<&Run::integration, &Integration::safety_factor>("/integration/safety_factor"),
      bind<&Run::integration, &Integration::time_step_s>("/integration/time_step_s"),
      bind<&Run::integration, &Integration::local_damping>("/integration/local_damping"),
      bind<&Run::integration, &Integration::mass_scaling_time_step_s>("/integration/mass_scaling_time_step_s"),
      bind<&Run::integration, &Integration::guard_interval_steps>("/integration/guard_interval_steps"),
      bind<&Run::integration, &Integration::mass_scaling, &MassScaling::uniform>("/integration/mass_scaling/uniform"),
      bind<&Run::integration, &Integration::mass_scaling, &MassScaling::time_step_factor>(
          "/integration/mass_scaling/time_step_factor"),
      bind<&Run::integration, &Integration::mass_scaling, &MassScaling::added_mass_bound>(
          "/integration/mass_scaling/added_mass_bound"),
      bind<&Run::measurement, &Measurement::samples>("/measurement/samples"),
      bind<&Run::measurement, &Measurement::axial_gauge_mm>("/measurement/axial_gauge_mm"),
      bind<&Run::measurement, &Measurement::lateral_gauge_mm>("/measurement/lateral_gauge_mm"),
      {"/measurement/modulus_window", read_modulus_window, write_modulus_window},
      bind<&Run::measurement, &Measurement::peak_strain_limit>("/measurement/peak_strain_limit"),
      bind<&Run::output, &Output::frames>("/output/frames"),
      bind<&Run::output, &Output::fields>("/output/fields"),
      bind<&Run::output, &Output::width_px>("/output/width_px"),
      bind<&Run::output, &Output::height_px>("/output/height_px"),
      bind<&Run::output, &Output::checkpoint_interval_s>("/output/checkpoint_interval_s"),
      bind<&Run::output, &Output::measured_curve>("/output/measured_curve"),
      bind<&Run::output, &Output::measured_name>("/output/measured_name"),
      {"/mechanisms", read_mechanisms, write_mechanisms},
  };
  return table;
}

std::string value_text(const RunConfig& config, std::string_view pointer) {
  const Binding* binding = find_binding(pointer);
  const json value = binding ? binding->write(config) : json();
  if (value.is_null()) return {};
  return value.is_number_float() ? number_text(value.get<double>()) : value.dump();
}

bool differs_from_default(const RunConfig& config, std::string_view pointer) {
  static const RunConfig defaults;
  const Binding* binding = find_binding(pointer);
  return binding && binding->write(config) != binding->write(defaults);
}

}  // namespace asperity
