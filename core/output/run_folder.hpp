#pragma once
#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/file_descriptor.hpp"
#include "core/output/run_identity.hpp"

namespace asperity {

/// What to do with a run that already lies in the folder: --force is `replace`.
enum class ExistingRun { keep, replace };

/// What begin() does with a folder; `open` is what open() does.
enum class FolderUse { create, reuse, restart, open };

struct FolderDecision {
  FolderUse use;
  std::string why;  ///< One clause for the log.
};

/// Plots that a run draws, each as PNG and, but for the strip, as SVG in plots/; what is counted also as CSV.
inline constexpr std::array<std::string_view, 12> kPlotNames{
    "stress_strain", "shear_stress", "dilation",          "teeth",         "energy", "cracks", "strip", "crack_rose",
    "magnitudes",    "acoustic",     "volumetric_strain", "fragment_sizes"};

/// outputs/NAME below the present folder. Throws Error(config) at /name where the name would leave outputs/.
std::filesystem::path default_run_folder(const std::string& config_name);

/// What begin() would do, by reading alone (core/output/README.md has the table of cases). Throws Error(output) where
/// the folder holds another configuration's run and `existing` is keep, or files that are no run of ours (always).
FolderDecision decide_folder_use(const std::filesystem::path& root, const RunIdentity& identity, ExistingRun existing);

/// Whether the folder holds a run that was cut off between its configuration and its manifest, the last file of a
/// start.
bool cut_off_at_start(const std::filesystem::path& root);

/// Whether a living process writes a run there.
bool is_written(const std::filesystem::path& root);

/// A run folder and, unless the run in it is re-used, the lock that keeps other processes from writing there. The lock
/// is held as long as the object lives.
class RunFolder {
 public:
  /// Makes the folder ready for a run: decides, locks, clears the files of the run before (and only those), creates the
  /// subfolders. A run to re-use is left untouched. Call it after the checks of configuration and mesh: it is the first
  /// to write. Throws Error(output) as decide_folder_use(), where another process writes there, or where the system
  /// refuses.
  static RunFolder begin(const std::filesystem::path& root, const RunIdentity& identity, ExistingRun existing);

  /// Opens and locks the folder of a run that lies there, to resume it or to draw it again. Throws Error(output) where
  /// there is none or another process writes there.
  static RunFolder open(const std::filesystem::path& root);

  /// Throws Error(output) where the folder was removed, moved or replaced since it was locked: what is written by its
  /// name would be lost, or damage another run.
  void require_in_place() const;

  bool reused() const { return decision_.use == FolderUse::reuse; }
  const FolderDecision& decision() const { return decision_; }

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path original_config() const { return root_ / "config.original.json"; }
  std::filesystem::path effective_config() const { return root_ / "config.effective.json"; }
  std::filesystem::path manifest() const { return root_ / "manifest.json"; }
  std::filesystem::path log() const { return root_ / "log.txt"; }
  std::filesystem::path summary() const { return root_ / "summary.json"; }
  std::filesystem::path report() const { return root_ / "report.html"; }
  std::filesystem::path curves() const { return root_ / "curves.csv"; }
  std::filesystem::path energy() const { return root_ / "energy.csv"; }
  std::filesystem::path crack_table() const { return root_ / "cracks.csv"; }
  std::filesystem::path events() const { return root_ / "events.csv"; }
  std::filesystem::path fragments() const { return root_ / "fragments.csv"; }
  std::filesystem::path measured_curve() const { return root_ / "measured.csv"; }
  std::filesystem::path field_series() const { return root_ / "fields.pvd"; }
  std::filesystem::path crack_series() const { return root_ / "cracks.pvd"; }
  std::filesystem::path contact_series() const { return root_ / "contacts.pvd"; }
  std::filesystem::path fields() const { return root_ / "fields"; }
  std::filesystem::path cracks() const { return root_ / "cracks"; }
  std::filesystem::path contacts() const { return root_ / "contacts"; }
  std::filesystem::path frames() const { return root_ / "frames"; }
  std::filesystem::path plots() const { return root_ / "plots"; }
  std::filesystem::path checkpoint() const { return root_ / "checkpoint"; }

 private:
  RunFolder(std::filesystem::path root, FolderDecision decision, std::optional<FileDescriptor> lock);
  std::filesystem::path root_;
  FolderDecision decision_;
  std::optional<FileDescriptor> lock_;
};

}  // namespace asperity
