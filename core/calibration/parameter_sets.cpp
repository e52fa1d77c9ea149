#include <algorithm>
#include <thread>

#include "core/calibration/elastic_json.hpp"
#include "core/calibration/simulated_parts.hpp"

namespace asperity {
namespace {

Settings factor_settings(const std::vector<Factor>& factors, const std::vector<double>& real) {
  Settings settings;
  for (std::size_t j = 0; j < factors.size(); ++j) settings.emplace_back(factors[j].pointer, real[j]);
  return settings;
}

Settings stiffness_settings(const ElasticPart& elastic, PlaneCondition plane) {
  const ContactStiffness contacts = answer_in_plane(elastic.task, elastic.found, plane);
  return {{"/contacts/tensile_stiffness_mpa_per_mm", contacts.k_t},
          {"/contacts/shear_stiffness_mpa_per_mm", contacts.k_s()}};
}

}  // namespace

ParameterSet parameter_set(const ElasticPart& elastic, const std::vector<Factor>& factors,
                           const std::vector<double>& real) {
  constexpr double kMpaPerGpa = 1000.0;
  const Elasticity particle = elastic.found.answer().particle;
  ParameterSet set;
  set.common = factor_settings(factors, real);
  set.common.emplace_back("/particles/youngs_modulus_gpa", particle.youngs_modulus / kMpaPerGpa);
  set.common.emplace_back("/particles/poissons_ratio", particle.poissons_ratio);
  set.stress = stiffness_settings(elastic, PlaneCondition::stress);
  set.strain = stiffness_settings(elastic, PlaneCondition::strain);
  return set;
}

ElasticPart compensate(const SimulatedCalibration& c, const std::vector<double>& real) {
  ElasticPart elastic{c.elastic, {}};
  const SuiteTest& test = c.suite.uniaxial();
  elastic.task.config = configure(test, {factor_settings(c.factors, real), {}, {}}, test.config.particles.seed);
  elastic.task.threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  elastic.found = compensate_elasticity(elastic.task);
  return elastic;
}

}  // namespace asperity
