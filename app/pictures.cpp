#include "app/pictures.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "app/interruption.hpp"
#include "core/base/error.hpp"
#include "core/base/output_error.hpp"
#include "core/output/csv.hpp"
#include "core/output/run_files.hpp"
#include "render/plots.hpp"
#include "render/scene.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

std::vector<render::Field> parse_fields(const std::vector<std::string>& names) {
  std::vector<render::Field> fields;
  for (const std::string& name : names) {
    const auto field = render::field_from_name(name);
    if (!field) {
      std::string known;
      for (render::Field f : render::all_fields())
        known += (known.empty() ? "" : ", ") + std::string(render::field_name(f));
      throw Error(ErrorKind::usage, {{"--field", "is no field that can be drawn", name, known, ""}});
    }
    fields.push_back(*field);
  }
  return fields;
}

std::vector<int> parse_frames(const std::string& text, int count) {
  if (count == 0) {
    throw Error(ErrorKind::usage, {{"--frames", "there is nothing to draw: the run has no frames", "", "",
                                    "run it with /output/frames above 0"}});
  }
  if (text == "all") {
    std::vector<int> frames(count);
    std::iota(frames.begin(), frames.end(), 0);
    return frames;
  }
  if (text == "last") return {count - 1};
  int frame = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), frame);
  if (error != std::errc() || end != text.data() + text.size() || frame < 0 || frame >= count) {
    throw Error(ErrorKind::usage, {{"--frames", "names no frame of this run", text,
                                    "all, last, or 0 to " + std::to_string(count - 1), ""}});
  }
  return {frame};
}

std::vector<double> scaled(std::vector<double> values, double factor) {
  for (double& v : values) v *= factor;
  return values;
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

const char* strain_label(bool compression) { return compression ? "axial strain [%]" : "closure / diameter [%]"; }

void plot_stress_strain(const CsvData& curves, bool compression, const std::filesystem::path& path) {
  render::Plot plot;
  const std::vector<double> stress = curves.numbers("axial_stress_mpa");
  if (compression) {
    plot.title = "Axial stress against strain";
    plot.x_label = "ε [%]  (axial: shortening positive; lateral: widening drawn to the left)";
    plot.y_label = "σ₁ [MPa]";
    plot.series = {{"axial, platens (closure / height)", scaled(curves.numbers("axial_strain"), 100), stress, {}},
                   {"axial, gauge on the specimen", scaled(curves.numbers("gauge_axial_strain"), 100), stress, {}},
                   {"lateral, flanks at mid-height", scaled(curves.numbers("lateral_strain"), -100), stress, {}}};
  } else {
    plot.title = "Splitting stress against platen closure";
    plot.x_label = strain_label(compression);
    plot.y_label = "2P/(πDt) [MPa]";
    plot.series = {{"", scaled(curves.numbers("axial_strain"), 100), stress, {}}};
  }
  render::write_plot(plot, path);
}

void plot_energy(const CsvData& energy, bool compression, const std::filesystem::path& path) {
  using render::SeriesKind;
  const std::vector<double> strain = scaled(energy.numbers("axial_strain"), 100);
  const auto area = [&](const char* label, const char* column) {
    return render::PlotSeries{
        label, strain, energy.numbers(column), {SeriesKind::stacked_area, render::VerticalAxis::left, {}}};
  };
  render::Plot plot;
  plot.title = "Energy account";
  plot.x_label = strain_label(compression);
  plot.y_label = "energy [N mm]";
  plot.series = {area("elastic, particles", "elastic_n_mm"),
                 area("recoverable, contacts", "recoverable_n_mm"),
                 area("fracture", "fracture_n_mm"),
                 area("friction", "friction_n_mm"),
                 area("damping", "damping_n_mm"),
                 area("kinetic", "kinetic_n_mm"),
                 {"external work",
                  strain,
                  energy.numbers("external_work_n_mm"),
                  {SeriesKind::line, render::VerticalAxis::left, 0}}};
  render::write_plot(plot, path);
}

void plot_cracks(const CsvData& curves, bool compression, const std::filesystem::path& path) {
  const std::vector<double> strain = scaled(curves.numbers("axial_strain"), 100);
  const std::vector<double> tension = curves.numbers("cracks_tension");
  const std::vector<double> shear = curves.numbers("cracks_shear");
  render::Plot plot;
  plot.title = "Broken contacts against strain";
  plot.x_label = strain_label(compression);
  plot.y_label = "broken contacts";
  plot.second_y_label = compression ? "σ₁ [MPa]" : "2P/(πDt) [MPa]";
  plot.series = {{"tension", strain, tension, {}},
                 {"shear", strain, shear, {}},
                 {"all", strain, sum(tension, shear), {}},
                 {"stress",
                  strain,
                  curves.numbers("axial_stress_mpa"),
                  {render::SeriesKind::line, render::VerticalAxis::right, {}}}};
  render::write_plot(plot, path);
}

render::PictureOptions picture_options(const OutputConfig& output) {
  render::PictureOptions options;
  options.width = output.width_px;
  options.height = output.height_px;
  return options;
}

}  // namespace

void draw_frames(const RunFolder& folder, const OutputConfig& output, const std::vector<std::string>& fields,
                 const std::string& frames) {
  const int count = static_cast<int>(render::series_times(folder.root()).size());
  render::draw_series(folder.root(), parse_fields(fields.empty() ? output.fields : fields), parse_frames(frames, count),
                      picture_options(output));
}

void clear_pictures(const RunFolder& folder) try {
  if (!std::filesystem::exists(folder.frames())) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder.frames())) {
    if (is_run_file(entry.path().lexically_relative(folder.root()))) std::filesystem::remove(entry.path());
  }
} catch (const std::filesystem::filesystem_error& failure) {
  throw output_error(failure.path1(), "cannot be cleared", failure.code().value());
}

std::vector<int> frames_to_draw(const std::filesystem::path& root, const OutputConfig& output) {
  const int count = static_cast<int>(render::series_times(root).size());
  const std::vector<render::Field> fields = parse_fields(output.fields);
  std::vector<int> missing;
  for (int frame = 0; frame < count; ++frame) {
    const bool drawn = std::all_of(fields.begin(), fields.end(), [&](render::Field field) {
      return std::filesystem::exists(render::picture_path(root, field, frame));
    });
    if (!drawn) missing.push_back(frame);
  }
  return missing;
}

bool draw_until_interrupted(const RunFolder& folder, const OutputConfig& output, const std::vector<int>& frames) {
  return render::draw_series(folder.root(), parse_fields(output.fields), frames, picture_options(output),
                             interruption_requested);
}

void draw_plots(const RunFolder& folder, ExperimentType type) {
  const CsvData curves = read_csv(folder.curves());
  const bool compression = type != ExperimentType::brazilian;
  plot_stress_strain(curves, compression, folder.plots() / "stress_strain");
  plot_energy(read_csv(folder.energy()), compression, folder.plots() / "energy");
  plot_cracks(curves, compression, folder.plots() / "cracks");
}

}  // namespace asperity::app
