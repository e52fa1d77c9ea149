#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"
#include "render/field.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// What a picture shows and how large. A range not given is taken from the frame; give them to keep the colours and the
/// inset's axes the same over a series.
struct PictureOptions {
  Field field = Field::cracks;
  int width = 1600, height = 1200;
  std::optional<Range> value_range;   ///< Of colours or line widths, in the field's unit; as frame_range().
  std::optional<Range> strain_range;  ///< Of the inset curve, as in Frame (not %).
  std::optional<Range> stress_range;  ///< Of the inset curve, MPa.
  double displacement_scale = 1;      ///< Exaggerates displacements; a value other than 1 is noted in the picture.
};

/// The picture of a frame: specimen, platens, title, scale bar, colour bar or legend, and the curve so far.
Drawing draw_picture(const Frame& frame, const PictureOptions& options);

/// Draws a frame into a PNG file. Errors: Error(output) with path and reason.
void draw_frame(const Frame& frame, const PictureOptions& options, const std::filesystem::path& png);

/// Ranges that hold for every frame of a run.
struct SeriesRanges {
  std::vector<std::optional<Range>> values;  ///< For each of the fields asked for.
  Range strain, stress;                      ///< Of the curve up to the last frame.
};

/// Reads all frames of a run once. Errors: Error(output) as read_frame.
SeriesRanges ranges_over_series(const std::filesystem::path& run_dir, const std::vector<Field>& fields);

/// The range of one field over all frames of a run: robust percentiles (README.md), in the field's unit; nothing for
/// cracks and fragments. Errors: Error(output) as read_frame.
std::optional<Range> range_over_series(const std::filesystem::path& run_dir, Field field);

/// frames/<field>_<frame>.png of a run.
std::filesystem::path picture_path(const std::filesystem::path& run_dir, Field field, int frame);

/// The same picture at half its size, for pages: frames/<field>_<frame>.jpg.
std::filesystem::path preview_path(std::filesystem::path picture);

/// Draws frames/<field>_<frame>.png and its preview for every field and frame, from the run's VTU files alone, all with
/// the ranges of the whole series unless `options` fixes them; options.field is not used. `interrupted`, unless empty,
/// is asked before each picture; returns false where it ended the drawing. Errors: Error(output) with path and reason.
bool draw_series(const std::filesystem::path& run_dir, const std::vector<Field>& fields, const std::vector<int>& frames,
                 const PictureOptions& options, const std::function<bool()>& interrupted = {});

}  // namespace asperity::render
