#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "core/measurement/frame.hpp"

namespace asperity::render {

/// Writes a run's time series for ParaView: fields/fields_000000.vtu with fields.pvd, and cracks and contacts in the
/// same way. After every frame the .pvd files are whole and list only whole files. README.md lists the arrays.
class SeriesWriter {
 public:
  /// Starts in `run_dir`, keeping the first `frames_to_keep` frames of a series already there (0: a new series); later
  /// frames are removed. Errors: Error(output) if the folder cannot be written, or holds fewer frames than to be kept.
  explicit SeriesWriter(std::filesystem::path run_dir, std::size_t frames_to_keep = 0);

  /// Writes the frame as number size(), whatever its own index. Errors: Error(output) with path and reason; the series
  /// is then as before.
  void write(const Frame& frame);

  std::size_t size() const { return times_.size(); }

 private:
  std::filesystem::path run_dir_;
  std::vector<double> times_;
};

/// Physical times (s) of the frames listed in a run's fields.pvd. Errors: Error(output) if it is missing or not a .pvd.
std::vector<double> series_times(const std::filesystem::path& run_dir);

/// Errors: Error(output) if the run has no series of contacts; older versions wrote none.
void require_contacts(const std::filesystem::path& run_dir);

/// One frame, from its VTU files alone; without contacts where the run has no contacts.pvd (older versions wrote none).
/// Errors: Error(output) if a file is missing, damaged or lacks an array.
Frame read_frame(const std::filesystem::path& run_dir, int index);

}  // namespace asperity::render
