#pragma once
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/base/error.hpp"
#include "core/confrontation/confrontation_config.hpp"

namespace asperity::testing {

using nlohmann::json;

/// A folder with a measured file and the file of a confrontation, which tests change.
class ConfrontationFolder {
 public:
  explicit ConfrontationFolder(const std::string& name)
      : root_(std::filesystem::path(ASPERITY_TEST_SCRATCH) / "confrontation" / name) {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
  }

  const std::filesystem::path& root() const { return root_; }
  void put(const std::string& name, const json& document) const { std::ofstream(root_ / name) << document.dump(1); }

  ConfrontationConfig read(const json& document, const std::vector<std::string>& overrides = {}) const {
    put("data.json", measured);
    put("confront.json", document);
    return read_confrontation(root_ / "confront.json", overrides);
  }

  /// The faults of the file; none where it is accepted.
  std::vector<Fault> faults(const json& document) const {
    try {
      read(document);
    } catch (const Error& error) {
      return error.faults();
    }
    return {};
  }

  /// Compression, disc and joint; the uniaxial test leaves its size out.
  json measured = json::parse(R"({"name": "D17", "tests": [
    {"id": "U", "experiment": "uniaxial", "results": {"peak_axial_stress_mpa": [4.1, 4.3]}},
    {"id": "T1", "experiment": "triaxial", "width_mm": 40, "height_mm": 40, "confining_pressure_mpa": 1,
     "axial_gauge_mm": 25, "results": {"peak_axial_stress_mpa": [8.0]}},
    {"id": "B", "experiment": "brazilian", "diameter_mm": 48, "results": {"tensile_strength_mpa": [1.6]}},
    {"id": "J", "experiment": "direct_shear", "profile": [{"angle_deg": 25, "height_mm": 4, "gap_before_mm": 3}],
     "end_gap_mm": 2, "normal_stress_mpa": 1.5, "results": {"peak_shear_stress_mpa": [2.0]}}]})");

 private:
  std::filesystem::path root_;
};

inline json run_base(const std::string& type, double tensile_stiffness) {
  return {{"experiment", {{"type", type}}},
          {"particles", {{"edge_mm", 4.0}, {"youngs_modulus_gpa", 3.5}, {"poissons_ratio", 0.1}}},
          {"contacts",
           {{"tensile_stiffness_mpa_per_mm", tensile_stiffness},
            {"tensile_strength_mpa", 1.2},
            {"cohesion_mpa", 1.3},
            {"friction_angle_deg", 33.0}}}};
}

inline json confrontation() {
  json joint = run_base("direct_shear", 5200.0);
  joint["particles"]["edge_mm"] = 1.25;
  joint["joint"]["points_mm"] =
      json::array({json::array({0.0, 0.0}), json::array({9.0, 1.0}), json::array({20.0, 0.0})});
  json document = {{"$schema", "../schema/confrontation.schema.json"},
                   {"name", "case"},
                   {"measured", "data.json"},
                   {"bases",
                    {{"uniaxial", run_base("uniaxial", 1600.0)},
                     {"brazilian", run_base("brazilian", 1600.0)},
                     {"direct_shear", joint}}},
                   {"assumed", {{"width_mm", 50}, {"height_mm", 100}, {"why", "usual in that laboratory"}}}};
  document["parameters"] = json::parse(R"([
    {"name": "c_c", "pointer": "/contacts/cohesion_mpa", "step": 0.08, "lower": 0.5, "upper": 3},
    {"name": "phi_c", "pointer": "/contacts/friction_angle_deg", "transform": "tangent", "step": 0.05, "lower": 15,
     "upper": 50},
    {"name": "E_p", "pointer": "/particles/youngs_modulus_gpa", "tied": ["/contacts/tensile_stiffness_mpa_per_mm"],
     "step": 0.08, "lower": 1, "upper": 9}])");
  return document;
}

}  // namespace asperity::testing
