#pragma once
#include "core/measurement/curve_measures.hpp"

/// What the files of curve_measures.hpp share.
namespace asperity::feature_parts {

inline FeatureValue absent(const char* why) { return {std::nullopt, why}; }

/// Why nothing that is counted in shares of the peak can be read; empty where it can.
inline std::string no_peak(const CurveShape& shape) {
  if (shape.first.path.size() < kLeastRows) return "the curve has fewer than ten rows";
  return shape.peak_passed ? "" : "no peak was passed";
}

/// The same, and where there is no modulus line.
inline std::string no_line(const CurveShape& shape) {
  const std::string why = no_peak(shape);
  if (!why.empty()) return why;
  return shape.line ? "" : "fewer than three rows lie in the modulus window, or they do not rise";
}

/// From the toe to the peak.
inline double loading_path(const CurveShape& shape) { return shape.peak_path - shape.line->intercept; }

/// How far a branch, where it begins to bear, is from the line that it joins, Eq. (F8); empty where it never bears so
/// little.
inline std::optional<double> travel_of(const Branch& branch, const Line& line, double load) {
  if (branch.smooth_load.empty() || branch.smooth_load.front() >= load) return std::nullopt;
  const auto begin = find_crossing(branch, load, Direction::rising, 0, branch.load.size());
  if (!begin) return std::nullopt;
  return line.at(load) - begin->path;
}

}  // namespace asperity::feature_parts
