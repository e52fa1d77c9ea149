#pragma once
#include <cstdint>
#include <vector>

#include "core/calibration/assembly_elasticity.hpp"
#include "core/calibration/contact_stiffness.hpp"

namespace asperity {

/// What the assembly is to show.
struct ElasticTarget {
  double youngs_modulus_gpa = 0, poissons_ratio = 0;
  double uniaxial_strength_mpa = 0;  ///< Places the modulus window.
};

/// Where the microparameters may lie.
struct ElasticBounds {
  double least_poissons_ratio = 0.0;  ///< Of the particles: no material's is below it but for foams and crystals.
  double greatest_poissons_ratio =
      0.35;                            ///< In plane strain 0.5 locks a constant-strain triangle; 0.35 is far from it.
  double least_stiffness_ratio = 0.1;  ///< k_s / k_t
  double greatest_stiffness_ratio = 1.0;
  double greatest_modulus_factor = 20.0;  ///< E_p over the target's E: particles then share 5 % of the compliance.
};

/// Whether k_s / k_t may leave its rule where E_p and nu_p cannot reach the target.
enum class RatioPolicy { floats, fixed };

/// The search goes on to this share of the tolerance, so that fresh seeds' scatter has the rest.
inline constexpr double kStopShare = 0.2;

/// A compensation to be solved.
struct ElasticTask {
  RunConfig config;  ///< A uniaxial test: geometry, edge, plane, law and strengths count; E_p, nu_p, k_t, k_s do not.
  ElasticTarget target;
  ContactStiffnessRule stiffness;
  RatioPolicy ratio = RatioPolicy::floats;
  ElasticReading reading = ElasticReading::window;
  std::vector<std::uint64_t> seeds{1, 2, 3};  ///< Specimens whose mean counts.
  ElasticBounds bounds;
  double tolerance = 0.005;  ///< On E and nu, relative; Eq. (K33).
  int most_steps = 12;
  int threads = 1;  ///< Specimens read at the same time; no figure depends on it.
};

/// Particles and contacts, and what the assembly showed with them: means over the seeds.
struct ElasticStep {
  Elasticity particle;  ///< MPa
  ContactStiffness contacts;
  Elasticity assembly;  ///< MPa
};

/// Which unknowns the search ended with.
enum class ElasticUnknowns {
  particle,  ///< E_p and nu_p.
  ratio,     ///< E_p and k_s / k_t; nu_p held at a bound.
  modulus    ///< E_p alone; the rest held at bounds.
};

/// The outcome: its last step is the answer.
struct ElasticCompensation {
  std::vector<ElasticStep> steps;
  std::vector<AssemblyElasticity> specimens;  ///< The last step's, one a seed.
  ElasticUnknowns unknowns = ElasticUnknowns::particle;
  bool reached = false;  ///< E and nu within the tolerance, in the mean.
  const ElasticStep& answer() const { return steps.back(); }
};

/// Solves for E_p and nu_p, or with nu_p held at a bound for E_p and k_s / k_t, until the assembly shows the target in
/// the mean of the seeds; Eqs. (K32), (K33). Throws a config error for a task that has no meaning.
ElasticCompensation compensate_elasticity(const ElasticTask& task);

/// The specimens of all seeds with given particles and contacts, in the order of the seeds.
std::vector<AssemblyElasticity> read_specimens(const ElasticTask& task, Elasticity particle,
                                               const ContactStiffness& contacts);

/// Mean over specimens, MPa.
Elasticity mean_elasticity(const std::vector<AssemblyElasticity>& specimens);

/// Standard deviation over specimens (n - 1), MPa; 0 for a single one.
Elasticity elasticity_scatter(const std::vector<AssemblyElasticity>& specimens);

/// Larger of the relative misses of E and nu, Eq. (K33).
double elastic_misfit(Elasticity assembly, const ElasticTarget& target);

/// The material of the task's closed forms and rules: the configuration's with the target's E and nu.
MaterialConfig target_material(const ElasticTask& task);

}  // namespace asperity
