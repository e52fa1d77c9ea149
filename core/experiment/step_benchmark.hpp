#pragma once
#include <optional>
#include <vector>

#include "core/base/machine_peak.hpp"
#include "core/config/run_config.hpp"
#include "core/integrator/system.hpp"

/// What a time step costs, reference and fast kernel side by side; `asperity bench`. Counts and bound:
/// core/integrator/README.md.
namespace asperity {

/// What the best batch took, ns or µs.
struct PassCosts {
  double triangle_ns = 0;  ///< The whole step, a triangle.
  double contact_ns = 0;   ///< Forces, a contact point. The reference computes the triangles' here too.
  double motion_ns = 0;    ///< Velocities and positions, with the triangles' forces in the fast kernel; a triangle.
  double step_us = 0;      ///< The whole step.
};

/// One mesh with one number of threads.
struct StepCost {
  std::size_t triangles = 0, contact_points = 0;
  int threads = 1;
  std::optional<PassCosts> reference;  ///< On one thread only.
  PassCosts fast;
  double bytes_per_triangle = 0;  ///< Everything the model keeps for stepping with the fast kernel.
  double flops_per_triangle = 0;  ///< Operations a triangle and step, counted.
  double traffic_per_triangle =
      0;                ///< Bytes that must move a triangle and step where no cache holds the model, counted.
  MachinePeak peak;     ///< Of these threads, with data of the model's size.
  double bound_ns = 0;  ///< The larger of flops over peak and traffic over bandwidth.
};

/// Memory of a system, bytes.
std::size_t memory_of(const System& system);

/// The specimen of a benchmark: that of a compression test of about so many triangles, edges 2 mm, strained and shaken
/// so that every contact is loaded and most harden, none broken.
System benchmark_system(int triangles);

/// Times the reference on one thread and the fast kernel on each number of threads, batch by batch in turns, each on
/// its own copy of the system.
std::vector<StepCost> measure_step(const System& system, const std::vector<int>& thread_counts);

}  // namespace asperity
