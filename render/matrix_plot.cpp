#include "render/matrix_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/base/error.hpp"
#include "render/axes.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

constexpr double kMargin = 36, kGap = 12, kLine = 34;                  // pixels
constexpr double kNameSize = 24, kCellSize = 24, kCaptionSize = 24;    // of texts, pixels
constexpr double kLeastCell = 64, kLargestCell = 120, kWanted = 1100;  // pixels
constexpr double kBarWidth = 28, kBarGap = 34;                         // of the colour bar, pixels
constexpr int kSlices = 64, kBarParts = 4;
constexpr double kCapHeight = 0.36;  // half of a digit's height, parts of its size
constexpr double kDarkest = 140;     // luma of a fill below which its text is white

/// "seating" of "seating × 0.5": what is hidden, whatever its strength.
std::string before_factor(const std::string& row) { return row.substr(0, row.find(" × ")); }

/// Where everything stands.
struct Layout {
  double cell = 0;
  Box frame;          ///< Of the cells.
  double notes = 0;   ///< Width of the rows' notes.
  double header = 0;  ///< Bottom of title and caption.
  std::vector<std::string> caption;
  int width = 0, height = 0;
};

double widest(const std::vector<std::string>& texts, double size) {
  double width = 0;
  for (const std::string& text : texts) width = std::max(width, text_width(text, size));
  return width;
}

Text text_at(Vec2 at, const std::string& text, double size, Anchor anchor, Colour colour = style::kInk) {
  return {at, text, size, anchor, Weight::regular, Direction::across, colour};
}

Layout layout_of(const MatrixPlot& p) {
  Layout l;
  const auto rows = static_cast<double>(p.rows.size()), columns = static_cast<double>(p.columns.size());
  l.cell = std::floor(std::clamp(kWanted / std::max(rows, columns), kLeastCell, kLargestCell));
  l.notes = p.row_notes.empty() ? 0 : widest(p.row_notes, kNameSize) + kGap;
  const double left = kMargin + kLine + kGap + widest(p.rows, kNameSize) + kGap;
  const double right = l.notes + kBarGap + kBarWidth + 90 + style::kLabelSize + kMargin;
  const double title = text_width(p.title, style::kTitleSize, Weight::bold) + 2 * kMargin;
  const double columns_title = text_width(p.columns_title, style::kLabelSize) + left + kMargin;
  l.width = static_cast<int>(std::ceil(std::max({left + columns * l.cell + right, title, columns_title})));
  l.caption = wrapped(p.caption, kCaptionSize, l.width - 2 * kMargin);
  l.header = kMargin + style::kTitleSize + kGap + kLine * static_cast<double>(l.caption.size());
  const double top = std::ceil(l.header + kGap + kLine + kGap + widest(p.columns, kNameSize) + 2 * kGap);
  const double least = text_width(p.rows_title, style::kLabelSize);
  l.frame = {std::ceil(left), top, std::ceil(left) + columns * l.cell, top + rows * l.cell};
  l.height = static_cast<int>(std::max(l.frame.bottom, top + least) + kMargin);
  return l;
}

void require(bool good, const std::string& what, const std::string& value, const std::string& allowed) {
  if (!good) throw Error(ErrorKind::config, {{"matrix", what, value, allowed, ""}});
}

template <class Cell>
void require_size(const std::vector<std::vector<Cell>>& cells, const MatrixPlot& p, const std::string& name) {
  require(cells.size() == p.rows.size(), name + " has another number of rows than there are names",
          std::to_string(cells.size()), std::to_string(p.rows.size()));
  for (const auto& row : cells)
    require(row.size() == p.columns.size(), name + " has a row of another length than there are columns",
            std::to_string(row.size()), std::to_string(p.columns.size()));
}

void check(const MatrixPlot& p) {
  require(!p.rows.empty() && !p.columns.empty(), "has no cell", "", "a name of a row and of a column at least");
  require_size(p.values, p, "values");
  require_size(p.texts, p, "texts");
}

/// White on dark fills (luma of ITU-R BT.601).
Colour ink_on(Colour fill) {
  return 0.299 * fill.r + 0.587 * fill.g + 0.114 * fill.b < kDarkest ? style::kPaper : style::kInk;
}

