#include "app/compare/alignment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/error.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity::app {
namespace {

bool sheared(const ComparedRun& run) { return run.config.experiment.type == ExperimentType::direct_shear; }

std::vector<double> column_of(const ComparedRun& run, Alignment by) {
  if (by == Alignment::strain) return run.curves.numbers("axial_strain");
  return run.curves.numbers(sheared(run) ? "shear_displacement_mm" : "platen_displacement_mm");
}

Alignment chosen(const std::vector<ComparedRun>& runs, const AlignmentRequest& request) {
  const bool joints = sheared(runs.front());
  if (joints && request.by == Alignment::strain) {
    throw Error(ErrorKind::usage,
                {{"--align", "does not suit joints, which have no strain", "strain", "displacement or peak", ""}});
  }
  return request.by.value_or(joints ? Alignment::displacement : Alignment::strain);
}

RunFrame frame_nearest(const ComparedRun& run, const std::vector<double>& column, double wanted) {
  return *std::min_element(run.frames.begin(), run.frames.end(), [&](const RunFrame& a, const RunFrame& b) {
    return std::abs(column[a.row] - wanted) < std::abs(column[b.row] - wanted);
  });
}

/// Where the run with the shortest way ends.
struct CommonEnd {
  double value = std::numeric_limits<double>::infinity();
  const ComparedRun* run = nullptr;
};

CommonEnd common_end(const std::vector<ComparedRun>& runs, Alignment by) {
  CommonEnd end;
  for (const ComparedRun& run : runs) {
    const std::vector<double> column = column_of(run, by);
    const double last = column[run.frames.back().row];
    if (last < end.value) end = {last, &run};
  }
  return end;
}

AlignedFrames align_by_way(const std::vector<ComparedRun>& runs, Alignment by, const std::optional<double>& at) {
  const CommonEnd end = common_end(runs, by);
  const char* unit = by == Alignment::displacement ? " mm" : "";
  constexpr double kRounding = 1e-9;
  if (at && !(*at >= 0 && *at <= end.value * (1 + kRounding))) {
    throw Error(ErrorKind::usage, {{"--at", "is not on the way that all runs have gone", number_text(*at),
                                    "0 to " + fmt::format("{:.6g}", end.value) + unit,
                                    "the last frame of " + end.run->folder.string() + " lies there"}});
  }
  AlignedFrames aligned{by, at.value_or(end.value), {}, ""};
  for (const ComparedRun& run : runs)
    aligned.frames.push_back({frame_nearest(run, column_of(run, by), aligned.at), true});
  aligned.words = by == Alignment::displacement ? fmt::format("at a displacement of {:.4g} mm", aligned.at)
                                                : fmt::format("at a strain of {:.4g} %", 100 * aligned.at);
  if (!at) aligned.words += ", the farthest that all have frames of";
  return aligned;
}

/// Rows among which the peak is looked for.
std::size_t peak_rows(const ComparedRun& run) {
  if (sheared(run)) return run.curves.rows();
  const std::vector<double> strain = run.curves.numbers("axial_strain");
  const auto beyond = std::find_if(strain.begin(), strain.end(),
                                   [&](double e) { return e > run.config.measurement.peak_strain_limit; });
  return static_cast<std::size_t>(beyond - strain.begin());
}

AlignedFrame frame_at_peak_part(const ComparedRun& run, double part) {
  const bool confined = run.config.experiment.type == ExperimentType::triaxial;
  const std::optional<std::size_t> row =
      row_at_peak_part(run.curves.numbers(stress_column(run.config.experiment.type)),
                       confined ? run.config.experiment.confining_pressure_mpa : 0.0, peak_rows(run), part);
  if (!row) return {run.frames.back(), false};
  const std::vector<double> time = run.curves.numbers("time_s");
  return {frame_nearest(run, time, time[*row]), true};
}

AlignedFrames align_by_peak(const std::vector<ComparedRun>& runs, double part) {
  if (!(std::abs(part) > 0 && std::abs(part) <= 1)) {
    throw Error(ErrorKind::usage,
                {{"--at", "is no part of the peak", number_text(part), "above 0 to 1, or below 0 to -1",
                  "0.5: behind the peak, once the stress has fallen to half of it; -0.5: on the way up"}});
  }
  AlignedFrames aligned{Alignment::peak, part, {}, ""};
  for (const ComparedRun& run : runs) aligned.frames.push_back(frame_at_peak_part(run, part));
  aligned.words = part == 1 ? "at the peak"
                            : fmt::format("{} {:.4g} of the peak", part > 0 ? "fallen to" : "risen to", std::abs(part));
  return aligned;
}

}  // namespace

std::optional<Alignment> alignment_from_name(const std::string& name) {
  if (name == "displacement") return Alignment::displacement;
  if (name == "strain") return Alignment::strain;
  if (name == "peak") return Alignment::peak;
  return std::nullopt;
}

std::optional<std::size_t> row_at_peak_part(const std::vector<double>& stress_mpa, double confining_mpa,
                                            std::size_t rows, double part) {
  const auto end = stress_mpa.begin() + static_cast<std::ptrdiff_t>(std::min(rows, stress_mpa.size()));
  const auto peak = std::max_element(stress_mpa.begin(), end);
  if (peak == end) return std::nullopt;
  const double level = confining_mpa + std::abs(part) * (*peak - confining_mpa);
  const auto found = part > 0 ? std::find_if(peak, stress_mpa.end(), [&](double s) { return s <= level; })
                              : std::find_if(stress_mpa.begin(), peak, [&](double s) { return s >= level; });
  if (found == stress_mpa.end()) return std::nullopt;
  return static_cast<std::size_t>(found - stress_mpa.begin());
}

AlignedFrames align(const std::vector<ComparedRun>& runs, const AlignmentRequest& request) {
  constexpr double kHalf = 0.5;
  const Alignment by = chosen(runs, request);
  if (by == Alignment::peak) return align_by_peak(runs, request.at.value_or(kHalf));
  return align_by_way(runs, by, request.at);
}

}  // namespace asperity::app
