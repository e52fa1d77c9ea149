#pragma once
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

#include "app/progress_line.hpp"

namespace asperity {

/// Where a run stands.
struct ProgressState {
  double fraction = 0;  ///< Done, 0 to 1.
  double axial_strain = 0;
  double stress_mpa = 0;
  std::int64_t cracks = 0;
  std::int64_t steps = 0;
  std::optional<double> shear_displacement_mm;  ///< Of a joint, in place of the strain.
};

/// Shows how a run goes on: experiment, %, strain, stress, cracks, steps per second and the time left. Speed and time
/// left are reckoned from the first update, so that a resumed run is not told the speed of the run before.
class Progress {
 public:
  /// `err` must outlive this. `clock` unset: the steady clock.
  Progress(std::string experiment, ProgressStyle style, std::ostream& err, ProgressClock clock = {});

  /// Cheap to call every sample: shows itself at most ten times a second, or at every 5 %.
  void update(const ProgressState& state);

  /// Shows the last state, unless its 100 % stand there already, and ends the line.
  void finish(const ProgressState& state);

 private:
  struct Start {
    double seconds;
    ProgressState state;
  };
  void begin(const ProgressState& state);
  std::string text(const ProgressState& state) const;

  std::string experiment_;
  ProgressLine line_;
  std::optional<Start> start_;
};

}  // namespace asperity
