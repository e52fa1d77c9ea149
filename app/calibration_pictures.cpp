#include "app/calibration_pictures.hpp"

#include "app/report/calibration_report.hpp"
#include "core/base/output_error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/measurement/capture.hpp"
#include "render/scene.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

/// The cracks at the end of a run of the store, under the parameter set's name; none where it kept no frame.
void draw_cracks(const fs::path& run, const std::string& set, const fs::path& png) {
  const std::size_t frames = fs::exists(run / "fields.pvd") ? render::series_times(run).size() : 0;
  if (frames == 0) return;
  Frame frame = render::read_frame(run, static_cast<int>(frames) - 1);
  frame.name = set;
  render::draw_frame(frame, {}, png);
}

void draw_set(const fs::path& folder, const VerifiedSet& set, const std::string& name, const std::string& prefix) {
  if (set.cases.empty()) return;
  for (const fs::path& run : set.cases.front().folders) {
    const ExperimentConfig e = read_run_config(run / "config.effective.json").experiment;
    const std::string pressure = e.type == ExperimentType::triaxial ? "_" + number_text(e.confining_pressure_mpa) : "";
    draw_cracks(run, name, folder / (prefix + experiment_name(e.type) + pressure + "_cracks.png"));
  }
}

}  // namespace

void draw_calibration(const fs::path& folder, const SimulatedResult& result) {
  std::error_code error;
  fs::create_directories(folder / "pictures", error);
  if (error) throw output_error(folder / "pictures", "cannot be created", error.value());
  draw_set(folder / "pictures", result.verified, "chosen parameters", "");
  for (std::size_t i = 0; i < result.trade_off.size(); ++i) {
    const VerifiedSet& set = result.trade_off[i];
    draw_set(folder / "pictures", set, set.name, "trade_off_" + std::to_string(i + 1) + "_");
  }
  draw_calibration(folder);
}

void draw_calibration(const fs::path& folder) { write_calibration_report(folder); }

}  // namespace asperity::app
