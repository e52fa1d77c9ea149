#pragma once
#include <optional>
#include <string>
#include <vector>

#include "app/compare/compared_run.hpp"

namespace asperity::app {

/// What the compared frames have in common.
enum class Alignment { displacement, strain, peak };

/// "displacement", "strain" or "peak"; nothing for another word.
std::optional<Alignment> alignment_from_name(const std::string& name);

/// What the user asks for. Without `by`: the strain (a joint: the displacement) that all runs have reached; without
/// `at`: the last common value, or half the peak behind it.
struct AlignmentRequest {
  std::optional<Alignment> by;
  std::optional<double> at;  ///< mm, strain as in curves.csv, or the part of the peak.
};

struct AlignedFrame {
  RunFrame frame;       ///< The run's frame nearest to the wanted place.
  bool reached = true;  ///< False where the stress never fell so far: the last frame stands in.
};

/// One frame a run.
struct AlignedFrames {
  Alignment by = Alignment::strain;
  double at = 0;
  std::vector<AlignedFrame> frames;
  std::string words;  ///< "at a strain of 0.02".
};

/// Throws Error(usage) for a value that not all runs reach, a part of the peak outside -1 to 1 or 0, and the strain of
/// joints.
AlignedFrames align(const std::vector<ComparedRun>& runs, const AlignmentRequest& request);

/// The row where the stress, counted from the confining pressure, has first fallen to `part` of its peak (0 to 1), or
/// for a negative part has first risen to it; the peak is the largest among the first `rows` rows. Nothing where it
/// never fell so far.
std::optional<std::size_t> row_at_peak_part(const std::vector<double>& stress_mpa, double confining_mpa,
                                            std::size_t rows, double part);

}  // namespace asperity::app
