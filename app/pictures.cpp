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

/// What the plots of a test stand over.
struct Abscissa {
  const char* column;
  double factor;
  const char* label;
};

Abscissa abscissa_of(ExperimentType type) {
  if (type == ExperimentType::direct_shear) return {"shear_displacement_mm", 1.0, "shear displacement [mm]"};
  return {"axial_strain", 100.0, strain_label(is_compression(type))};
}

std::vector<double> abscissae(const CsvData& table, const Abscissa& a) {
  return scaled(table.numbers(a.column), a.factor);
}

/// The paper's Figs 8 and 10.
void plot_shear(const CsvData& curves, const std::filesystem::path& path) {
  using render::SeriesKind;
  using render::VerticalAxis;
  const std::vector<double> x = curves.numbers("shear_displacement_mm");
  render::Plot plot;
  plot.title = "Shear stress and dilation against displacement";
  plot.x_label = "shear displacement [mm]";
  plot.y_label = "stress on the plan area [MPa]";
  plot.second_y_label = "dilation [mm]";
  plot.series = {{"shear stress", x, curves.numbers("shear_stress_mpa"), {}},
                 {"normal stress", x, curves.numbers("normal_stress_mpa"), {}},
                 {"dilation", x, curves.numbers("dilation_mm"), {SeriesKind::line, VerticalAxis::right, {}}}};
  render::write_plot(plot, path);
}

/// What each flank bears of the shear stress.
void plot_teeth(const CsvData& curves, std::size_t teeth, double length_mm, const std::filesystem::path& path) {
  const std::vector<double> x = curves.numbers("shear_displacement_mm");
  render::Plot plot;
  plot.title = "Shear stress borne by each tooth's flanks";
  plot.x_label = "shear displacement [mm]";
  plot.y_label = "share of the shear stress [MPa]";
  plot.series = {{"whole joint", x, curves.numbers("shear_stress_mpa"), {}}};
  for (std::size_t i = 1; i <= teeth; ++i) {
    const std::string tooth = "tooth" + std::to_string(i) + "_", name = "tooth " + std::to_string(i) + ", ";
    plot.series.push_back({name + "leading flank", x, scaled(curves.numbers(tooth + "leading_x_n_per_mm"), 1 / length_mm), {}});
    plot.series.push_back({name + "trailing flank", x, scaled(curves.numbers(tooth + "trailing_x_n_per_mm"), 1 / length_mm), {}});
  }
  render::write_plot(plot, path);
}

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

void plot_energy(const CsvData& energy, const Abscissa& abscissa, const std::filesystem::path& path) {
  using render::SeriesKind;
  const std::vector<double> strain = abscissae(energy, abscissa);
  const auto area = [&](const char* label, const char* column) {
    return render::PlotSeries{
        label, strain, energy.numbers(column), {SeriesKind::stacked_area, render::VerticalAxis::left, {}}};
  };
  render::Plot plot;
  plot.title = "Energy account";
  plot.x_label = abscissa.label;
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

const char* stress_column(ExperimentType type) {
  return type == ExperimentType::direct_shear ? "shear_stress_mpa" : "axial_stress_mpa";
}

const char* stress_label(ExperimentType type) {
  if (type == ExperimentType::direct_shear) return "shear stress [MPa]";
  return is_compression(type) ? "σ₁ [MPa]" : "2P/(πDt) [MPa]";
}

void plot_cracks(const CsvData& curves, ExperimentType type, const std::filesystem::path& path) {
  const Abscissa abscissa = abscissa_of(type);
  const std::vector<double> strain = abscissae(curves, abscissa);
  const std::vector<double> tension = curves.numbers("cracks_tension");
  const std::vector<double> shear = curves.numbers("cracks_shear");
  render::Plot plot;
  plot.title = type == ExperimentType::direct_shear ? "Broken contacts against displacement" : "Broken contacts against strain";
  plot.x_label = abscissa.label;
  plot.y_label = "broken contacts";
  plot.second_y_label = stress_label(type);
  plot.series = {{"tension", strain, tension, {}},
                 {"shear", strain, shear, {}},
                 {"all", strain, sum(tension, shear), {}},
                 {"stress",
                  strain,
                  curves.numbers(stress_column(type)),
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

void draw_plots(const RunFolder& folder, const Model& model) {
  const CsvData curves = read_csv(folder.curves());
  const ExperimentType type = model.config.experiment.type;
  if (type == ExperimentType::direct_shear) {
    plot_shear(curves, folder.plots() / "shear_stress");
    const std::size_t teeth = model.joint.gauge.tooth_area_mm2.size();
    if (teeth > 0) plot_teeth(curves, teeth, model.joint.profile.length(), folder.plots() / "teeth");
  } else {
    plot_stress_strain(curves, is_compression(type), folder.plots() / "stress_strain");
  }
  plot_energy(read_csv(folder.energy()), abscissa_of(type), folder.plots() / "energy");
  plot_cracks(curves, type, folder.plots() / "cracks");
}

}  // namespace asperity::app
