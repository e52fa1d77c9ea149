#pragma once
#include <string>
#include <vector>

#include "render/drawing.hpp"

namespace asperity::render {

/// A part of a line of text that is set in one size: "t_{c} [MPa]" is "t", then "c" lowered, then " [MPa]". Unicode has
/// no lowered c, s or φ, which the model's symbols need.
struct TextRun {
  std::string text;
  double size = 24;  ///< Of this run's font, in pixels.
  double along = 0;  ///< From the start of the line to the start of the run, in pixels.
  double below = 0;  ///< Of the line's baseline, in pixels.
};

/// The runs of a line in one size, side by side. Without "_{...}" the whole line is one run. Errors: as font_file.
std::vector<TextRun> runs_of(const std::string& text, double size, Weight weight);

/// The line without its marks: "tc [MPa]".
std::string unmarked(const std::string& text);

}  // namespace asperity::render
