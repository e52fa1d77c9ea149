#include "app/progress_line.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
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

/// A line longer than the terminal would wrap, and rewriting it would leave its first part behind.
std::size_t terminal_columns() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  return size.ws_col;
}

}  // namespace

ProgressStyle progress_style_of_stderr() {
  const char* terminal = std::getenv("TERM");
  const bool plain = terminal == nullptr || std::string_view(terminal) == "dumb";
  return isatty(STDERR_FILENO) != 0 && !plain ? ProgressStyle::rewritten_line : ProgressStyle::lines;
}

int percent_of(double fraction) { return static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0) + 1e-9); }

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return "?";
  const long long whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

ProgressLine::ProgressLine(ProgressStyle style, std::ostream& err, ProgressClock clock)
    : style_(style), err_(err), clock_(clock ? std::move(clock) : steady_seconds) {}

ProgressLine::~ProgressLine() {
  if (line_open_) err_ << '\n' << std::flush;
}

void ProgressLine::update(double fraction, const std::function<std::string()>& text) {
  if (!quiet() && is_due(fraction)) show(fraction, text());
}

void ProgressLine::finish(double fraction, const std::function<std::string()>& text) {
  if (quiet()) return;
  if (style_ == ProgressStyle::rewritten_line || shown_percent_ < 100) show(fraction, text());
  if (std::exchange(line_open_, false)) err_ << '\n' << std::flush;
}

bool ProgressLine::is_due(double fraction) const {
  if (shown_percent_ < 0) return true;
  if (style_ == ProgressStyle::rewritten_line) return clock_() - shown_at_ >= kSecondsBetween;
  return percent_of(fraction) / kPercentBetween > shown_percent_ / kPercentBetween;
}

void ProgressLine::show(double fraction, const std::string& text) {
  shown_at_ = clock_();
  shown_percent_ = percent_of(fraction);
  if (style_ == ProgressStyle::lines) {
    err_ << text << '\n' << std::flush;
    return;
  }
  err_ << "\r\033[K" << text.substr(0, terminal_columns() - 1) << std::flush;
  line_open_ = true;
}

}  // namespace asperity
