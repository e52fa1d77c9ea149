#pragma once
#include <functional>
#include <iosfwd>
#include <string>

namespace asperity {

/// How progress is shown: one line rewritten in place, a new line every 5 %, or not at all.
enum class ProgressStyle { rewritten_line, lines, quiet };

/// rewritten_line where stderr is a terminal that can move its cursor, else lines.
ProgressStyle progress_style_of_stderr();

/// Seconds since any fixed instant.
using ProgressClock = std::function<double()>;

/// The line on which progress is shown, whatever is going on.
class ProgressLine {
 public:
  /// `err` must outlive this. `clock` unset: the steady clock.
  ProgressLine(ProgressStyle style, std::ostream& err, ProgressClock clock = {});

  /// Ends the line it rewrites.
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool quiet() const { return style_ == ProgressStyle::quiet; }
  double seconds() const { return clock_(); }

  /// Shows the text if it is time: ten times a second, or at every 5 % of the fraction.
  void update(double fraction, const std::function<std::string()>& text);

  /// Shows the text, unless a line of 100 % stands there already, and ends the line.
  void finish(double fraction, const std::function<std::string()>& text);

 private:
  bool is_due(double fraction) const;
  void show(double fraction, const std::string& text);
  ProgressStyle style_;
  std::ostream& err_;
  ProgressClock clock_;
  double shown_at_ = 0;     ///< Seconds.
  int shown_percent_ = -1;  ///< -1: nothing shown yet.
  bool line_open_ = false;
};

/// The fraction in whole per cent, rounded down.
int percent_of(double fraction);

/// "2 h 05 min", "3 min 20 s", "12 s"; "?" for what is not finite.
std::string duration_text(double seconds);

}  // namespace asperity
