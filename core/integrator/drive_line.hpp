#pragma once
#include <cstdint>

namespace asperity {

/// The way from the drive to a body that it moves, a platen or a block: a spring in series with a layer that closes
/// under the first load and stays closed; E20 and E21 of core/experiment. Forces are N per mm of thickness.
struct DriveLine {
  double stiffness = 0;       ///< Of the spring, N/mm per mm of thickness; 0: there is no line.
  double seating = 0;         ///< Closing of the layer under a load without bound, mm.
  double half_load = 1;       ///< At which half of it has closed.
  double mass = 0;            ///< Of a platen, tonne per mm of thickness; a block has its own.
  std::int64_t tied = 0;      ///< 1: it pulls; 0: the body moves by itself, as without a line.
  double preload = 0;         ///< What the body bore when it was tied.
  double drive_velocity = 0;  ///< mm/s during the coming step, the way the body is moved.
  double drive = 0;           ///< Displacement of the drive since it was tied, mm.
  double stretch = 0;         ///< That less the body's, mm.
  double closed = 0;          ///< Closing of the layer so far, mm.
};

/// Force on the body beyond its preload at the present stretch; the layer's closing is brought up to date.
double pull(DriveLine& line);

/// Stiffness of spring and layer together at the first load, N/mm per mm of thickness.
double first_stiffness(const DriveLine& line);

/// One step ahead; `body_velocity` (mm/s) is that of the coming step, the way the drive goes.
void advance_line(DriveLine& line, double body_velocity, double time_step);

}  // namespace asperity
