#pragma once
#include <filesystem>

#include "render/drawing.hpp"

namespace asperity::render {

/// Paints a drawing offscreen (VTK on OSMesa) and writes it as PNG; the same drawing gives the same bytes. Calls from
/// several threads wait for one another. Errors: Error(output) with path and reason.
void write_png(const Drawing& drawing, const std::filesystem::path& path);

/// Writes a drawing as SVG with lines and texts as such. Errors: Error(output) with path and reason.
void write_svg(const Drawing& drawing, const std::filesystem::path& path);

}  // namespace asperity::render
