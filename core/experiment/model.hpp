#pragma once
#include "core/base/parallel.hpp"
#include "core/config/run_config.hpp"
#include "core/experiment/joint.hpp"
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
  Joint joint;    ///< Of direct shear.
  double critical_time_step = 0;  ///< s, by power iteration (after mass scaling).
  double added_mass_fraction = 0;
};

/// Builds mesh, particles, contacts and platens and chooses the time step. Throws a config error where the given time
/// step exceeds the stable one, with both figures.
Model build_model(const RunConfig& config, const ParallelLoops& loops);

/// What a test's displacement is divided by to give its strain, mm: the height of a compression specimen, the diameter
/// of a disc, the length of a joint.
double specimen_length(const RunConfig& config);

/// Strain at which a test ends: displacement over specimen_length().
double stop_strain(const RunConfig& config);

/// Strain up to which its peak is looked for.
double peak_limit(const RunConfig& config);

/// 1 thread for small meshes, all cores from 20,000 triangles on.
int default_threads(std::size_t triangles);

}  // namespace asperity
