#include "app/report/report_parts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "render/paint.hpp"

namespace asperity::app {

html::Markup plot_figure(const ReportContext& context, const PlotText& text, const render::ChartFigure& figure) {
  const std::filesystem::path plots = "plots", png = plots / (text.name + ".png"), svg = plots / (text.name + ".svg");
  const render::Drawing drawing = render::draw_figure(figure);
  render::write_png(drawing, context.folder / png);
  render::write_svg(drawing, context.folder / svg);
  return html::figure({{{html::linked_source(png), text.alternative_text}}, text.caption, {{svg, "SVG"}}});
}

html::Markup with_unit(const html::Markup& number, const Quantity& quantity) {
  if (quantity.unit == "–" || quantity.unit.empty()) return number;
  return number + (quantity.unit == "°" ? "°" : " " + quantity.unit);
}

html::Markup quantity_text(double value, const Quantity& quantity, int digits) {
  return std::isfinite(value) ? with_unit(html::number(value, digits), quantity) : "–";
}

html::Markup percent(double share) {
  if (!std::isfinite(share)) return "–";
  return fmt::format("{}{:.1f} %", share < 0 ? "−" : "+", std::abs(100 * share));
}

html::Markup p_value(double p) {
  if (!std::isfinite(p)) return "–";
  return p < 0.001 ? "< 0.001" : fmt::format("{:.3f}", p);
}

std::string held_text(const CalibrationData& data, std::size_t i, std::size_t j) {
  const std::vector<double> held = data.held();
  std::string text;
  for (std::size_t k = 0; k < held.size(); ++k) {
    if (k == i || k == j) continue;
    const FactorData& factor = data.factors[k];
    const std::string unit =
        factor.quantity.unit == "–" ? "" : (factor.quantity.unit == "°" ? "" : " ") + factor.quantity.unit;
    text += fmt::format("{}{} = {:.3g}{}", text.empty() ? "" : ", ", picture_symbol(factor.quantity),
                        factor.real(held[k]), unit);
  }
  return text;
}

html::Column quantity_column(const Quantity& quantity) {
  return {page_symbol(quantity), quantity.unit, html::ColumnKind::number};
}

}  // namespace asperity::app
