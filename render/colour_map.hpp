#pragma once
#include "render/drawing.hpp"
#include "render/range.hpp"

namespace asperity::render {

/// Perceptually even maps that colour-blind readers can follow; README.md gives their sources.
enum class ColourMap { magma_light_to_dark, viridis, cividis, red_blue, grey };

/// The colour at `fraction`, which is clamped to 0 (low) ... 1 (high); a non-finite value is mid grey.
Colour colour_at(ColourMap map, double fraction);

/// Where `value` lies in `range`, 0 to 1; 0.5 in an empty range.
double fraction_in(Range range, double value);

}  // namespace asperity::render
