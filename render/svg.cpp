#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/atomic_file.hpp"
#include "render/paint.hpp"
#include "render/tessellate.hpp"
#include "render/text_runs.hpp"

namespace asperity::render {
namespace {

std::string hex(Colour colour) { return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b); }

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string points_attribute(const std::vector<Vec2>& points) {
  std::string out;
  for (const Vec2 p : points) out += fmt::format("{}{:.2f},{:.2f}", out.empty() ? "" : " ", p.x, p.y);
  return out;
}

std::string polygon(const std::vector<Vec2>& corners, Colour fill) {
  return fmt::format("<polygon points=\"{}\" fill=\"{}\"/>\n", points_attribute(corners), hex(fill));
}

std::string dash_attribute(const std::vector<double>& dash) {
  std::string out;
  for (const double length : dash) out += fmt::format("{}{:g}", out.empty() ? "" : " ", length);
  return out.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", out);
}

std::string weight_attribute(Weight weight) { return weight == Weight::bold ? " font-weight=\"bold\"" : ""; }

const char* anchor_name(Anchor anchor) {
  return anchor == Anchor::left ? "start" : anchor == Anchor::right ? "end" : "middle";
}

/// The line's runs; a lowered one is a tspan, and the next goes back up to the baseline.
std::string marked_up(const Text& text) {
  std::string out;
  double below = 0;
  for (const TextRun& run : runs_of(text.text, text.size, text.weight)) {
    const double shift = run.below - below;
    const std::string size = run.below == 0 ? "" : fmt::format(" font-size=\"{:g}\"", run.size);
    out += shift == 0 ? escaped(run.text)
                      : fmt::format("<tspan dy=\"{:.2f}\"{}>{}</tspan>", shift, size, escaped(run.text));
    below = run.below;
  }
  return out;
}

struct SvgWriter {
  std::string operator()(const Triangle& triangle) const {
    return polygon({triangle.corners.begin(), triangle.corners.end()}, triangle.fill);
  }
  std::string operator()(const Polygon& shape) const { return polygon(shape.corners, shape.fill); }
  std::string operator()(const Band& band) const {
    std::vector<Vec2> corners = band.lower;
    corners.insert(corners.end(), band.upper.rbegin(), band.upper.rend());
    return polygon(corners, band.fill);
  }
  std::string operator()(const Polyline& line) const {
    const Polyline solid{line.points, {line.stroke.colour, line.stroke.width, {}, line.stroke.cap}};
    return fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{:g}\" stroke-linejoin=\"round\" "
        "stroke-linecap=\"{}\"{}/>\n",
        points_attribute(dashes(solid).front()), hex(line.stroke.colour), line.stroke.width,
        line.stroke.cap == Cap::round ? "round" : "butt", dash_attribute(line.stroke.dash));
  }
  std::string operator()(const Text& text) const {
    const std::string turn = text.direction == Direction::upwards
                                 ? fmt::format(" transform=\"rotate(-90 {:.2f} {:.2f})\"", text.at.x, text.at.y)
                                 : "";
    return fmt::format(
        "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:g}\" text-anchor=\"{}\" fill=\"{}\"{}{}>{}</text>\n", text.at.x,
        text.at.y, text.size, anchor_name(text.anchor), hex(text.colour), weight_attribute(text.weight), turn,
        marked_up(text));
  }
};

}  // namespace

void write_svg(const Drawing& drawing, const std::filesystem::path& path) {
  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "font-family=\"'DejaVu Sans', Verdana, sans-serif\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
      drawing.width, drawing.height);
  for (const Shape& shape : drawing.shapes) svg += std::visit(SvgWriter{}, shape);
  write_file_atomically(path, svg + "</svg>\n");
}

}  // namespace asperity::render
