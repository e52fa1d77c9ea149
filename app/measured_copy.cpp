#include "app/measured_copy.hpp"

#include "app/report/run_report.hpp"
#include "app/run_plots.hpp"
#include "core/base/atomic_file.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "core/output/measured_curve.hpp"

namespace asperity::app {

MeasuredCopy measured_copy(const RunConfig& config) {
  if (read_measured_curves(config).empty()) return {};
  return {true, read_file(*config.output.measured_curve)};
}

void write_configs(const RunFolder& folder, RunConfig config, const std::string& original,
                   const MeasuredCopy& measured) {
  write_file_atomically(folder.original_config(), original);
  if (measured.given) {
    write_file_atomically(folder.measured_curve(), measured.text);
    config.output.measured_curve = folder.measured_curve().filename().string();
  }
  write_file_atomically(folder.effective_config(), effective_json(config));
}

bool has_measured(const RunConfig& config, const std::filesystem::path& root, const MeasuredCopy& measured) {
  const OutputConfig there = read_run_config(root / "config.effective.json").output;
  if (there.measured_curve.has_value() != measured.given) return false;
  return !measured.given ||
         (there.measured_name == config.output.measured_name && read_file(*there.measured_curve) == measured.text);
}

void renew_measured(const RunConfig& config, const std::string& original, const std::filesystem::path& root,
                    const MeasuredCopy& measured) {
  const RunFolder folder = RunFolder::open(root);
  write_configs(folder, config, original, measured);
  if (!measured.given) std::filesystem::remove(folder.measured_curve());
  draw_plots(folder, read_run_config(folder.effective_config()));
  if (std::filesystem::exists(folder.report())) write_run_report(root);
}

}  // namespace asperity::app
