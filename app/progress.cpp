#include "app/progress.hpp"

#include <fmt/format.h>

#include <utility>

namespace asperity {

Progress::Progress(std::string experiment, ProgressStyle style, std::ostream& err, ProgressClock clock)
    : experiment_(std::move(experiment)), line_(style, err, std::move(clock)) {}

void Progress::begin(const ProgressState& state) {
  if (!start_) start_ = Start{line_.seconds(), state};
}

void Progress::update(const ProgressState& state) {
  if (line_.quiet()) return;
  begin(state);
  line_.update(state.fraction, [&] { return text(state); });
}

void Progress::finish(const ProgressState& state) {
  if (line_.quiet()) return;
  begin(state);
  line_.finish(state.fraction, [&] { return text(state); });
}

std::string Progress::text(const ProgressState& state) const {
  const double elapsed = line_.seconds() - start_->seconds;
  const double done = state.fraction - start_->state.fraction;
  const double steps = static_cast<double>(state.steps - start_->state.steps);
  const std::string travel = state.shear_displacement_mm ? fmt::format("{:.2f} mm", *state.shear_displacement_mm)
                                                         : fmt::format("strain {:.2f} %", 100 * state.axial_strain);
  std::string text = fmt::format("{} {:3} %  {}  {:.3f} MPa  {} cracks", experiment_, percent_of(state.fraction), travel,
                                 state.stress_mpa, state.cracks);
  if (elapsed > 0 && steps > 0) text += fmt::format("  {:.0f} steps/s", steps / elapsed);
  if (state.fraction >= 1) return text + "  took " + duration_text(elapsed);
  if (elapsed > 0 && done > 0) text += "  ETA " + duration_text(elapsed / done * (1 - state.fraction));
  return text;
}

}  // namespace asperity
