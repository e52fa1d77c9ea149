#pragma once
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace asperity {

/// How progress is shown: one line rewritten in place, a new line every 5 %, or not at all.
enum class ProgressStyle { rewritten_line, lines, quiet };

/// rewritten_line where stderr is a terminal that can move its cursor, else lines.
ProgressStyle progress_style_of_stderr();

/// Where a run stands.
struct ProgressState {
  double fraction = 0;  ///< Done, 0 to 1.
  double axial_strain = 0;
  double stress_mpa = 0;
  std::int64_t cracks = 0;
  std::int64_t steps = 0;
};

/// Shows how a run goes on: experiment, %, strain, stress, cracks, steps per second and the time left. Speed and time
/// left are reckoned from the first update, so that a resumed run is not told the speed of the run before.
class Progress {
 public:
  using Clock = std::function<double()>;  ///< Seconds since any fixed instant.

  /// `err` must outlive this. `clock` unset: the steady clock.
  Progress(std::string experiment, ProgressStyle style, std::ostream& err, Clock clock = {});

  /// Ends the line it rewrites.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Cheap to call every sample: shows itself at most ten times a second, or at every 5 %.
  void update(const ProgressState& state);

  /// Shows the last state, unless its 100 % stand there already, and ends the line.
  void finish(const ProgressState& state);

 private:
  struct Start {
    double seconds;
    ProgressState state;
  };
  bool is_due(const ProgressState& state, double now) const;
  void show(const ProgressState& state, double now);
  std::string line(const ProgressState& state, double now) const;

  std::string experiment_;
  ProgressStyle style_;
  std::ostream& err_;
  Clock clock_;
  std::optional<Start> start_;
  double shown_at_ = 0;     ///< Seconds.
  int shown_percent_ = -1;  ///< -1: nothing shown yet.
  bool line_open_ = false;
};

/// "2 h 05 min", "3 min 20 s", "12 s"; "?" for what is not finite.
std::string duration_text(double seconds);

}  // namespace asperity
