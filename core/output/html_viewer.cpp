#include "core/output/html_viewer.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <nlohmann/json.hpp>

namespace asperity::html {
namespace {

using Json = nlohmann::ordered_json;

// Of the curve's drawing, in its own units.
constexpr double kWidth = 480, kHeight = 330, kLeft = 62, kRight = 466, kTop = 14, kBottom = 278;
constexpr double kTickText = 14, kLabelText = 15;

double place(const SmallAxis& axis, double value, double from, double to) {
  return from + (value - axis.low) / (axis.high - axis.low) * (to - from);
}
double place_x(const SmallCurve& curve, double x) { return place(curve.x, x, kLeft, kRight); }
double place_y(const SmallCurve& curve, double y) { return place(curve.y, y, kBottom, kTop); }

std::string path_of(const SmallCurve& curve) {
  std::string path;
  bool drawing = false;
  for (std::size_t i = 0; i < curve.x_values.size(); ++i) {
    const bool finite = std::isfinite(curve.x_values[i]) && std::isfinite(curve.y_values[i]);
    if (finite)
      path += fmt::format("{}{:.1f} {:.1f}", drawing ? "L" : "M", place_x(curve, curve.x_values[i]),
                          place_y(curve, curve.y_values[i]));
    drawing = finite;
  }
  return path;
}

std::string ticks_html(const SmallCurve& curve) {
  std::string out;
  for (const SmallAxis::Tick& tick : curve.x.ticks) {
    const double x = place_x(curve, tick.value);
    out += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"></line>"
        "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\" font-size=\"{4}\">{5}</text>",
        x, kTop, kBottom, kBottom + 20, kTickText, escaped(tick.label));
  }
  for (const SmallAxis::Tick& tick : curve.y.ticks) {
    const double y = place_y(curve, tick.value);
    out += fmt::format(
        "<line class=\"grid\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" x1=\"{1}\" x2=\"{2}\"></line>"
        "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\" font-size=\"{5}\">{6}</text>",
        y, kLeft, kRight, kLeft - 8, y + 5, kTickText, escaped(tick.label));
  }
  return out;
}

std::string curve_html(const SmallCurve& curve, const FrameState& shown) {
  assert(!curve.alternative_text.empty());
  const double x = place_x(curve, shown.x), y = place_y(curve, shown.y);
  std::string out = fmt::format("<svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", kWidth, kHeight,
                                escaped(curve.alternative_text));
  out += ticks_html(curve);
  out += fmt::format("<rect class=\"edge\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"></rect>", kLeft, kTop,
                     kRight - kLeft, kBottom - kTop);
  out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\" font-size=\"{}\">{}</text>",
                     0.5 * (kLeft + kRight), kHeight - 8, kLabelText, escaped(curve.x.label));
  out += fmt::format(
      "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\" font-size=\"{}\">{}</text>",
      0.5 * (kTop + kBottom), kLabelText, escaped(curve.y.label));
  out += fmt::format("<path class=\"curve\" d=\"{}\"></path>", path_of(curve));
  out += fmt::format("<line class=\"guide\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1}\" y2=\"{2}\"></line>", x, kTop,
                     kBottom);
  return out + fmt::format("<circle class=\"present\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\"></circle></svg>", x, y);
}

Json data_of(const FrameViewer& viewer) {
  Json kinds = Json::array(), frames = Json::array();
  for (const PictureKind& kind : viewer.kinds)
    kinds.push_back({{"name", kind.name}, {"sources", kind.sources}, {"originals", kind.originals}});
  for (const FrameState& frame : viewer.frames) {
    frames.push_back({{"x", std::round(10 * place_x(viewer.curve, frame.x)) / 10},
                      {"y", std::round(10 * place_y(viewer.curve, frame.y)) / 10},
                      {"text", frame.text}});
  }
  return {{"kinds", kinds}, {"frames", frames}};
}

std::string kind_buttons(const FrameViewer& viewer) {
  std::string out = "<fieldset><legend>Picture</legend>";
  for (std::size_t i = 0; i < viewer.kinds.size(); ++i)
    out += fmt::format("<label><input type=\"radio\" name=\"picture-kind\" value=\"{}\"{}> {}</label> ", i,
                       i == 0 ? " checked" : "", escaped(viewer.kinds[i].name));
  return out + "</fieldset>";
}

