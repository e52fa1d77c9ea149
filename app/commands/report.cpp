#include <iostream>

#include "app/commands/commands.hpp"
#include "app/report/calibration_report.hpp"
#include "core/base/error.hpp"

namespace asperity::app {

int report_command(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    throw Error(ErrorKind::config,
                {{folder.string(), "is no folder", "", "a folder that `asperity calibrate` has written", ""}});
  if (!is_calibration_folder(folder))
    throw Error(
        ErrorKind::config,
        {{folder.string(), "holds no calibration.json, so no report can be made of it", "",
          "the folder of a calibration; reports of runs, comparisons and confrontations do not exist yet", ""}});
  std::cout << write_calibration_report(folder).string() << std::endl;
  return 0;
}

}  // namespace asperity::app
