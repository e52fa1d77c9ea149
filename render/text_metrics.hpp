#pragma once
#include <string>
#include <vector>

#include "render/drawing.hpp"

namespace asperity::render {

/// The font file of a weight (DejaVu Sans). Errors: Error(output) with the package to install if it is missing.
std::string font_file(Weight weight);

/// Width of a line of UTF-8 text in pixels, with the marks of text_runs. Errors: as font_file.
double text_width(const std::string& text, double size, Weight weight = Weight::regular);

/// How far the text, drawn in this size, moves what follows it, its outer blanks included, in pixels. Glyphs stand on
/// whole pixels, so that this is not simply proportional to the size.
double text_advance(const std::string& text, double size, Weight weight);

/// `size`, or the smaller size at which the text is no wider than `available` pixels.
double fitting_size(const std::string& text, double size, Weight weight, double available);

/// The text in lines no wider than `available` pixels, broken at blanks; a longer word keeps a line of its own.
std::vector<std::string> wrapped(const std::string& text, double size, double available);

/// How far the font reaches below the baseline, in pixels.
double text_descent(double size);

/// The rectangle a text covers, from its ascenders to its descenders, in pixels.
Box text_box(const Text& text);

}  // namespace asperity::render