std::string frame_slider(const FrameViewer& viewer) {
  return fmt::format(
      "<div class=\"slider\"><button type=\"button\" data-step=\"-1\" aria-label=\"Frame before\">◀</button>"
      "<input type=\"range\" min=\"0\" max=\"{}\" step=\"1\" value=\"{}\" aria-label=\"Frame\" aria-valuetext=\"{}\">"
      "<button type=\"button\" data-step=\"1\" aria-label=\"Next frame\">▶</button>"
      "<button type=\"button\" data-play=\"\">Play</button></div>",
      viewer.frames.size() - 1, viewer.shown, escaped(viewer.frames[viewer.shown].text));
}

}  // namespace

Markup frame_viewer(const FrameViewer& viewer) {
  assert(!viewer.kinds.empty() && viewer.shown < viewer.frames.size());
  const FrameState& shown = viewer.frames[viewer.shown];
  const PictureKind& kind = viewer.kinds.front();
  const std::string &source = kind.sources.at(viewer.shown), &original = kind.originals.at(viewer.shown);
  std::string out = fmt::format("<div class=\"viewer\" data-viewer=\"{}\">\n", escaped(data_of(viewer).dump()));
  out += "<div class=\"controls\" hidden>" + kind_buttons(viewer) + frame_slider(viewer) + "</div>\n";
  out += fmt::format("<p class=\"state\" aria-live=\"polite\">{}</p>\n", escaped(shown.text));
  out += fmt::format(
      "<div class=\"viewed\"><div><a href=\"{3}\"><img src=\"{0}\" alt=\"{1}, {2}\"></a>"
      "<p class=\"missing\" hidden>No picture of this kind was drawn of this frame.</p></div>",
      source, escaped(kind.name), escaped(shown.text), original);
  out += curve_html(viewer.curve, shown);
  out +=
      "</div>\n<noscript><p>Without scripts the page shows one frame; all are beside it, in the folder "
      "frames.</p></noscript>\n</div>\n";
  return Markup::from_html(out);
}

std::string_view frame_viewer_script() {
  return R"js("use strict";
for (const viewer of document.querySelectorAll(".viewer")) {
  const data = JSON.parse(viewer.dataset.viewer);
  const find = (selector) => viewer.querySelector(selector);
  const slider = find("input[type=range]"), image = find("img"), link = image.parentElement;
  const play = find("[data-play]"), state = find(".state"), guide = find(".guide"), point = find(".present");
  let timer = 0;

  function kind() { return data.kinds[Number(find("input[type=radio]:checked").value)]; }

  function show() {
    const number = Number(slider.value), frame = data.frames[number], source = kind().sources[number];
    state.textContent = frame.text;
    slider.setAttribute("aria-valuetext", frame.text);
    guide.setAttribute("x1", frame.x);
    guide.setAttribute("x2", frame.x);
    point.setAttribute("cx", frame.x);
    point.setAttribute("cy", frame.y);
    link.hidden = !source;
    find(".missing").hidden = Boolean(source);
    if (!source) return;
    image.src = source;
    link.href = kind().originals[number];
    image.alt = kind().name + ", " + frame.text;
    const next = kind().sources[number + 1];
    if (next) new Image().src = next;
  }

  function pause() {
    clearInterval(timer);
    timer = 0;
    play.textContent = "Play";
  }

  function advance() {
    if (Number(slider.value) >= data.frames.length - 1) return pause();
    slider.value = Number(slider.value) + 1;
    show();
  }

  play.addEventListener("click", () => {
    if (timer) return pause();
    if (Number(slider.value) >= data.frames.length - 1) slider.value = 0;
    show();
    play.textContent = "Pause";
    timer = setInterval(advance, 300);
  });
  for (const button of viewer.querySelectorAll("[data-step]"))
    button.addEventListener("click", () => {
      pause();
      slider.value = Number(slider.value) + Number(button.dataset.step);
      show();
    });
  slider.addEventListener("input", () => { pause(); show(); });
  for (const radio of viewer.querySelectorAll("input[type=radio]")) radio.addEventListener("change", show);
  find(".controls").hidden = false;
  show();
}
)js";
}

}  // namespace asperity::html
