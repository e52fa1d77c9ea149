#pragma once
#include <filesystem>

#include "render/drawing.hpp"
#include "render/encode.hpp"

namespace asperity::render {

/// Paints a drawing offscreen (VTK on OSMesa); the same drawing gives the same pixels. Calls from several threads wait
/// for one another.
Pixels paint(const Drawing& drawing);

/// Paints a drawing and writes it as PNG. Errors: Error(output) with path and reason.
void write_png(const Drawing& drawing, const std::filesystem::path& path);

/// Writes a drawing as SVG with lines and texts as such. Errors: Error(output) with path and reason.
void write_svg(const Drawing& drawing, const std::filesystem::path& path);

}  // namespace asperity::render
