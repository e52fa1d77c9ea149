#include "render/text_metrics.hpp"

#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <sstream>
#include <utility>

#include "core/base/error.hpp"
#include "render/text_runs.hpp"

namespace asperity::render {
namespace {

constexpr int kDotsPerInch = 72;  // a point is a pixel
// DejaVu Sans, in parts of the font's size: capitals with accents, and the tail of g.
constexpr double kAscent = 0.93, kDescent = 0.24;
constexpr int kMeasuredSize = 100;

std::string existing_font(const char* name) {
  const std::filesystem::path file = std::filesystem::path("/usr/share/fonts/truetype/dejavu") / name;
  if (std::filesystem::exists(file)) return file.string();
  throw Error(ErrorKind::output, "cannot draw text: " + file.string() + " is missing; install fonts-dejavu-core");
}

double measured_width(const std::string& text, Weight weight, int size) {
  vtkNew<vtkTextProperty> property;
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(font_file(weight).c_str());
  property->SetFontSize(size);
  int box[4] = {0, 0, 0, 0};
  vtkTextRenderer::GetInstance()->GetBoundingBox(property, vtkStdString(text), box, kDotsPerInch,
                                                 vtkTextRenderer::FreeType);
  return box[1] - box[0] + 1;
}

}  // namespace

std::string font_file(Weight weight) {
  static const std::string regular = existing_font("DejaVuSans.ttf"), bold = existing_font("DejaVuSans-Bold.ttf");
  return weight == Weight::bold ? bold : regular;
}

double text_width(const std::string& text, double size, Weight weight) {
  if (text.empty()) return 0;
  if (text.find("_{") == std::string::npos) return measured_width(text, weight, kMeasuredSize) * size / kMeasuredSize;
  const std::vector<TextRun> runs = runs_of(text, size, weight);
  return runs.empty() ? 0 : runs.back().along + text_width(runs.back().text, runs.back().size, weight);
}

double text_advance(const std::string& text, double size, Weight weight) {
  const int pixels = static_cast<int>(std::lround(size));
  return measured_width("|" + text + "|", weight, pixels) - measured_width("||", weight, pixels);
}

double fitting_size(const std::string& text, double size, Weight weight, double available) {
  const double width = text_width(text, size, weight);
  return width <= available ? size : std::floor(size * available / width);
}

std::vector<std::string> wrapped(const std::string& text, double size, double available) {
  std::vector<std::string> lines;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::string longer = lines.empty() ? word : lines.back() + " " + word;
    if (!lines.empty() && text_width(longer, size) <= available)
      lines.back() = longer;
    else
      lines.push_back(word);
  }
  return lines;
}

double text_descent(double size) { return kDescent * size; }

Box text_box(const Text& text) {
  const double width = text_width(text.text, text.size, text.weight);
  const double before = text.anchor == Anchor::left ? 0 : text.anchor == Anchor::right ? width : 0.5 * width;
  const double ascent = kAscent * text.size, descent = text_descent(text.size);
  if (text.direction == Direction::across)
    return {text.at.x - before, text.at.y - ascent, text.at.x - before + width, text.at.y + descent};
  return {text.at.x - ascent, text.at.y + before - width, text.at.x + descent, text.at.y + before};
}

}  // namespace asperity::render
