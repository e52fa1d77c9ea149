#include "app/cli_studies.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/commands/commands.hpp"

namespace asperity::app {
namespace {

/// The options of every command that computes a campaign.
void add_campaign_options(CLI::App& command, CampaignSessionOptions& options) {
  command.add_option("--jobs", options.jobs, "Runs at once on this machine; default one a core")
      ->check(CLI::Range(1, 1024));
  command.add_option("--executor", options.executor, "local, or slurm: array jobs by sbatch")
      ->capture_default_str()
      ->check(CLI::IsMember({"local", "slurm"}));
  command
      .add_option("--store", options.store, "Folder of the run folders; campaigns that share it share finished runs")
      ->type_name(kFolder)
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "No progress on stderr");
}

/// A share of 1; CLI11's own range takes "nan".
CLI::Validator share() {
  return {[](std::string& text) {
            double value = -1.0;
            const bool good = CLI::detail::lexical_cast(text, value) && value >= 0.0 && value <= 1.0;
            return good ? std::string() : "Value " + text + " not in range 0 to 1";
          },
          "FLOAT in [0 - 1]"};
}

void add_force(CLI::App& command, bool& force) {
  command.add_flag("--force", force, "Replaces results of another configuration or of other data in that folder");
}

}  // namespace

void add_audit(CLI::App& cli, Action& action) {
  auto options = std::make_shared<AuditOptions>();
  CLI::App* command = cli.add_subcommand(
      "audit", "Makes the table of the paper's law and its departures again, beside the figures known before");
  command->add_option("--seeds", options->seeds, "Meshes a row")->capture_default_str()->check(CLI::Range(1, 100));
  command->add_option("--jobs", options->jobs, "Runs at once; default one a core")->check(CLI::Range(1, 1024));
  command->add_option("--rows", options->rows, "Rows of the table, e.g. 1,2; default all six")
      ->delimiter(',')
      ->check(CLI::Range(1, 6));
  command->add_option("--configs", options->configs, "Folder of the four tests' configurations")
      ->type_name(kFolder)
      ->capture_default_str();
  command->add_option("--out", options->out, "Folder for table.csv and table.md")
      ->type_name(kFolder)
      ->capture_default_str();
  command->footer("Examples:\n  asperity audit --seeds 3\n  asperity audit --rows 1,2 --out outputs/audit_literal");
  command->callback([=, &action] { action = [=] { return audit_command(*options); }; });
}

void add_bench(CLI::App& cli, Action& action) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = cli.add_subcommand(
      "bench", "Times a step of the scalar reference and of the vector kernels in turns, one thread and all");
  command->add_option("--json", options->json, "Writes the figures to this file as well")->type_name(kFile);
  command->add_option("--triangles", options->triangles, "One mesh of about so many; default 4k, 16k, 64k, 256k and 1M")
      ->check(CLI::Range(500, 4000000));
  command->footer("Examples:\n  asperity bench --triangles 4050\n  asperity bench --json bench.json");
  command->callback([=, &action] { action = [=] { return bench_command(*options); }; });
}

void add_acceleration(CLI::App& cli, Action& action) {
  auto options = std::make_shared<AccelerationOptions>();
  CLI::App* command = cli.add_subcommand(
      "acceleration", "Measures rate control, mass scaling and elastic start against slow, unscaled loading");
  command->add_option("config", options->configs, "Run configurations (JSON); default configs/acceleration/*.json")
      ->type_name(kConfig);
  command->add_option("--seeds", options->seeds, "Meshes a test")->capture_default_str()->check(CLI::Range(1, 100));
  command
      ->add_option("--reference-rate", options->reference_rate_factor,
                   "Closing rate of the reference over the configuration's")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1.0));
  command->add_option("--json", options->json, "Writes every run's figures to this file")->type_name(kFile);
  command->footer(
      "Exits 6 where a mean peak lies more than 2 % off the reference's.\nExamples:\n  asperity acceleration\n"
      "  asperity acceleration configs/acceleration/coarse_uniaxial.json --seeds 5 --json outputs/acceleration.json");
  command->callback([=, &action] { action = [=] { return acceleration_command(*options); }; });
}

