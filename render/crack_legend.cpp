#include "render/crack_legend.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "render/side_panel.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kSwatch = 82, kBeforeText = 16, kBetween = 47;  // pixels

struct Entry {
  CrackMode mode;
  std::string text;
};

std::vector<Entry> entries(bool defects) {
  std::vector<Entry> list{{CrackMode::tension, "Broken in tension"},
                          {CrackMode::shear, "Broken in shear"},
                          {CrackMode::softening, "Softening"}};
  if (defects) list.push_back({CrackMode::defect, "Open before the test"});
  return list;
}

double width_of(const std::vector<Entry>& list) {
  double width = -kBetween;
  for (const Entry& entry : list) width += kSwatch + kBeforeText + text_width(entry.text, style::kLabelSize) + kBetween;
  return width;
}

}  // namespace

bool has_defects(const Frame& frame) {
  return std::any_of(frame.cracks.begin(), frame.cracks.end(),
                     [](const CrackSegment& crack) { return crack.mode == CrackMode::defect; });
}

void draw_crack_legend(Drawing& drawing, bool defects, Vec2 at, double width, double unit) {
  const std::vector<Entry> list = entries(defects);
  unit = std::min(unit, width / width_of(list));
  const double size = unit * style::kLabelSize;
  for (const Entry& entry : list) {
    draw_crack_swatch(drawing, entry.mode, at, at + Vec2{unit * kSwatch, 0}, unit);
    drawing.shapes.push_back(Text{at + Vec2{unit * (kSwatch + kBeforeText), 0.36 * size}, entry.text, size,
                                  Anchor::left, Weight::regular, Direction::across, style::kInk});
    at.x += unit * (kSwatch + kBeforeText + kBetween) + text_width(entry.text, size);
  }
}

}  // namespace asperity::render
