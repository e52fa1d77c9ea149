#include "core/calibration/contact_stiffness.hpp"

#include "core/base/units.hpp"
#include "core/contact/closed_forms.hpp"

namespace asperity {

std::string_view rule_name(StiffnessRule rule) {
  return rule == StiffnessRule::closed_form ? "closed_form" : "multiple";
}

ContactStiffness stiffness_by_rule(const ContactStiffnessRule& rule, const MaterialConfig& material, double edge_mm,
                                   PlaneCondition plane) {
  const double ratio = closed_forms::stiffness_ratio(material);
  if (rule.rule == StiffnessRule::closed_form) return {closed_forms::tensile_stiffness(material, plane), ratio};
  return {rule.multiple * material.youngs_modulus_gpa * units::kMpaPerGpa / edge_mm, ratio};
}

double stiffness_at_edge(double stiffness, double edge_mm, double other_edge_mm) {
  return stiffness * edge_mm / other_edge_mm;
}

RunConfig with_elasticity(RunConfig config, Elasticity particle, const ContactStiffness& contacts) {
  config.particles.youngs_modulus_gpa = particle.youngs_modulus / units::kMpaPerGpa;
  config.particles.poissons_ratio = particle.poissons_ratio;
  config.contacts.tensile_stiffness_mpa_per_mm = contacts.k_t;
  config.contacts.shear_stiffness_mpa_per_mm = contacts.k_s();
  return config;
}

}  // namespace asperity
