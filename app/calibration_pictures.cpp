#include "app/calibration_pictures.hpp"

#include <algorithm>

#include "app/pictures.hpp"
#include "app/report/calibration_report.hpp"
#include "core/base/atomic_file.hpp"
#include "core/base/output_error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/schema_lookup.hpp"
#include "core/measurement/capture.hpp"
#include "core/output/run_folder.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

/// The last picture of the cracks in a run of the store, drawn if need be; empty where it kept no frame.
fs::path crack_picture(const fs::path& run) {
  if (!fs::exists(run / "fields.pvd")) return {};
  const RunFolder folder = RunFolder::open(run);
  const OutputConfig output = read_run_config(folder.effective_config()).output;
  if (output.frames == 0) return {};
  draw_frames(folder, output, {"cracks"}, "last");
  std::vector<fs::path> pictures;
  for (const auto& entry : fs::directory_iterator(folder.frames())) {
    if (entry.path().filename().string().starts_with("cracks_")) pictures.push_back(entry.path());
  }
  return pictures.empty() ? fs::path() : *std::max_element(pictures.begin(), pictures.end());
}

void copy_pictures(const fs::path& folder, const VerifiedSet& set, const std::string& prefix) {
  if (set.cases.empty()) return;
  for (const fs::path& run : set.cases.front().folders) {
    const fs::path picture = crack_picture(run);
    if (picture.empty()) continue;
    const ExperimentConfig e = read_run_config(run / "config.effective.json").experiment;
    const std::string pressure = e.type == ExperimentType::triaxial ? "_" + number_text(e.confining_pressure_mpa) : "";
    const std::string test = experiment_name(e.type) + pressure;
    write_file_atomically(folder / (prefix + test + "_cracks.png"), read_file(picture));
  }
}

}  // namespace

void draw_calibration(const fs::path& folder, const SimulatedResult& result) {
  std::error_code error;
  fs::create_directories(folder / "pictures", error);
  if (error) throw output_error(folder / "pictures", "cannot be created", error.value());
  copy_pictures(folder / "pictures", result.verified, "");
  for (std::size_t i = 0; i < result.trade_off.size(); ++i)
    copy_pictures(folder / "pictures", result.trade_off[i], "trade_off_" + std::to_string(i + 1) + "_");
  draw_calibration(folder);
}

void draw_calibration(const fs::path& folder) { write_calibration_report(folder); }

}  // namespace asperity::app