void add_campaign(CLI::App& cli, Action& action) {
  auto options = std::make_shared<CampaignCommandOptions>();
  CLI::App* command = cli.add_subcommand(
      "campaign", "Computes many runs, none twice, and writes a table; started again, it goes on where it was ended");
  add_config(*command, options->config, "Campaign (JSON)");
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out, "Folder for table.csv and campaign.json; default outputs/<name>/")
      ->type_name(kFolder);
  add_campaign_options(*command, options->session);
  command->footer(
      "Exits with the code of the first failed run, if any; the table names them all.\nExamples:\n"
      "  asperity campaign configs/campaign/strength_against_edge.json\n"
      "  asperity campaign configs/campaign/strength_against_edge.json --set /seeds/count=1 --set "
      "/contacts/cohesion_mpa=4 --out outputs/weaker\n"
      "  asperity campaign configs/campaign/strength_against_edge.json --executor slurm --set /slurm/partition=short");
  command->callback([=, &action] { action = [=] { return campaign_command(*options); }; });
}

void add_calibrate(CLI::App& cli, Action& action) {
  auto options = std::make_shared<CalibrateCommandOptions>();
  CLI::App* command = cli.add_subcommand(
      "calibrate",
      "Finds microparameters for laboratory targets and verifies them on fresh meshes; goes on where it was ended");
  add_config(*command, options->config, "Calibration (JSON)");
  add_overrides(*command, options->overrides);
  command
      ->add_option("--out", options->out,
                   "Folder for calibration.json, report.html and configs; default outputs/<name>/")
      ->type_name(kFolder);
  add_force(*command, options->force);
  add_campaign_options(*command, options->session);
  command->footer(
      "Examples:\n  asperity calibrate configs/calibration/plaster.json\n"
      "  asperity calibrate configs/calibration/paper_table4.json --out outputs/table4\n"
      "  asperity calibrate configs/calibration/plaster.json --executor slurm --set /slurm/partition=short");
  command->callback([=, &action] { action = [=] { return calibrate_command(*options); }; });
}

void add_confront(CLI::App& cli, Action& action) {
  auto options = std::make_shared<ConfrontCommandOptions>();
  CLI::App* command = cli.add_subcommand(
      "confront",
      "Shows what the calibrated model gets wrong against measured tests, names the cause, extends the model and "
      "measures the gain; goes on where it was ended");
  add_config(*command, options->config, "Confrontation (JSON)");
  add_overrides(*command, options->overrides);
  command
      ->add_option("--out", options->out, "Folder for verdict.json, report.html and configs; default outputs/<name>/")
      ->type_name(kFolder);
  add_force(*command, options->force);
  command->add_option("--write-bank", options->write_bank, "File for the features of all runs, to be shipped as a bank")
      ->type_name(kFile);
  command
      ->add_option("--check-bank", options->check_share,
                   "Share of the runs taken from the bank that is computed again; exit code 6 on a difference")
      ->check(share());
  command->add_flag("--next-tests", options->next_tests,
                    "Simulates further tests that would part several causes, also where linearise_at is reference");
  command->add_option("--check-seed", options->check_seed, "Which ones")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  command->add_flag("--no-report{false}", options->report, "Write the verdict only: no runs to be shown, no page");
  add_campaign_options(*command, options->session);
  command->footer(
      "Examples:\n  asperity confront configs/confrontation/zigong.json\n"
      "  asperity confront configs/confrontation/laboratory.json --set /measured=$PWD/my_tests.json --out "
      "outputs/mine\n"
      "  asperity confront configs/confrontation/laboratory.json --check-bank 0.05");
  command->callback([=, &action] { action = [=] { return confront_command(*options); }; });
}

void add_gallery(CLI::App& cli, Action& action) {
  auto options = std::make_shared<GalleryOptions>();
  CLI::App* command = cli.add_subcommand(
      "gallery", "Shows what every mechanism does to every experiment: curves, patterns and features on common meshes");
  command
      ->add_option("config", options->bases,
                   "Bases, one run configuration an experiment; default configs/gallery/*.json")
      ->type_name(kConfig);
  command->add_option("--mechanism", options->mechanisms, "Only this one; may be repeated")
      ->type_name(kMechanism)
      ->expected(1)
      ->take_all();
  command->add_option("--seeds", options->seeds, "Meshes of each test")
      ->capture_default_str()
      ->check(CLI::Range(2, 100));
  command->add_option("--out", options->out, "Folder for gallery.html, .md and .json; default outputs/gallery/")
      ->type_name(kFolder);
  add_campaign_options(*command, options->session);
  command->footer(
      "Examples:\n  asperity gallery\n"
      "  asperity gallery configs/gallery/uniaxial.json --mechanism platen_friction --mechanism seating --seeds 2");
  command->callback([=, &action] { action = [=] { return gallery_command(*options); }; });
}

}  // namespace asperity::app
