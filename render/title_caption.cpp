#include "render/title_caption.hpp"

#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kCaptionSize = 24, kCaptionLine = 34;  // pixels

}  // namespace

double draw_title(Drawing& drawing, const std::string& title) {
  if (title.empty()) return kFigureMargin;
  const double size = fitting_size(title, style::kTitleSize, Weight::bold, drawing.width - 2 * kFigureMargin);
  const double baseline = kFigureMargin + style::kTitleSize;
  drawing.shapes.push_back(
      Text{{kFigureMargin, baseline}, title, size, Anchor::left, Weight::bold, Direction::across, style::kInk});
  return baseline + 0.6 * style::kTitleSize;
}

double draw_caption(Drawing& drawing, const std::string& caption) {
  const std::vector<std::string> lines = wrapped(caption, kCaptionSize, drawing.width - 2 * kFigureMargin);
  const double top = drawing.height - kFigureMargin - kCaptionLine * static_cast<double>(lines.size());
  double baseline = top + kCaptionLine;
  for (const std::string& line : lines) {
    drawing.shapes.push_back(Text{{kFigureMargin, baseline},
                                  line,
                                  kCaptionSize,
                                  Anchor::left,
                                  Weight::regular,
                                  Direction::across,
                                  style::kSoftInk});
    baseline += kCaptionLine;
  }
  return lines.empty() ? drawing.height - kFigureMargin : top - 0.3 * kCaptionLine;
}

}  // namespace asperity::render
