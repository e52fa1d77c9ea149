#pragma once
#include "core/base/parallel.hpp"
#include "core/config/run_config.hpp"
#include "core/geometry/mesh.hpp"
#include "core/integrator/system.hpp"
#include "core/measurement/disc_gauge.hpp"
#include "core/measurement/gauges.hpp"

namespace asperity {

/// A specimen between its platens, ready to move, and what was found out while building it.
struct Model {
  RunConfig config;
  Mesh mesh;
  System system;
  Gauges gauges;  ///< Of compression.
  DiscGauge disc;
  double critical_time_step = 0;  ///< s, by power iteration (after mass scaling).
  double added_mass_fraction = 0;
};

/// Builds mesh, particles, contacts and platens and chooses the time step. Throws a config error where the given time
/// step exceeds the stable one, with both figures.
Model build_model(const RunConfig& config, const ParallelLoops& loops);

/// Height of a compression specimen or diameter of a disc, mm.
double specimen_height(const ExperimentConfig& experiment);

/// 1 thread for small meshes, all cores from 20,000 triangles on.
int default_threads(std::size_t triangles);

}  // namespace asperity
