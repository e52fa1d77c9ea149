#pragma once
#include <string>
#include <vector>

#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"
#include "render/field.hpp"

namespace asperity::render {

/// One picture of a strip and what stands under it.
struct StripPanel {
  Frame frame;
  std::string caption;
};

/// Specimens of one run side by side at one scale, in a field that needs no colour bar (cracks, fragments, contacts).
/// `width` in pixels; the height follows from the specimen. At least one panel.
Drawing draw_film_strip(const std::vector<StripPanel>& panels, Field field, int width);

}  // namespace asperity::render
