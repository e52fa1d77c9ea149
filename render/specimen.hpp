#pragma once
#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"
#include "render/scene.hpp"

namespace asperity::render {

/// Where the specimen lies: millimetres to pixels. The same for all frames of a run, since it follows from the specimen
/// as it was before loading.
struct View {
  Box area;     ///< Pixels the specimen and its platens may use.
  Vec2 centre;  ///< mm, shown in the middle of the area.
  double pixels_per_mm = 1;
  Vec2 specimen_mm;      ///< Width and height before loading.
  double platen_mm = 0;  ///< Thickness of a drawn platen.
  double beside = 0;     ///< Pixels at either side of the area that loose pieces may use too.
  Vec2 place(Vec2 mm) const;
  bool shows(Vec2 pixel) const;
};

/// The largest view of the frame's specimen in a room of pixels; its area is as wide as specimen and platens need, from
/// the room's left edge.
View fit_view(const Frame& frame, const Box& room);

/// Platens, particles in the field's colours, cracks. `unit` is the size of a pixel of the standard picture.
void draw_specimen(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, double unit);

/// A bar of a round length with its length in mm, below the view.
void draw_scale_bar(Drawing& drawing, const View& view, double unit);

}  // namespace asperity::render
