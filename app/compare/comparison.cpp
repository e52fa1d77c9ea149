#include "app/compare/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "render/side_panel.hpp"

namespace asperity::app {
namespace {

std::vector<std::string> warnings_of(const std::vector<ComparedRun>& runs, const AlignedFrames& aligned) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ComparedRun& run = runs[i];
    const std::string who = run.letter + " (" + run.name + ") ";
    if (!aligned.frames[i].reached)
      warnings.push_back(who + "has never " + aligned.words + ": its last frame stands in for it");
    if (run.manifest.outcome != Outcome::finished)
      warnings.push_back(who + "has not come to its end: " + run.manifest.exit_reason);
    if (run.manifest.build.revision != runs.front().manifest.build.revision)
      warnings.push_back(who + "was computed by another revision of the program than A");
  }
  return warnings;
}

}  // namespace

Comparison compare_runs(const std::vector<std::filesystem::path>& folders, const AlignmentRequest& request,
                        render::Field field) {
  Comparison c;
  c.field = field;
  c.runs = read_compared_runs(folders);
  c.aligned = align(c.runs, request);
  c.patterns = measure_patterns(c.runs, c.aligned);
  c.keys = differing_keys(c.runs);
  for (std::size_t i = 0; i < c.runs.size(); ++i) c.labels.push_back(label_of(c.keys, i));
  c.warnings = warnings_of(c.runs, c.aligned);
  return c;
}

std::string title_of(const Comparison& comparison) {
  return fmt::format("{}: {} of {} runs", render::experiment_texts(comparison.patterns.front().frame).title,
                     render::field_name(comparison.field), comparison.runs.size());
}

std::string measure_text(double value) {
  if (!std::isfinite(value)) return "–";
  constexpr double kCounts = 1e9;
  const std::string text = std::floor(value) == value && std::abs(value) < kCounts ? fmt::format("{:.0f}", value)
                                                                                   : fmt::format("{:.4g}", value);
  if (text == "-0") return "0";
  return text.starts_with('-') ? "−" + text.substr(1) : text;
}

std::filesystem::path ComparisonFiles::beside(const std::string& ending) const {
  return picture.parent_path() / (picture.stem().string() + ending);
}

}  // namespace asperity::app
