#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "core/config/applicability.hpp"
#include "core/config/bindings.hpp"
#include "core/config/write_config.hpp"
#include "fault_finder.hpp"

using namespace asperity;
using namespace asperity::test;
using nlohmann::json;

namespace {

/// A measured curve must be there; what it holds is not the configuration's.
std::filesystem::path folder_with_measured_file() {
  const auto folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / "config";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "lab.csv") << "axial_strain,axial_stress_mpa\n0,0\n";
  return folder;
}

/// A configuration in which every optional member is set and no member that has a meaning is at its default.
RunConfig unusual() {
  return parse_run_config(R"({
    "name": "odd-1", "description": "caf\u00e9 \"x\"",
    "experiment": {"type": "triaxial", "plane": "strain", "width_mm": 50.1, "height_mm": 100.3, "thickness_mm": 2,
      "confining_pressure_mpa": 0.7, "platens": {"friction_coefficient": 0.1, "stiffness_mpa_per_mm": 1234.5},
      "loading": {"mode": "staged", "closing_rate_mm_per_s": 11, "stage_displacement_mm": 0.03,
                  "hold_kinetic_ratio": 1e-5, "hold_time_s": 0.001, "confinement_time_s": 0.002},
      "stop": {"axial_strain": 0.04, "fraction_of_peak": 0.5, "time_s": 0.3}},
    "material": {"youngs_modulus_gpa": 2.2, "poissons_ratio": 0.1, "mode_i_toughness_mpa_sqrt_m": 1,
      "mode_ii_toughness_mpa_sqrt_m": 2, "tensile_strength_mpa": 3, "beta": 0.2},
    "particles": {"kind": "voronoi", "edge_mm": 1.1, "edge_deviation_mm": 0.1, "grain_size_mm": 3.3,
      "seed": 9007199254740991, "youngs_modulus_gpa": 5, "poissons_ratio": -0.3, "density_kg_per_m3": 2700},
    "contacts": {"tensile_stiffness_mpa_per_mm": 3000, "shear_stiffness_mpa_per_mm": 900, "tensile_strength_mpa": 5,
      "cohesion_mpa": 6, "friction_angle_deg": 30, "fracture_energy_n_per_mm": 0.1,
      "law": {"reading": "literal", "shear_peak": "coulomb", "opening_shear_stiffness": "k_s"},
      "general": {"enabled": false, "damping_ratio": 0.1,
        "outline": {"friction_angle_deg": 20, "normal_stiffness_mpa_per_mm": 100, "shear_stiffness_mpa_per_mm": 50},
        "fracture": {"friction_angle_deg": 25, "normal_stiffness_mpa_per_mm": 200, "shear_stiffness_mpa_per_mm": 80}}},
    "integration": {"safety_factor": 0.6, "time_step_s": 1e-8, "local_damping": 0.3, "mass_scaling_time_step_s": 0,
      "mass_scaling": {"uniform": true, "time_step_factor": 1.7, "added_mass_bound": 0.3}, "guard_interval_steps": 50},
    "measurement": {"samples": 500, "axial_gauge_mm": 50, "lateral_gauge_mm": 10,
      "modulus_window": [0.1, 0.30000000000000004], "peak_strain_limit": 0.01},
    "output": {"frames": 12, "fields": ["displacement", "shear_stress"], "width_px": 800, "height_px": 600,
      "checkpoint_interval_s": 1, "measured_curve": "lab.csv", "measured_name": "laboratory"}})",
                          folder_with_measured_file() / "x.json");
}

RunConfig again(const RunConfig& config) { return parse_run_config(effective_json(config), "other name.json"); }

}  // namespace

TEST_CASE("the effective configuration reads back to the same one") {
  for (const std::string& text : {kDisc, kUniaxial, kTriaxial}) {
    const RunConfig config = parse_run_config(text, "run.json");
    CHECK(again(config) == config);
  }
  const RunConfig plane_stress = parse_run_config(kUniaxial, "run.json", {"/experiment/plane=stress"});
  CHECK(again(plane_stress) == plane_stress);
  const RunConfig split = parse_run_config(kDisc, "run.json", {"/contacts/law/form=cohesive_frictional"});
  CHECK(split.contacts.law.form == LawForm::cohesive_frictional);
  CHECK(again(split) == split);
  CHECK(config_hash(split) != config_hash(parse_run_config(kDisc, "run.json")));
  CHECK(again(unusual()) == unusual());
  CHECK(effective_json(again(unusual())) == effective_json(unusual()));
}

TEST_CASE("every key that has a meaning is written, with its default; unset and meaningless ones are not") {
  const json disc = json::parse(effective_json(parse_run_config(kDisc, "run.json")));
  for (const Binding& binding : bindings()) {
    INFO(binding.pointer);
    const bool expected = applies({}, binding.pointer) && !binding.write({}).is_null();
    CHECK(disc.contains(json::json_pointer(std::string(binding.pointer))) == expected);
  }
  CHECK(disc.at("contacts").at("law").at("reading") == "default");
  CHECK_FALSE(disc.at("experiment").contains("width_mm"));
  CHECK_FALSE(disc.at("integration").contains("time_step_s"));
  RunConfig all = unusual();
  all.mechanisms = {{"of_the_library", 0.5, {{"a_parameter", 2.0}}}};  // which only core/mechanism could read back
  const json odd = json::parse(effective_json(all));
  CHECK(odd.at("mechanisms") == json::parse(R"([{"type": "of_the_library", "amplitude": 0.5, "a_parameter": 2.0}])"));
  for (const Binding& binding : bindings()) {
    INFO(binding.pointer);
    CHECK(odd.contains(json::json_pointer(std::string(binding.pointer))) == applies(unusual(), binding.pointer));
  }
}

TEST_CASE("keys stand in the order of the bindings") {
  const std::string text = effective_json(unusual());
  CHECK(text.find("\"name\"") < text.find("\"experiment\""));
  CHECK(text.find("\"experiment\"") < text.find("\"material\""));
  CHECK(text.find("\"width_mm\"") < text.find("\"confining_pressure_mpa\""));
  CHECK(text.find("\"contacts\"") < text.find("\"output\""));
}

TEST_CASE("the hash changes with every key that a result may depend on") {
  const std::string base = config_hash(unusual());
  CHECK(base.size() == 64);
  CHECK(base == config_hash(again(unusual())));
  const RunConfig triangles;  // another configuration of which to take each member
  for (const Binding& binding : bindings()) {
    INFO(binding.pointer);
    RunConfig changed = unusual();
    json value = binding.write(triangles);
    if (value.is_null() && !applies(unusual(), binding.pointer)) continue;  // any value there would be refused
    if (value.is_null() && binding.pointer.starts_with("/output/measured_")) value = "other";
    if (value.is_null()) value = binding.pointer.find("law") == std::string::npos ? json(0.125) : json();
    if (value.is_null()) value = binding.pointer.ends_with("shear_peak") ? "cohesion" : "k_t";
    binding.read(changed, value);
    const bool changes_no_result = binding.pointer == "/name" || binding.pointer == "/description" ||
                                   binding.pointer == "/output/checkpoint_interval_s" ||
                                   binding.pointer.starts_with("/output/measured_");
    const bool relevant = !changes_no_result && applies(unusual(), binding.pointer);
    CHECK((config_hash(changed) != base) == relevant);
  }
}
