#include "app/progress.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ostream>
#include <string_view>
#include <utility>

namespace asperity {
namespace {

constexpr double kSecondsBetween = 0.1;
constexpr int kPercentBetween = 5;

double steady_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int percent_of(double fraction) { return static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0) + 1e-9); }

/// A line longer than the terminal would wrap, and rewriting it would leave its first part behind.
std::size_t terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

template <class... Values>
std::string formatted(const char* format, Values... values) {
  char text[160];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

}  // namespace

ProgressStyle progress_style_of_stderr() {
  const char* terminal = std::getenv("TERM");
  const bool plain = terminal == nullptr || std::string_view(terminal) == "dumb";
  return isatty(STDERR_FILENO) != 0 && !plain ? ProgressStyle::rewritten_line : ProgressStyle::lines;
}

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return "?";
  const long long whole = std::llround(seconds);
  if (whole < 60) return formatted("%lld s", whole);
  if (whole < 3600) return formatted("%lld min %02lld s", whole / 60, whole % 60);
  return formatted("%lld h %02lld min", whole / 3600, whole % 3600 / 60);
}

Progress::Progress(std::string experiment, ProgressStyle style, std::ostream& err, Clock clock)
    : experiment_(std::move(experiment)), style_(style), err_(err), clock_(clock ? std::move(clock) : steady_seconds) {}

Progress::~Progress() {
  if (line_open_) err_ << '\n' << std::flush;
}

void Progress::update(const ProgressState& state) {
  if (style_ == ProgressStyle::quiet) return;
  const double now = clock_();
  if (!start_) start_ = Start{now, state};
  if (is_due(state, now)) show(state, now);
}

void Progress::finish(const ProgressState& state) {
  if (style_ == ProgressStyle::quiet) return;
  const double now = clock_();
  if (!start_) start_ = Start{now, state};
  if (style_ == ProgressStyle::rewritten_line || shown_percent_ < 100) show(state, now);
  if (std::exchange(line_open_, false)) err_ << '\n' << std::flush;
}

bool Progress::is_due(const ProgressState& state, double now) const {
  if (shown_percent_ < 0) return true;
  if (style_ == ProgressStyle::rewritten_line) return now - shown_at_ >= kSecondsBetween;
  return percent_of(state.fraction) / kPercentBetween > shown_percent_ / kPercentBetween;
}

void Progress::show(const ProgressState& state, double now) {
  shown_at_ = now;
  shown_percent_ = percent_of(state.fraction);
  if (style_ == ProgressStyle::lines) {
    err_ << line(state, now) << '\n' << std::flush;
    return;
  }
  err_ << "\r\033[K" << line(state, now).substr(0, terminal_columns() - 1) << std::flush;
  line_open_ = true;
}

std::string Progress::line(const ProgressState& state, double now) const {
  const double elapsed = now - start_->seconds;
  const double done = state.fraction - start_->state.fraction;
  const double steps = static_cast<double>(state.steps - start_->state.steps);
  std::string text =
      experiment_ + formatted(" %3d %%  strain %.2f %%  %.3f MPa  %lld cracks", percent_of(state.fraction),
                              100 * state.axial_strain, state.stress_mpa, static_cast<long long>(state.cracks));
  if (elapsed > 0 && steps > 0) text += formatted("  %.0f steps/s", steps / elapsed);
  if (state.fraction >= 1) return text + "  took " + duration_text(elapsed);
  if (elapsed > 0 && done > 0) text += "  ETA " + duration_text(elapsed / done * (1 - state.fraction));
  return text;
}

}  // namespace asperity
