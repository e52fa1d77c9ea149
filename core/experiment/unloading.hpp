#pragma once
#include "core/experiment/model.hpp"

/// Loops of unloading and reloading within a test, Eq. (E25).
namespace asperity {

/// Where a test stands in its loops; plain data, part of the checkpoint.
struct UnloadingState {
  int begun = 0;         ///< Loops that have begun.
  int back = 0;          ///< 1: the drive is to run backwards.
  double direction = 1;  ///< Its rate over that of loading, 1 to -1, on its way from one to the other.
  double load = 0;       ///< Present load, smoothed, N per mm of thickness.
  double trend = 0;      ///< Its change, smoothed, N per mm and s.
  double turn_load = 0;  ///< At which the last loop began.
  double turn_mm = 0;    ///< Displacement there.
};

/// Factor on the loading rate of the coming step, after the present step's displacement (mm).
double unloading_factor(const Model& model, UnloadingState& state, double displacement_mm);

/// Whether the test is inside a loop: unloading, or not yet past the displacement at which it turned.
bool inside_loop(const UnloadingState& state, double displacement_mm);

}  // namespace asperity
