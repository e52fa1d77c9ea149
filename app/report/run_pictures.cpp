#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/report/run_parts.hpp"
#include "core/measurement/telling_rows.hpp"
#include "core/output/html_viewer.hpp"
#include "core/output/measured_curve.hpp"
#include "render/axes.hpp"
#include "render/range.hpp"
#include "render/scene.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBuckets = 200;  // of a small curve, two points each
constexpr int kParts = 5;              // ticks of a small curve

html::SmallAxis small_axis(const std::vector<double>& values, const std::string& label) {
  const render::Range range = render::with_headroom(render::reaching_zero(render::range_of(values)));
  const render::Axis axis = render::make_axis(range, label, kParts);
  html::SmallAxis small{axis.label, axis.range.low, axis.range.high, {}};
  for (const render::Tick& tick : axis.ticks) small.ticks.push_back({tick.value, tick.label});
  return small;
}

html::SmallCurve small_curve(const RunContext& context) {
  const ExperimentType type = context.config.experiment.type;
  const Abscissa abscissa = abscissa_of(type);
  const std::vector<double> x = abscissae(context.curves, abscissa);
  const std::vector<double> y = context.curves.numbers(stress_column(type));
  html::SmallCurve curve{small_axis(x, abscissa.label),
                         small_axis(y, stress_label(type)),
                         {},
                         {},
                         "The run's curve with the shown frame's point on it."};
  for (const std::size_t row : telling_rows(y, kBuckets)) {
    curve.x_values.push_back(x[row]);
    curve.y_values.push_back(y[row]);
  }
  return curve;
}

/// A picture's preview; the picture itself in the folder of a run that was drawn before there were previews.
fs::path shown_picture(const fs::path& folder, const fs::path& picture) {
  const fs::path preview = render::preview_path(picture);
  return fs::exists(folder / preview) ? preview : picture;
}

/// The kinds of pictures of which at least one was drawn, those of the configuration first.
std::vector<html::PictureKind> picture_kinds(const RunContext& context) {
  std::vector<std::string> names = context.config.output.fields;
  for (const render::Field field : render::all_fields())
    if (const std::string name(render::field_name(field)); std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  std::vector<html::PictureKind> kinds;
  for (const std::string& name : names) {
    html::PictureKind kind{name, {}, {}};
    std::replace(kind.name.begin(), kind.name.end(), '_', ' ');
    bool any = false;
    for (const RunFrame& frame : context.frames) {
      const fs::path picture = render::picture_path("", *render::field_from_name(name), frame.number);
      const bool there = fs::exists(context.folder / picture);
      any = any || there;
      kind.originals.push_back(there ? html::linked_source(picture) : "");
      kind.sources.push_back(there ? html::linked_source(shown_picture(context.folder, picture)) : "");
    }
    if (any) kinds.push_back(std::move(kind));
  }
  return kinds;
}

html::Markup viewer(const RunContext& context, std::vector<html::PictureKind> kinds) {
  html::FrameViewer viewer{std::move(kinds), {}, 0, small_curve(context)};
  for (const RunFrame& frame : context.frames)
    viewer.frames.push_back(
        {frame.abscissa, frame.stress_mpa,
         fmt::format("Frame {} of {}: {}", frame.number + 1, context.frames.size(), frame_text(context, frame))});
  const std::vector<std::string>& sources = viewer.kinds.front().sources;
  for (std::size_t i = 0; i < sources.size(); ++i)
    if (!sources[i].empty()) viewer.shown = i;
  return html::frame_viewer(viewer);
}

std::string measured_words(const RunContext& context) {
  std::string names;
  for (const MeasuredCurve& curve : read_measured_curves(context.config))
    names += (names.empty() ? "" : "; ") + curve.name;
  return names.empty() ? "" : " Points are measured: " + names + ".";
}

}  // namespace

std::optional<html::Markup> run_figure(const RunContext& context, const std::string& name,
                                       const std::string& alternative_text, const html::Markup& caption) {
  const fs::path png = fs::path("plots") / (name + ".png"), svg = fs::path("plots") / (name + ".svg");
  if (!fs::exists(context.folder / png)) return std::nullopt;
  html::Figure figure{{{html::linked_source(png), alternative_text}}, caption, {}};
  if (fs::exists(context.folder / svg)) figure.links.push_back({svg, "SVG"});
  return html::figure(figure);
}

std::string frame_text(const RunContext& context, const RunFrame& frame) {
  const std::string at = render::tick_label(frame.abscissa, 0.001), stress = render::tick_label(frame.stress_mpa, 0.01);
  if (context.sheared()) return "shear displacement " + at + " mm, shear stress " + stress + " MPa";
  const bool disc = context.config.experiment.type == ExperimentType::brazilian;
  return (disc ? "closure / diameter " : "axial strain ") + at + " %, stress " + stress + " MPa";
}

html::Section pictures_section(const RunContext& context) {
  html::Section section{"Pictures", {}, {}};
  if (const auto strip = run_figure(context, "strip",
                                    "Five pictures of the specimen with its cracks, side by side in the order of time; "
                                    "what each is of stands under it.",
                                    "Cracks at half the way to the peak, the peak, the end of the largest fall behind "
                                    "it, half way from there on and the "
                                    "end, as near as frames were taken. Blue: broken in tension; vermilion with a "
                                    "white core: in shear; thin purple: "
                                    "softening."))
    section.parts.push_back(*strip);
  if (std::vector<html::PictureKind> kinds = picture_kinds(context); !kinds.empty()) {
    section.parts.push_back(html::paragraph(
        "Every frame: choose the kind of picture, then move the slider with the mouse or the arrow keys. A click on "
        "the picture opens it in full size."));
    section.parts.push_back(viewer(context, std::move(kinds)));
  } else {
    section.parts.push_back(
        html::notice(html::NoticeKind::information,
                     "No pictures of frames were drawn; asperity render draws them, asperity report the page."));
  }
  return section;
}

html::Section curves_section(const RunContext& context) {
  html::Section section{"Curves", {}, {}};
  const std::string measured = measured_words(context);
  const auto add = [&](const char* name, const char* alternative, const std::string& caption) {
    if (const auto figure = run_figure(context, name, alternative, caption)) section.parts.push_back(*figure);
  };
  add("stress_strain", "The stress over the strain of the test.", "Stress against strain." + measured);
  add("shear_stress", "Shear stress, normal stress and dilation over the shear displacement.",
      "Shear and normal stress on the joint's plan area (left) and dilation (right)." + measured);
  add("dilation", "Rise of the upper half, of its front and of its rear end over the shear displacement.",
      "Dilation of the upper block, and of the upper half's front end (towards which the lower half moves) and rear "
      "end." +
          measured);
  add("cracks", "Number of contacts broken in tension, in shear and in all, and the stress, over the test.",
      "Broken contacts by mode, with the stress.");
  return section;
}

}  // namespace asperity::app
