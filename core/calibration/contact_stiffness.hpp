#pragma once
#include <string_view>

#include "core/calibration/elastic_estimate.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// Where the contacts' stiffness comes from.
enum class StiffnessRule {
  closed_form,  ///< Eqs 12, 13 of the material, ratio of Eq 14 corrected.
  multiple      ///< A multiple of the material's E over the edge length, Eq. (K28); ratio of Eq 14 corrected.
};

/// "closed_form", "multiple".
std::string_view rule_name(StiffnessRule rule);

/// A rule and, for `multiple`, its n. The paper's text asks for ten ("one order above E/d_p"; its Table 5 has four).
struct ContactStiffnessRule {
  StiffnessRule rule = StiffnessRule::closed_form;
  double multiple = 10.0;
};

/// Stiffness by the rule for a material, an edge length (mm) and a plane condition.
ContactStiffness stiffness_by_rule(const ContactStiffnessRule& rule, const MaterialConfig& material, double edge_mm,
                                   PlaneCondition plane);

/// Stiffness (MPa/mm) at another edge length: stiffness times edge length is kept, Eq. (K31), and with it the
/// elasticity of the assembly.
double stiffness_at_edge(double stiffness, double edge_mm, double other_edge_mm);

/// The configuration with these particles and contacts.
RunConfig with_elasticity(RunConfig config, Elasticity particle, const ContactStiffness& contacts);

}  // namespace asperity