void draw_cell(Drawing& drawing, const MatrixPlot& p, const Layout& l, std::size_t row, std::size_t column) {
  const double left = l.frame.left + static_cast<double>(column) * l.cell;
  const double top = l.frame.top + static_cast<double>(row) * l.cell;
  const Box box{left, top, left + l.cell, top + l.cell};
  const double value = p.values[row][column];
  const Colour fill = std::isfinite(value) ? colour_at(p.map, fraction_in(p.range, value)) : style::kPaper;
  add_box(drawing, box, fill);
  const std::string& text = p.texts[row][column];
  if (text.empty()) return;
  const double size = fitting_size(text, kCellSize, Weight::regular, l.cell - 8);
  drawing.shapes.push_back(
      text_at({box.centre().x, box.centre().y + kCapHeight * size}, text, size, Anchor::centre, ink_on(fill)));
}

void draw_lines(Drawing& drawing, const MatrixPlot& p, const Layout& l) {
  const Stroke thin{style::kGrid, 2, {}, Cap::butt};
  for (std::size_t i = 1; i < p.rows.size(); ++i) {
    const double y = l.frame.top + static_cast<double>(i) * l.cell;
    add_line(drawing, {l.frame.left, y}, {l.frame.right, y}, thin);
  }
  for (std::size_t j = 1; j < p.columns.size(); ++j) {
    const double x = l.frame.left + static_cast<double>(j) * l.cell;
    add_line(drawing, {x, l.frame.top}, {x, l.frame.bottom}, thin);
  }
  add_frame(drawing, l.frame, {style::kInk, 2, {}, Cap::butt});
  for (std::size_t i = 0; i < p.rows.size() && p.frame_same_names; ++i) {
    for (std::size_t j = 0; j < p.columns.size(); ++j) {
      if (before_factor(p.rows[i]) != p.columns[j]) continue;
      const double left = l.frame.left + static_cast<double>(j) * l.cell;
      const double top = l.frame.top + static_cast<double>(i) * l.cell;
      add_frame(drawing, {left, top, left + l.cell, top + l.cell}, {style::kInk, 5, {}, Cap::butt});
    }
  }
}

void draw_names(Drawing& drawing, const MatrixPlot& p, const Layout& l) {
  for (std::size_t i = 0; i < p.rows.size(); ++i) {
    const double y = l.frame.top + (static_cast<double>(i) + 0.5) * l.cell + kCapHeight * kNameSize;
    drawing.shapes.push_back(text_at({l.frame.left - kGap, y}, p.rows[i], kNameSize, Anchor::right));
    if (i < p.row_notes.size())
      drawing.shapes.push_back(
          text_at({l.frame.right + kGap, y}, p.row_notes[i], kNameSize, Anchor::left, style::kSoftInk));
  }
  for (std::size_t j = 0; j < p.columns.size(); ++j) {
    const double x = l.frame.left + (static_cast<double>(j) + 0.5) * l.cell + kCapHeight * kNameSize;
    Text name = text_at({x, l.frame.top - kGap}, p.columns[j], kNameSize, Anchor::left);
    name.direction = Direction::upwards;
    drawing.shapes.push_back(name);
  }
}

void draw_titles(Drawing& drawing, const MatrixPlot& p, const Layout& l) {
  Text title = text_at({kMargin, kMargin + 0.8 * style::kTitleSize}, p.title, style::kTitleSize, Anchor::left);
  title.weight = Weight::bold;
  drawing.shapes.push_back(title);
  double y = kMargin + style::kTitleSize + kGap;
  for (const std::string& line : l.caption) {
    drawing.shapes.push_back(
        text_at({kMargin, y + 0.8 * kCaptionSize}, line, kCaptionSize, Anchor::left, style::kSoftInk));
    y += kLine;
  }
  drawing.shapes.push_back(
      text_at({l.frame.left, l.header + kGap + 0.8 * kLine}, p.columns_title, style::kLabelSize, Anchor::left));
  Text rows = text_at({kMargin + 0.8 * style::kLabelSize, l.frame.top}, p.rows_title, style::kLabelSize, Anchor::right);
  rows.direction = Direction::upwards;
  drawing.shapes.push_back(rows);
}

