#pragma once
#include "core/measurement/frame.hpp"
#include "render/scene.hpp"
#include "render/specimen.hpp"

namespace asperity::render {

/// How an experiment is called in a picture; symbols and units as UTF-8.
struct ExperimentTexts {
  std::string title, strain, stress;
  std::string strain_unit = "%";
  double strain_factor = 100;  ///< From Frame::axial_strain to that unit.
};
ExperimentTexts experiment_texts(const Frame& frame);

/// A line as cracks of this mode are drawn.
void draw_crack_swatch(Drawing& drawing, CrackMode mode, Vec2 a, Vec2 b, double unit);

/// What a colour bar shows, and what there is: pointed ends say that there are values beyond.
struct ShownRanges {
  Range shown, values;
};

/// Label, bar and ticks from the top of `room`; returns where they end (pixels).
double draw_colour_bar(Drawing& drawing, const FieldColours& colours, const ShownRanges& ranges, const Box& room,
                       double unit);

/// Colour bar or legend from the top of `room`; returns where it ends (pixels).
double draw_key(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, const Box& room,
                double unit);

/// Stress against strain so far, with the present point, filling `room`.
void draw_inset(Drawing& drawing, const Frame& frame, const PictureOptions& options, const Box& room, double unit);

}  // namespace asperity::render
