#include "app/gallery/gallery_pictures.hpp"

#include "app/pictures.hpp"
#include "app/run_frames.hpp"
#include "core/base/atomic_file.hpp"
#include "core/config/enum_words.hpp"
#include "core/config/read_config.hpp"
#include "core/output/run_folder.hpp"
#include "render/charts.hpp"
#include "render/paint.hpp"
#include "render/scene.hpp"
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
  const RunFolder run = RunFolder::open(part.outcomes.front().folder);
  const OutputConfig output = read_run_config(run.effective_config()).output;
  if (output.frames == 0) return std::nullopt;
  draw_frames(run, output, {"cracks"}, "last");
  const CsvData curves = read_csv(run.curves());
  const std::vector<RunFrame> frames = run_frames(run.root(), curves, part.experiment);
  if (frames.empty()) return std::nullopt;
  const std::string name = std::string(word(part.experiment)) + (part.mechanism.empty() ? "" : "_" + part.mechanism);
  const fs::path png = fs::path("patterns") / (name + ".png");
  write_file_atomically(folder / png,
                        read_file(render::picture_path(run.root(), render::Field::cracks, frames.back().number)));
  return GalleryPicture{png, "Cracks at the end of the " + heading_of(part.experiment) + " test " +
                                 (part.mechanism.empty() ? "without mechanisms" : "with " + part.mechanism)};
}

}  // namespace asperity::app
