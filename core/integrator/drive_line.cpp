#include "core/integrator/drive_line.hpp"

#include <cmath>

namespace asperity {
namespace {

/// The positive root of F^2 + b F - K s F_0 = 0, b = F_0 + K u_0 - K s: the stretch s = F/K + u_0 F/(F + F_0) solved
/// for the load.
double first_load(const DriveLine& line) {
  const double spring = line.stiffness * line.stretch;
  const double b = line.half_load + line.stiffness * line.seating - spring;
  const double root = std::sqrt(b * b + 4.0 * spring * line.half_load);
  return b > 0.0 ? 2.0 * spring * line.half_load / (b + root) : 0.5 * (root - b);
}

}  // namespace

double pull(DriveLine& line) {
  if (line.seating > 0.0 && line.stretch > line.closed) {
    const double load = first_load(line), closing = line.seating * load / (load + line.half_load);
    if (closing > line.closed) {
      line.closed = closing;
      return load;
    }
  }
  return line.stiffness * (line.stretch - line.closed);
}

double first_stiffness(const DriveLine& line) { return 1.0 / (1.0 / line.stiffness + line.seating / line.half_load); }

void advance_line(DriveLine& line, double body_velocity, double time_step) {
  line.drive += time_step * line.drive_velocity;
  line.stretch += time_step * (line.drive_velocity - body_velocity);
}

}  // namespace asperity
