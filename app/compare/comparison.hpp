#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/differences.hpp"
#include "app/compare/measures.hpp"
#include "render/field.hpp"

namespace asperity::app {

/// Everything that pictures, tables and page of a comparison show.
struct Comparison {
  std::vector<ComparedRun> runs;
  AlignedFrames aligned;
  std::vector<MeasuredPattern> patterns;  ///< One a run.
  std::vector<DifferingKey> keys;
  std::vector<std::string> labels;    ///< What is special about each run.
  std::vector<std::string> warnings;  ///< What makes the runs less comparable than they look.
  render::Field field = render::Field::cracks;
};

/// Reads, aligns and measures. Errors: as read_compared_runs and align.
Comparison compare_runs(const std::vector<std::filesystem::path>& folders, const AlignmentRequest& request,
                        render::Field field);

/// "Brazilian disc: cracks of 3 runs".
std::string title_of(const Comparison& comparison);

/// A measure for readers: a count as it is, another number in four digits, "–" where there is none.
std::string measure_text(double value);

/// Where a comparison's files lie: beside one another, all named after the picture.
struct ComparisonFiles {
  std::filesystem::path picture;
  std::filesystem::path html;
  std::filesystem::path beside(const std::string& ending) const;  ///< x.png, "_curves.png": x_curves.png
};

/// x.csv (a row a run), x_orientation.csv (a row a run and bin) and x.md. Throws Error(output).
void write_tables(const Comparison& comparison, const ComparisonFiles& files);

/// The table of x.md: a row a measure, a column a run.
std::string markdown_table(const Comparison& comparison);

/// The picture itself. Throws Error(output).
void draw_comparison(const Comparison& comparison, const ComparisonFiles& files);

/// x_curves.png: all curves, with the compared places on them. Throws Error(output).
void draw_comparison_curves(const Comparison& comparison, const ComparisonFiles& files);

/// x_difference.png: two runs on one mesh, one against the other; nothing is drawn of other comparisons, and false
/// returned. Throws Error(output).
bool draw_difference(const Comparison& comparison, const ComparisonFiles& files);

/// The page, with the pictures inside it. Throws Error(output).
void write_comparison_page(const Comparison& comparison, const ComparisonFiles& files);

/// Up to `count` frames, evenly from the last one before anything broke to the end.
std::vector<RunFrame> montage_frames(const ComparedRun& run, std::size_t count);

/// One run through time, in its montage_frames. Throws Error(output).
void draw_montage(const ComparedRun& run, std::size_t count, render::Field field, const std::filesystem::path& picture);

}  // namespace asperity::app
