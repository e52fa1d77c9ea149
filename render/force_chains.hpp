#pragma once
#include <array>

#include "core/measurement/frame.hpp"
#include "render/drawing.hpp"
#include "render/scene.hpp"
#include "render/specimen.hpp"

namespace asperity::render {

/// What the colours of contact forces tell apart.
enum class ForceClass { compression, tension, broken, general };

/// All classes, in the order in which they are drawn and stand in the legend.
inline constexpr std::array kForceClasses{ForceClass::compression, ForceClass::tension, ForceClass::broken,
                                          ForceClass::general};

ForceClass force_class(const ContactForce& contact);

/// Line widths of contact forces: proportional to the normal force up to a largest one.
struct ForceScale {
  double largest_n = 0;  ///< Forces from here on have the widest line; 0 where there are none.
  double widest = 0;     ///< Its width, pixels.
  double narrowest = 0;  ///< No line is drawn narrower, pixels.
  double width(double normal_n) const;
};

/// The widest line is somewhat narrower than a particle, so that neighbours stay apart in any mesh.
ForceScale force_scale(const Frame& frame, const PictureOptions& options, const View& view, double unit);

/// A contact's line from a to b, pixels.
void draw_force(Drawing& drawing, ForceClass kind, Vec2 a, Vec2 b, double width);

/// All contact forces as lines from particle to particle, the strongest of each class on top.
void draw_force_chains(Drawing& drawing, const Frame& frame, const View& view, const ForceScale& scale);

}  // namespace asperity::render
