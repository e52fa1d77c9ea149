#include "core/calibration/elastic_alternatives.hpp"

#include <fmt/format.h>

#include "core/base/units.hpp"

namespace asperity {
namespace {

ElasticTask at_edge(ElasticTask task, double edge_mm) {
  ParticleConfig& p = task.config.particles;
  p.edge_deviation_mm = p.edge_deviation() * edge_mm / p.edge_mm;
  p.edge_mm = edge_mm;
  return task;
}

ElasticAlternative uncompensated(const ElasticTask& task) {
  const double edge = task.config.particles.edge_mm;
  const Elasticity own{task.target.youngs_modulus_gpa * units::kMpaPerGpa, task.target.poissons_ratio};
  const ContactStiffness contacts =
      stiffness_by_rule({StiffnessRule::closed_form}, target_material(task), edge, task.config.experiment.plane);
  const Elasticity assembly = mean_elasticity(read_specimens(task, own, contacts));
  return {fmt::format("Eqs 12, 13 with E_p = E, nu_p = nu, {:g} mm", edge),
          edge,
          {own, contacts, assembly},
          elastic_misfit(assembly, task.target) <= task.tolerance};
}

ElasticAlternative compensated(const ElasticTask& task, const std::string& name) {
  const ElasticCompensation found = compensate_elasticity(task);
  const double edge = task.config.particles.edge_mm;
  return {fmt::format("{}, {:g} mm", name, edge), edge, found.answer(), found.reached};
}

ElasticAlternative particles_alone(ElasticTask task) {
  task.stiffness.rule = StiffnessRule::closed_form;
  task.ratio = RatioPolicy::fixed;
  return compensated(task, "Eqs 12, 13, E_p and nu_p alone compensated");
}

ElasticAlternative other_rule(ElasticTask task) {
  const bool to_multiple = task.stiffness.rule == StiffnessRule::closed_form;
  task.stiffness.rule = to_multiple ? StiffnessRule::multiple : StiffnessRule::closed_form;
  const std::string multiple = fmt::format("k_t = {:g} E/d, all compensated", task.stiffness.multiple);
  return compensated(task, to_multiple ? multiple : "Eqs 12, 13, all compensated");
}

}  // namespace

std::vector<ElasticAlternative> elastic_alternatives(const ElasticTask& task) {
  ElasticTask one_seed = task;
  one_seed.seeds.resize(1);
  const ElasticTask half = at_edge(one_seed, 0.5 * task.config.particles.edge_mm);
  return {uncompensated(one_seed), particles_alone(one_seed), uncompensated(half), particles_alone(half),
          other_rule(one_seed)};
}

}  // namespace asperity