void draw_bar(Drawing& drawing, const MatrixPlot& p, const Layout& l) {
  const double left = l.frame.right + l.notes + kBarGap, right = left + kBarWidth;
  const double height = std::max(l.frame.height(), 4 * kLeastCell), slice = height / kSlices;
  const double bottom = l.frame.top + height;
  for (int i = 0; i < kSlices; ++i) {
    const double low = bottom - i * slice;
    add_box(drawing, {left, low - slice, right, low}, colour_at(p.map, (i + 0.5) / kSlices));
  }
  add_frame(drawing, {left, l.frame.top, right, bottom}, {style::kInk, 2, {}, Cap::butt});
  const Axis axis = make_axis(p.range, p.value_label, kBarParts);
  for (const Tick& tick : axis.ticks) {
    const double y = bottom - fraction_in(p.range, tick.value) * height;
    add_line(drawing, {right, y}, {right + 7, y}, {style::kInk, 2, {}, Cap::butt});
    drawing.shapes.push_back(text_at({right + 15, y + kCapHeight * kNameSize}, tick.label, kNameSize, Anchor::left));
  }
  Text label = text_at({right + 90 + 0.8 * style::kLabelSize, l.frame.top + 0.5 * height}, p.value_label,
                       fitting_size(p.value_label, style::kLabelSize, Weight::regular, height), Anchor::centre);
  label.direction = Direction::upwards;
  drawing.shapes.push_back(label);
}

}  // namespace

Drawing draw_matrix(const MatrixPlot& plot) {
  check(plot);
  const Layout layout = layout_of(plot);
  Drawing drawing{
      layout.width, std::max(layout.height, static_cast<int>(layout.frame.top + 4 * kLeastCell + kMargin)), {}};
  for (std::size_t i = 0; i < plot.rows.size(); ++i) {
    for (std::size_t j = 0; j < plot.columns.size(); ++j) draw_cell(drawing, plot, layout, i, j);
  }
  draw_lines(drawing, plot, layout);
  draw_names(drawing, plot, layout);
  draw_titles(drawing, plot, layout);
  draw_bar(drawing, plot, layout);
  return drawing;
}

MatrixPlot confusion_matrix(const std::vector<std::string>& rows, const std::vector<std::string>& columns,
                            const std::vector<std::vector<double>>& counts) {
  MatrixPlot plot;
  plot.title = "What was hidden, and what was named";
  plot.caption = "Numbers: data sets, an empty cell: none. Colour: share of the row. Framed: the right name.";
  plot.rows_title = "hidden";
  plot.columns_title = "named";
  plot.value_label = "share of the row [–]";
  plot.frame_same_names = true;
  plot.rows = rows;
  plot.columns = columns;
  for (const std::vector<double>& row : counts) {
    const double sum = std::accumulate(row.begin(), row.end(), 0.0);
    plot.values.emplace_back();
    plot.texts.emplace_back();
    for (const double count : row) {
      plot.values.back().push_back(count > 0.0 ? count / sum : NAN);
      plot.texts.back().push_back(count > 0.0 ? fmt::format("{:g}", count) : "");
    }
    plot.row_notes.push_back(fmt::format("n = {:g}", sum));
  }
  return plot;
}

MatrixPlot cosine_matrix(const std::vector<std::string>& names, const std::vector<std::vector<double>>& cosines) {
  MatrixPlot plot;
  plot.title = "Likeness of the fingerprints";
  plot.caption =
      "Cosine between what two mechanisms change, in standard deviations and without what calibration absorbs. Near 1: "
      "these tests hardly tell them apart; near 0: clearly.";
  plot.value_label = "cosine [–]";
  plot.rows = plot.columns = names;
  plot.values = cosines;
  plot.range = {-1, 1};
  plot.map = ColourMap::red_blue;
  for (const std::vector<double>& row : cosines) {
    plot.texts.emplace_back();
    for (const double c : row) plot.texts.back().push_back(std::isfinite(c) ? tick_label(c, 0.01) : "–");
  }
  return plot;
}

}  // namespace asperity::render
