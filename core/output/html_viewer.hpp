#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/output/html.hpp"

/// Pictures of a time series, one at a time, beside the curve they belong to. The page works without a script too: it
/// then shows the frame that is shown first.
namespace asperity::html {

/// One direction of a small curve: what it shows from where to where, and its marks.
struct SmallAxis {
  struct Tick {
    double value = 0;
    std::string label;
  };
  std::string label;
  double low = 0, high = 1;
  std::vector<Tick> ticks;
};

/// A curve drawn into the page. A value that is not finite breaks the line.
struct SmallCurve {
  SmallAxis x, y;
  std::vector<double> x_values, y_values;
  std::string alternative_text;
};

/// Pictures of one kind: an address (linked_source) a frame, empty where there is no picture.
struct PictureKind {
  std::string name;
  std::vector<std::string> sources;    ///< What the page shows.
  std::vector<std::string> originals;  ///< Full size, behind a click.
};

/// Where a frame stands on the curve, and what is said of it: "Frame 3 of 25: 0.48 mm, 1.40 MPa".
struct FrameState {
  double x = 0, y = 0;
  std::string text;
};

struct FrameViewer {
  std::vector<PictureKind> kinds;  ///< At least one.
  std::vector<FrameState> frames;  ///< At least one.
  std::size_t shown = 0;           ///< Frame that is shown first.
  SmallCurve curve;
};

/// Picture, radio buttons for its kind, a slider over the frames with buttons beside it, all reached by the keyboard,
/// and the curve with the present frame's point.
Markup frame_viewer(const FrameViewer& viewer);

/// What a page with frame viewers takes as Page::script.
std::string_view frame_viewer_script();

}  // namespace asperity::html
