#include "core/calibration/elastic_json.hpp"

#include <algorithm>

#include "core/base/units.hpp"

namespace asperity {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(ElasticUnknowns unknowns) {
  switch (unknowns) {
    case ElasticUnknowns::particle:
      return "particle_youngs_modulus, particle_poissons_ratio";
    case ElasticUnknowns::ratio:
      return "particle_youngs_modulus, stiffness_ratio";
    case ElasticUnknowns::modulus:
      return "particle_youngs_modulus";
  }
  return "";
}

Json figures(const ElasticStep& step) {
  return {{"particle_youngs_modulus_gpa", step.particle.youngs_modulus / units::kMpaPerGpa},
          {"particle_poissons_ratio", step.particle.poissons_ratio},
          {"stiffness_ratio", step.contacts.ratio},
          {"youngs_modulus_gpa", step.assembly.youngs_modulus / units::kMpaPerGpa},
          {"poissons_ratio", step.assembly.poissons_ratio}};
}

Json gpa(Elasticity e) {
  return {{"youngs_modulus_gpa", e.youngs_modulus / units::kMpaPerGpa}, {"poissons_ratio", e.poissons_ratio}};
}

Json alternative_json(const ElasticAlternative& a) {
  Json j{{"name", a.name}, {"edge_mm", a.edge_mm}};
  j.update(figures(a.step));
  j["tensile_stiffness_mpa_per_mm"] = a.step.contacts.k_t;
  j["reached"] = a.reached;
  return j;
}

/// How the answer was read: what a reader needs to judge it.
void add_reading(Json& j, const ElasticTask& task, const ElasticCompensation& found) {
  double separation = 0.0, step = found.specimens.front().critical_time_step_s;
  bool reached = true;
  Json values = Json::array();
  for (const AssemblyElasticity& s : found.specimens) {
    separation = std::max(separation, s.separation);
    step = std::min(step, s.critical_time_step_s);
    reached = reached && s.window_reached;
    values.push_back({{"youngs_modulus_gpa", s.youngs_modulus_gpa}, {"poissons_ratio", s.poissons_ratio}});
  }
  const StressWindow window = found.specimens.front().window;
  j["assembly_sd"] = gpa(elasticity_scatter(found.specimens));
  j["specimens"] = values;
  j["seeds"] = task.seeds;
  j["reading"] = task.reading == ElasticReading::window ? "window" : "initial";
  j["window_mpa"] = task.reading == ElasticReading::window ? Json({window.low, window.high}) : Json();
  j["window_reached"] = reached;
  j["largest_separation"] = separation;
  j["critical_time_step_s"] = step;
}

}  // namespace

ContactStiffness answer_in_plane(const ElasticTask& task, const ElasticCompensation& found, PlaneCondition plane) {
  const double k_t = stiffness_by_rule(task.stiffness, target_material(task), task.config.particles.edge_mm, plane).k_t;
  return {k_t, found.answer().contacts.ratio};
}

Json elastic_json(const ElasticTask& task, const ElasticCompensation& found,
                  const std::vector<ElasticAlternative>& alternatives) {
  const ElasticStep& answer = found.answer();
  const ContactStiffness stress = answer_in_plane(task, found, PlaneCondition::stress);
  const ContactStiffness strain = answer_in_plane(task, found, PlaneCondition::strain);
  Json j;
  j["rule"] = rule_name(task.stiffness.rule);
  j["multiple"] = task.stiffness.rule == StiffnessRule::multiple ? Json(task.stiffness.multiple) : Json();
  j["particle_youngs_modulus_gpa"] = answer.particle.youngs_modulus / units::kMpaPerGpa;
  j["particle_poissons_ratio"] = answer.particle.poissons_ratio;
  j["tensile_stiffness_mpa_per_mm"] = {{"stress", stress.k_t}, {"strain", strain.k_t}};
  j["shear_stiffness_mpa_per_mm"] = {{"stress", stress.k_s()}, {"strain", strain.k_s()}};
  j["stiffness_ratio"] = answer.contacts.ratio;
  j["edge_mm"] = task.config.particles.edge_mm;
  j["plane"] = task.config.experiment.plane == PlaneCondition::stress ? "stress" : "strain";
  j["assembly"] = gpa(answer.assembly);
  j["unknowns"] = name_of(found.unknowns);
  j["reached"] = found.reached;
  add_reading(j, task, found);
  j["steps"] = Json::array();
  for (const ElasticStep& step : found.steps) j["steps"].push_back(figures(step));
  j["alternatives"] = Json::array();
  for (const ElasticAlternative& a : alternatives) j["alternatives"].push_back(alternative_json(a));
  return j;
}

}  // namespace asperity
