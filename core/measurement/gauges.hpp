#pragma once
#include <array>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/particles/particles.hpp"

namespace asperity {

/// Displacement gauges glued to a rectangular specimen: node groups fixed at the start. Eqs. (M1), (M2).
struct Gauges {
  std::array<std::vector<int>, 2> axial;    ///< Lower and upper band.
  std::array<std::vector<int>, 2> lateral;  ///< Left and right flank at mid-height.
  double axial_base_mm = 0;                 ///< Mean distance of the axial bands.
  double lateral_base_mm = 0;               ///< Specimen width.
};

/// Strains read from the gauges, shortening (axial) and widening (lateral) positive.
struct GaugeReading {
  double axial = 0, lateral = 0;
};

/// Gauges of a compression test; a band is two edge lengths high. Throws a config error where a band holds no node.
Gauges make_gauges(const Particles& particles, const ExperimentConfig& experiment, const MeasurementConfig& measurement,
                   double edge_mm);

/// Strains since the particles' reference position; zero for an experiment without gauges.
GaugeReading read_gauges(const Gauges& gauges, const Particles& particles);

}  // namespace asperity
