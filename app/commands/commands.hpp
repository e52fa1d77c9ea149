#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/campaign_session.hpp"
#include "core/config/mechanism_declaration.hpp"

/// The subcommands of `asperity`: each takes plain options, prints results on stdout, and returns an exit code.
namespace asperity::app {

struct RunOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> out;
  int threads = 0;  ///< 0: one for small meshes, all cores for large ones.
  bool render = true;
  bool force = false;
  bool quiet = false;
};

int run_command(const RunOptions& options);

struct ResumeOptions {
  std::filesystem::path run_dir;
  int threads = 0;
  bool render = true;
  bool quiet = false;
};

int resume_command(const ResumeOptions& options);

int validate_command(const std::vector<std::filesystem::path>& configs, const std::vector<std::string>& overrides);

int schema_command(const std::string& kind);

struct DeriveOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  bool json = false;
};

int derive_command(const DeriveOptions& options);

struct LawOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> out;  ///< Unset: outputs/<config name>_law/.
};

int law_command(const LawOptions& options);

struct RenderOptions {
  std::filesystem::path run_dir;
  std::vector<std::string> fields;  ///< Empty: those of the run's configuration.
  std::string frames = "all";       ///< "all", "last" or a number.
};

int render_command(const RenderOptions& options);

struct CompareOptions {
  std::vector<std::filesystem::path> run_dirs;
  std::optional<std::filesystem::path> montage;  ///< One run through time, in place of run_dirs.
  std::size_t frames = 8;                        ///< Of a montage.
  std::string align;                             ///< "displacement", "strain", "peak"; empty: chosen by the experiment.
  std::optional<double> at;
  std::string field = "cracks";
  std::optional<std::filesystem::path> out, html;
};

/// Draws runs side by side, or one through time, writes tables and page, and prints table and paths.
int compare_command(const CompareOptions& options);

struct ReportOptions {
  std::filesystem::path folder;                    ///< Of a run, a calibration, a confrontation, or several runs.
  std::optional<std::filesystem::path> confusion;  ///< Instead: a confusion matrix (JSON) ...
  std::optional<std::filesystem::path> out;        ///< ... and its picture, .png or .svg.
};

/// Writes report.html of a run's, a calibration's or a confrontation's folder anew, with its plots, or the picture of a
/// confusion matrix, and prints its path.
int report_command(const ReportOptions& options);

struct AuditOptions {
  int seeds = 3;
  int jobs = 0;                                     ///< 0: one a core.
  std::vector<int> rows;                            ///< Rows of the table, from 1; empty: all.
  std::filesystem::path configs = "configs/paper";  ///< Folder of the four tests' configurations.
  std::filesystem::path out = "outputs/audit";
};

int audit_command(const AuditOptions& options);

struct BenchOptions {
  std::optional<std::filesystem::path> json;
  std::optional<int> triangles;  ///< Unset: 4k, 16k, 64k, 256k and 1M.
};

int bench_command(const BenchOptions& options);

struct AccelerationOptions {
  std::vector<std::filesystem::path> configs{"configs/acceleration/coarse_uniaxial.json",
                                             "configs/acceleration/coarse_triaxial.json",
                                             "configs/acceleration/coarse_brazilian.json"};
  int seeds = 3;
  double reference_rate_factor = 0.25;  ///< Closing rate of the reference over the configuration's.
  std::optional<std::filesystem::path> json;
};

int acceleration_command(const AccelerationOptions& options);

struct CampaignCommandOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> out;  ///< Unset: outputs/<campaign name>/.
  CampaignSessionOptions session;
};

int campaign_command(const CampaignCommandOptions& options);

struct CalibrateCommandOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> out;  ///< Unset: outputs/<calibration name>/.
  bool force = false;                        ///< Replaces another study's results in that folder.
  CampaignSessionOptions session;
};

int calibrate_command(const CalibrateCommandOptions& options);

struct ConfrontCommandOptions {
  std::filesystem::path config;
  std::vector<std::string> overrides;
  std::optional<std::filesystem::path> out;  ///< Unset: outputs/<confrontation name>/.
  bool force = false;                        ///< Replaces another study's results in that folder.
  std::optional<std::filesystem::path> write_bank;
  double check_share = 0;  ///< Of the runs taken from the bank, computed again and compared.
  std::uint64_t check_seed = 1;
  bool next_tests = false;  ///< Also about the reference, where they are the only runs at a cause's own parameters.
  bool report = true;       ///< False: neither the runs that are shown nor the page.
  CampaignSessionOptions session;
};

int confront_command(const ConfrontCommandOptions& options);

struct FeaturesOptions {
  std::filesystem::path source;  ///< A measured file or a run folder.
  bool json = false;
};

int features_command(const FeaturesOptions& options);

struct MechanismsOptions {
  std::vector<std::string> ids;  ///< None: the whole library.
  bool json = false;
};

int mechanisms_command(const MechanismsOptions& options);

/// The mechanism of this id; throws Error(usage) with what may be meant where there is none.
const MechanismDeclaration& mechanism_or_fault(const std::string& id);

struct GalleryOptions {
  std::vector<std::filesystem::path> bases{"configs/gallery/uniaxial.json", "configs/gallery/triaxial.json",
                                           "configs/gallery/brazilian.json", "configs/gallery/direct_shear.json"};
  std::vector<std::string> mechanisms;  ///< None: the whole library.
  int seeds = 3;
  std::optional<std::filesystem::path> out;  ///< Unset: outputs/gallery/.
  CampaignSessionOptions session;
};

int gallery_command(const GalleryOptions& options);

int info_command();

}  // namespace asperity::app
