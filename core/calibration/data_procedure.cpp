#include "core/calibration/data_procedure.hpp"

#include "core/base/atomic_file.hpp"
#include "core/calibration/paper_audit.hpp"

namespace asperity {

Analysis calibrate_data(const std::filesystem::path& config, const std::filesystem::path& folder) {
  const DataCalibration calibration = read_data_calibration(config);
  Analysis analysis = analyse(calibration.design, calibration.responses, calibration.targets, calibration.options);
  write_file_atomically(folder / "calibration.json", calibration_json(calibration, analysis).dump(2) + "\n");
  if (calibration.published) {
    write_file_atomically(folder / "audit.md", audit_page(calibration, audit_paper(calibration, analysis)));
  }
  return analysis;
}

}  // namespace asperity
