#pragma once
#include "core/calibration/elastic_compensation.hpp"

namespace asperity::testing {

/// The plaster's uniaxial test on a specimen small enough that one reading takes some 30 ms.
inline RunConfig coarse_plaster(PlaneCondition plane) {
  RunConfig c;
  c.experiment.type = ExperimentType::uniaxial;
  c.experiment.plane = plane;
  c.particles.edge_mm = 6;
  c.contacts.tensile_strength_mpa = 4;
  c.contacts.cohesion_mpa = 1.7;
  c.contacts.friction_angle_deg = 38;
  return c;
}

/// E 1.3 GPa, nu 0.2 (Table 2) in the mean of two specimens.
inline ElasticTask coarse_task(PlaneCondition plane) {
  ElasticTask task;
  task.config = coarse_plaster(plane);
  task.target = {1.3, 0.2, 7.5};
  task.stiffness = {StiffnessRule::multiple, 10.0};
  task.seeds = {1, 2};
  return task;
}

}  // namespace asperity::testing
