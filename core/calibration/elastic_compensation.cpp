#include "core/calibration/elastic_compensation.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <string>
#include <thread>

#include "core/base/error.hpp"
#include "core/base/units.hpp"
#include "core/calibration/elastic_search.hpp"

namespace asperity {
namespace {

/// body(i) for i in [0, n) on some threads; the exception of the least i is thrown on.
template <class Body>
void for_each_on_threads(std::size_t n, int threads, const Body& body) {
  std::vector<std::exception_ptr> failures(n);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < n; i = next++) {
      try {
        body(i);
      } catch (...) {
        failures[i] = std::current_exception();
      }
    }
  };
  std::vector<std::jthread> others;
  for (int t = 1; t < std::min<int>(threads, static_cast<int>(n)); ++t) others.emplace_back(work);
  work();
  others.clear();
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

void require(std::vector<Fault>& faults, bool good, const char* where, double value, const char* allowed) {
  if (!good)
    faults.push_back({where, "is outside what elastic compensation can use", std::to_string(value), allowed, ""});
}

void check(const ElasticTask& task) {
  const ElasticTarget& t = task.target;
  const ElasticBounds& b = task.bounds;
  std::vector<Fault> faults;
  require(faults, t.youngs_modulus_gpa > 0.0, "/targets/youngs_modulus_gpa", t.youngs_modulus_gpa, "above 0 GPa");
  require(faults, t.poissons_ratio >= 0.0 && t.poissons_ratio < 0.5, "/targets/poissons_ratio", t.poissons_ratio,
          "from 0 to below 0.5");
  require(faults, task.reading == ElasticReading::initial || t.uniaxial_strength_mpa > 0.0,
          "/targets/uniaxial_strength_mpa", t.uniaxial_strength_mpa, "above 0 MPa: it places the modulus window");
  require(faults, task.stiffness.multiple > 0.0, "/elastic/multiple", task.stiffness.multiple, "above 0");
  require(faults, task.tolerance > 0.0, "/elastic/tolerance", task.tolerance, "above 0");
  require(faults, !task.seeds.empty(), "/elastic/seeds", 0.0, "at least one seed");
  require(faults, task.most_steps > 0, "/elastic/most_steps", task.most_steps, "at least 1");
  require(faults,
          b.least_poissons_ratio > -1.0 && b.least_poissons_ratio <= b.greatest_poissons_ratio &&
              b.greatest_poissons_ratio < 0.5,
          "/elastic/poissons_ratio_bounds", b.least_poissons_ratio, "an interval inside -1 to 0.5");
  require(faults, b.least_stiffness_ratio > 0.0 && b.least_stiffness_ratio <= b.greatest_stiffness_ratio,
          "/elastic/stiffness_ratio_bounds", b.least_stiffness_ratio, "an interval above 0");
  require(faults, b.greatest_modulus_factor >= 1.0, "/elastic/greatest_modulus_factor", b.greatest_modulus_factor,
          "at least 1");
  if (!faults.empty()) throw Error(ErrorKind::config, faults);
}

}  // namespace

ElasticCompensation compensate_elasticity(const ElasticTask& task) {
  check(task);
  ElasticSearch search(task);
  ElasticCompensation result;
  for (int step = 0; step < task.most_steps; ++step) {
    const auto [particle, contacts] = search.trial();
    result.unknowns = search.unknowns();
    result.specimens = read_specimens(task, particle, contacts);
    const Elasticity assembly = mean_elasticity(result.specimens);
    result.steps.push_back({particle, contacts, assembly});
    if (elastic_misfit(assembly, task.target) <= kStopShare * task.tolerance || !search.advance(assembly)) break;
  }
  result.reached = elastic_misfit(result.answer().assembly, task.target) <= task.tolerance;
  return result;
}

std::vector<AssemblyElasticity> read_specimens(const ElasticTask& task, Elasticity particle,
                                               const ContactStiffness& contacts) {
  std::vector<AssemblyElasticity> specimens(task.seeds.size());
  for_each_on_threads(specimens.size(), task.threads, [&](std::size_t i) {
    RunConfig config = with_elasticity(task.config, particle, contacts);
    config.particles.seed = task.seeds[i];
    specimens[i] = read_assembly(config, task.reading, task.target.uniaxial_strength_mpa);
  });
  return specimens;
}

Elasticity mean_elasticity(const std::vector<AssemblyElasticity>& specimens) {
  Elasticity sum;
  for (const AssemblyElasticity& s : specimens) {
    sum.youngs_modulus += s.youngs_modulus_gpa * units::kMpaPerGpa;
    sum.poissons_ratio += s.poissons_ratio;
  }
  const double n = static_cast<double>(specimens.size());
  return {sum.youngs_modulus / n, sum.poissons_ratio / n};
}

Elasticity elasticity_scatter(const std::vector<AssemblyElasticity>& specimens) {
  if (specimens.size() < 2) return {};
  const Elasticity mean = mean_elasticity(specimens);
  Elasticity square;
  for (const AssemblyElasticity& s : specimens) {
    square.youngs_modulus += std::pow(s.youngs_modulus_gpa * units::kMpaPerGpa - mean.youngs_modulus, 2);
    square.poissons_ratio += std::pow(s.poissons_ratio - mean.poissons_ratio, 2);
  }
  const double n = static_cast<double>(specimens.size() - 1);
  return {std::sqrt(square.youngs_modulus / n), std::sqrt(square.poissons_ratio / n)};
}

double elastic_misfit(Elasticity assembly, const ElasticTarget& target) {
  constexpr double kLeastRatio =
      0.1;  // a relative miss of a smaller nu would ask for more digits than specimens scatter
  const double modulus = assembly.youngs_modulus / (target.youngs_modulus_gpa * units::kMpaPerGpa) - 1.0;
  const double ratio = (assembly.poissons_ratio - target.poissons_ratio) / std::max(kLeastRatio, target.poissons_ratio);
  return std::max(std::abs(modulus), std::abs(ratio));
}

MaterialConfig target_material(const ElasticTask& task) {
  MaterialConfig material = task.config.material;
  material.youngs_modulus_gpa = task.target.youngs_modulus_gpa;
  material.poissons_ratio = task.target.poissons_ratio;
  return material;
}

}  // namespace asperity
