#include <iostream>

#include "app/commands/commands.hpp"
#include "app/confrontation/confrontation_report.hpp"
#include "app/confrontation/confusion_picture.hpp"
#include "app/report/calibration_report.hpp"
#include "app/report/run_report.hpp"
#include "app/report/runs_index.hpp"
#include "app/run_plots.hpp"
#include "core/base/error.hpp"
#include "core/config/read_config.hpp"

namespace asperity::app {
namespace {

/// A run's plots are drawn anew with its page, so that both show the same; one without tables has none.
std::filesystem::path draw_run(const std::filesystem::path& root) {
  const RunFolder folder = RunFolder::open(root);
  const RunConfig config = read_run_config(folder.effective_config());
  if (std::filesystem::exists(folder.curves()) && std::filesystem::exists(folder.energy())) {
    draw_plots(folder, config);
    draw_strip(folder, config);
  }
  return write_run_report(root);
}

std::filesystem::path draw_report(const std::filesystem::path& folder) {
  if (is_calibration_folder(folder)) return write_calibration_report(folder);
  if (is_confrontation_folder(folder)) return write_confrontation_report(folder);
  if (is_run_folder(folder)) return draw_run(folder);
  if (holds_results(folder)) return write_runs_index(folder);
  throw Error(
      ErrorKind::config,
      {{folder.string(),
        "holds neither calibration.json, verdict.json nor a run nor folders of such, so no report can be made of it",
        "", "the folder of a run, of a calibration or of a confrontation, or a folder that holds several",
        "`asperity compare` writes the pages of comparisons"}});
}

}  // namespace

int report_command(const ReportOptions& options) {
  if (options.confusion) {
    std::cout << draw_confusion(*options.confusion, options.out).string() << std::endl;
    return 0;
  }
  const std::filesystem::path& folder = options.folder;
  if (!std::filesystem::is_directory(folder))
    throw Error(ErrorKind::config,
                {{folder.string(), "is no folder", "",
                  "a folder that `asperity run`, `asperity calibrate` or `asperity confront` has written", ""}});
  std::cout << draw_report(folder).string() << std::endl;
  return 0;
}

}  // namespace asperity::app
