#include "render/bar_panels.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "render/axes.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kMargin = 36, kGap = 14, kBetween = 40;                         // pixels
constexpr double kRow = 38, kGroupGap = 14, kBar = 22;                           // pixels
constexpr double kNameSize = 23, kHeadingSize = 24, kTickSize = 22, kLine = 32;  // pixels
constexpr double kLeastReach = 3;  // of the scale, so that small residuals look small
constexpr double kCapHeight = 0.36;
constexpr int kWidth = 1700, kTicks = 4;

Text text_at(Vec2 at, const std::string& text, double size, Anchor anchor, Weight weight, Colour colour) {
  return {at, text, size, anchor, weight, Direction::across, colour};
}

/// Where everything stands.
struct Layout {
  std::vector<double> row_y;       ///< Middle of each row.
  std::vector<double> group_line;  ///< Between groups.
  double names = 0, left = 0, panel = 0, top = 0, bottom = 0, headings = 0;
  std::vector<std::string> caption;
  std::vector<std::vector<std::string>> panel_headings;
  double reach = kLeastReach;
};

double reach_of(const BarPanels& plot) {
  double reach = kLeastReach;
  for (const BarPanel& panel : plot.panels) {
    for (const double v : panel.values) {
      if (std::isfinite(v)) reach = std::max(reach, 1.08 * std::abs(v));
    }
  }
  return reach;
}

void place_rows(const BarPanels& plot, Layout& l) {
  double y = l.top + 0.5 * kGroupGap;
  for (std::size_t i = 0; i < plot.rows.size(); ++i) {
    if (i > 0 && plot.rows[i].group != plot.rows[i - 1].group) {
      l.group_line.push_back(y + 0.5 * kGroupGap);
      y += kGroupGap;
    }
    l.row_y.push_back(y + 0.5 * kRow);
    y += kRow;
  }
  l.bottom = y + 0.5 * kGroupGap;
}

Layout layout_of(const BarPanels& plot) {
  Layout l;
  double groups = 0, names = 0;
  for (const BarRow& row : plot.rows) {
    groups = std::max(groups, text_width(row.group, kNameSize, Weight::bold));
    names = std::max(names, text_width(row.name, kNameSize));
  }
  l.names = kMargin + groups + 1.5 * kGap;
  l.left = std::ceil(l.names + names + kGap);
  const double count = static_cast<double>(plot.panels.size());
  l.panel = (kWidth - kMargin - l.left - (count - 1) * kBetween) / count;
  l.caption = wrapped(plot.caption, kHeadingSize, kWidth - 2 * kMargin);
  std::size_t lines = 0;
  for (const BarPanel& panel : plot.panels) {
    l.panel_headings.push_back(wrapped(panel.heading, kHeadingSize, l.panel));
    lines = std::max(lines, l.panel_headings.back().size());
  }
  l.headings = kMargin + style::kTitleSize + kGap + kLine * static_cast<double>(l.caption.size()) + kGap;
  l.top = l.headings + kLine * static_cast<double>(lines) + kGap;
  l.reach = reach_of(plot);
  place_rows(plot, l);
  return l;
}

void draw_header(Drawing& drawing, const BarPanels& plot, const Layout& l) {
  drawing.shapes.push_back(text_at({kMargin, kMargin + 0.8 * style::kTitleSize}, plot.title, style::kTitleSize,
                                   Anchor::left, Weight::bold, style::kInk));
  double y = kMargin + style::kTitleSize + kGap;
  for (const std::string& line : l.caption) {
    drawing.shapes.push_back(
        text_at({kMargin, y + 0.8 * kHeadingSize}, line, kHeadingSize, Anchor::left, Weight::regular, style::kSoftInk));
    y += kLine;
  }
}

