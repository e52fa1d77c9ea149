#include "app/gallery/gallery_pictures.hpp"

#include "app/run_frames.hpp"
#include "core/config/enum_words.hpp"
#include "core/output/csv.hpp"
#include "render/charts.hpp"
#include "render/paint.hpp"
#include "render/scene.hpp"
#include "render/series.hpp"
#include "render/style.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

constexpr double kLineWidth = 2.2;

std::string heading_of(ExperimentType type) {
  std::string heading(word(type));
  for (char& c : heading) c = c == '_' ? ' ' : c;
  return heading;
}

void add_lines(const GalleryRuns& part, const std::string& label, render::Colour colour, std::vector<double> dash,
               render::Chart& chart) {
  bool first = true;
  const Abscissa abscissa = abscissa_of(part.experiment);
  for (const CampaignOutcome& outcome : part.outcomes) {
    if (outcome.status != RunStatus::finished) continue;
    const CsvData curves = read_csv(outcome.folder / "curves.csv");
    render::LineLayer line{first ? label : "",
                           abscissae(curves, abscissa),
                           curves.numbers(stress_column(part.experiment)),
                           {colour, kLineWidth, dash}};
    chart.layers.emplace_back(std::move(line));
    first = false;
  }
}

}  // namespace

std::optional<GalleryPicture> draw_curves(const Gallery& gallery, const MechanismDeclaration& mechanism,
                                          const fs::path& folder) {
  render::ChartFigure figure;
  figure.title = mechanism.id;
  for (const GalleryRuns& part : gallery.parts) {
    if (part.mechanism != mechanism.id) continue;
    render::Chart chart{
        heading_of(part.experiment), abscissa_of(part.experiment).label, stress_label(part.experiment), {}, {}, {}, {}};
    add_lines(*base_of(gallery, part.experiment), "without", render::style::kBlue, {}, chart);
    add_lines(part, "with " + mechanism.id, render::style::kVermilion, {14, 5}, chart);
    if (!chart.layers.empty()) figure.charts.push_back(std::move(chart));
  }
  if (figure.charts.empty()) return std::nullopt;
  figure.title = mechanism.title;
  figure.caption = std::to_string(gallery.seeds.size()) + " meshes each, the same with and without";
  figure.columns = figure.charts.size() == 1 ? 1 : 2;
  figure.height = figure.charts.size() > 2 ? 1300 : figure.charts.size() == 2 ? 800 : 1000;
  const fs::path png = fs::path("curves") / (mechanism.id + ".png"), svg = fs::path("curves") / (mechanism.id + ".svg");
  const render::Drawing drawing = render::draw_figure(figure);
  render::write_png(drawing, folder / png);
  render::write_svg(drawing, folder / svg);
  return GalleryPicture{png,
                        "Stress over strain or displacement of every experiment, with and without " + mechanism.id};
}

std::optional<GalleryPicture> draw_pattern(const GalleryRuns& part, const fs::path& folder) {
  if (part.outcomes.empty() || part.outcomes.front().status != RunStatus::finished) return std::nullopt;
  const fs::path& run = part.outcomes.front().folder;
  const RunConfig& config = part.runs.front().config;
  if (config.output.frames == 0) return std::nullopt;
  Frame frame = render::read_frame(run, static_cast<int>(render::series_times(run).size()) - 1);
  frame.name = part.mechanism.empty() ? "base" : part.mechanism;
  render::PictureOptions options;
  options.width = config.output.width_px;
  options.height = config.output.height_px;
  const std::string name = std::string(word(part.experiment)) + (part.mechanism.empty() ? "" : "_" + part.mechanism);
  const fs::path png = fs::path("patterns") / (name + ".png");
  render::draw_frame(frame, options, folder / png);
  return GalleryPicture{png, "Cracks at the end of the " + heading_of(part.experiment) + " test " +
                                 (part.mechanism.empty() ? "without mechanisms" : "with " + part.mechanism)};
}

}  // namespace asperity::app