void draw_row_names(Drawing& drawing, const BarPanels& plot, const Layout& l) {
  for (std::size_t i = 0; i < plot.rows.size(); ++i) {
    const double y = l.row_y[i] + kCapHeight * kNameSize;
    if (i == 0 || plot.rows[i].group != plot.rows[i - 1].group)
      drawing.shapes.push_back(
          text_at({kMargin, y}, plot.rows[i].group, kNameSize, Anchor::left, Weight::bold, style::kInk));
    drawing.shapes.push_back(
        text_at({l.names, y}, plot.rows[i].name, kNameSize, Anchor::left, Weight::regular, style::kInk));
  }
}

void draw_scale(Drawing& drawing, const BarPanels& plot, const Layout& l, const Box& box) {
  const auto x_of = [&](double v) { return box.centre().x + 0.5 * box.width() * v / l.reach; };
  for (const double guide : {-plot.guide, plot.guide})
    add_line(drawing, {x_of(guide), box.top}, {x_of(guide), box.bottom}, {style::kSoftInk, 2, {8, 8}, Cap::butt});
  const Axis axis = make_axis({-l.reach, l.reach}, "", kTicks);
  for (const Tick& tick : axis.ticks) {
    add_line(drawing, {x_of(tick.value), box.bottom}, {x_of(tick.value), box.bottom + 8},
             {style::kInk, 2, {}, Cap::butt});
    drawing.shapes.push_back(text_at({x_of(tick.value), box.bottom + 14 + kTickSize}, tick.label, kTickSize,
                                     Anchor::centre, Weight::regular, style::kInk));
  }
}

void draw_panel(Drawing& drawing, const BarPanels& plot, const Layout& l, std::size_t number) {
  const BarPanel& panel = plot.panels[number];
  const double left = l.left + static_cast<double>(number) * (l.panel + kBetween);
  const Box box{left, l.top, left + l.panel, l.bottom};
  double y = l.top - kGap - kLine * static_cast<double>(l.panel_headings[number].size());
  for (const std::string& line : l.panel_headings[number]) {
    drawing.shapes.push_back(text_at({box.centre().x, y + 0.8 * kLine}, line,
                                     fitting_size(line, kHeadingSize, Weight::regular, l.panel), Anchor::centre,
                                     Weight::regular, style::kInk));
    y += kLine;
  }
  for (const double line : l.group_line)
    add_line(drawing, {box.left, line}, {box.right, line}, {style::kGrid, 2, {}, Cap::butt});
  draw_scale(drawing, plot, l, box);
  for (std::size_t i = 0; i < std::min(plot.rows.size(), panel.values.size()); ++i) {
    if (!std::isfinite(panel.values[i])) continue;
    const double tip = box.centre().x + 0.5 * box.width() * panel.values[i] / l.reach;
    add_box(drawing,
            {std::min(box.centre().x, tip), l.row_y[i] - 0.5 * kBar, std::max(box.centre().x, tip),
             l.row_y[i] + 0.5 * kBar},
            panel.colour);
  }
  add_line(drawing, {box.centre().x, box.top}, {box.centre().x, box.bottom}, {style::kInk, 2, {}, Cap::butt});
  add_frame(drawing, box, {style::kInk, 2, {}, Cap::butt});
}

}  // namespace

Drawing draw_bar_panels(const BarPanels& plot) {
  assert(!plot.rows.empty() && !plot.panels.empty() && plot.panels.size() <= 5);
  const Layout l = layout_of(plot);
  const double label_y = l.bottom + 14 + kTickSize + kGap + style::kLabelSize;
  Drawing drawing{kWidth, static_cast<int>(std::ceil(label_y + kMargin)), {}};
  draw_header(drawing, plot, l);
  draw_row_names(drawing, plot, l);
  for (std::size_t i = 0; i < plot.panels.size(); ++i) draw_panel(drawing, plot, l, i);
  drawing.shapes.push_back(text_at({0.5 * (l.left + kWidth - kMargin), label_y}, plot.x_label, style::kLabelSize,
                                   Anchor::centre, Weight::regular, style::kInk));
  return drawing;
}

}  // namespace asperity::render
