#include "app/cli.hpp"

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>

#include "app/cli_compare.hpp"
#include "app/cli_schema.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "core/base/build_info.hpp"
#include "core/config/suggest.hpp"

namespace asperity::app {
namespace {

using Action = std::function<int()>;

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "Overrides a key: /json/pointer=value; may be repeated")
      ->type_name("POINTER=VALUE")
      ->expected(1)
      ->take_all();
}

void add_run(CLI::App& cli, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = cli.add_subcommand("run", "Runs one test into a run folder");
  command->add_option("config", options->config, "Run configuration (JSON)")->required();
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out, "Run folder; default outputs/<config name>/");
  command->add_option("--threads", options->threads, "Threads; default 1 for small meshes, all cores for large ones")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--no-render{false}", options->render, "Writes VTU files and tables but draws no picture");
  command->add_flag("--force", options->force, "Runs again, replacing the run that lies in the folder");
  command->add_flag("--quiet", options->quiet, "No progress on stderr");
  command->footer(
      "Examples:\n  asperity run configs/quickstart.json\n"
      "  asperity run configs/paper/uniaxial.json --set /particles/seed=7 --out outputs/seed7");
  command->callback([options, &action] { action = [options] { return run_command(*options); }; });
}

void add_resume(CLI::App& cli, Action& action) {
  auto options = std::make_shared<ResumeOptions>();
  CLI::App* command = cli.add_subcommand("resume", "Goes on with an interrupted run, to the same result");
  command->add_option("run_dir", options->run_dir, "Run folder")->required();
  command->add_option("--threads", options->threads, "Threads")->check(CLI::Range(1, 1024));
  command->add_flag("--no-render{false}", options->render, "Writes VTU files and tables but draws no picture");
  command->add_flag("--quiet", options->quiet, "No progress on stderr");
  command->footer("Example:\n  asperity resume outputs/quickstart");
  command->callback([options, &action] { action = [options] { return resume_command(*options); }; });
}

void add_validate(CLI::App& cli, Action& action) {
  auto configs = std::make_shared<std::vector<std::filesystem::path>>();
  auto overrides = std::make_shared<std::vector<std::string>>();
  CLI::App* command =
      cli.add_subcommand("validate", "Makes every check of `run`, the mesh's included, and writes nothing");
  command
      ->add_option("config", *configs,
                   "Configurations (JSON) of runs or, by their \"$schema\", of campaigns, calibrations, "
                   "confrontations, measured data")
      ->required();
  add_overrides(*command, *overrides);
  command->footer("Example:\n  asperity validate configs/paper/*.json");
  command->callback([=, &action] { action = [=] { return validate_command(*configs, *overrides); }; });
}

void add_derive(CLI::App& cli, Action& action) {
  auto options = std::make_shared<DeriveOptions>();
  CLI::App* command =
      cli.add_subcommand("derive", "Prints the closed forms of a configuration, each with its equation");
  command->add_option("config", options->config, "Run configuration (JSON)")->required();
  add_overrides(*command, options->overrides);
  command->add_flag("--json", options->json, "Prints JSON");
  command->footer("Example:\n  asperity derive configs/paper/brazilian.json");
  command->callback([=, &action] { action = [=] { return derive_command(*options); }; });
}

void add_law(CLI::App& cli, Action& action) {
  auto options = std::make_shared<LawOptions>();
  CLI::App* command = cli.add_subcommand(
      "law", "Draws the contact law of a configuration: tension, shear under pressure, strength, with unloading");
  command->add_option("config", options->config, "Run configuration (JSON)")->required();
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out, "Folder for PNG, SVG and CSV; default outputs/<config name>_law/");
  command->footer(
      "Examples:\n  asperity law configs/paper/brazilian.json\n"
      "  asperity law configs/paper/uniaxial.json --set '/mechanisms=[{\"type\":\"curved_envelope\"}]' --out "
      "outputs/curved");
  command->callback([=, &action] { action = [=] { return law_command(*options); }; });
}

void add_render(CLI::App& cli, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = cli.add_subcommand("render", "Draws a finished run again, from its VTU files alone");
  command->add_option("run_dir", options->run_dir, "Run folder")->required();
  command->add_option("--field", options->fields,
                      "cracks, contacts, damage, stress, shear_stress, fragments or displacement; may be repeated");
  command->add_option("--frames", options->frames, "all, last or a frame's number")->capture_default_str();
  command->footer("Example:\n  asperity render outputs/quickstart --field displacement --frames last");
  command->callback([=, &action] { action = [=] { return render_command(*options); }; });
}

void add_report(CLI::App& cli, Action& action) {
  auto options = std::make_shared<ReportOptions>();
  CLI::App* command = cli.add_subcommand("report",
                                         "Writes the page of a run's, a calibration's or a confrontation's folder "
                                         "anew, with its plots, or an index of many "
                                         "runs");
  auto* folder = command->add_option("dir", options->folder,
                                     "Folder of a run, a calibration or a confrontation, or of several runs");
  auto* confusion = command->add_option("--confusion", options->confusion,
                                        "Instead: the picture of a confusion matrix (JSON: rows, columns, counts)");
  confusion->excludes(folder);
  command->add_option("--out", options->out, "Its picture, .png or .svg; default: the JSON file's name with .png")
      ->needs(confusion);
  command->footer(
      "Examples:\n  asperity report outputs/quickstart\n  asperity report outputs\n"
      "  asperity report --confusion outputs/hidden/confusion.json --out outputs/hidden/confusion.png");
  command->callback([=, &action] {
    if (options->folder.empty() && !options->confusion) throw CLI::RequiredError("dir");
    action = [=] { return report_command(*options); };
  });
}

void add_audit(CLI::App& cli, Action& action) {
  auto options = std::make_shared<AuditOptions>();
  CLI::App* command = cli.add_subcommand(
      "audit", "Makes the table of the paper's law and its departures again, beside the figures known before");
  command->add_option("--seeds", options->seeds, "Meshes a row")->capture_default_str()->check(CLI::Range(1, 100));
  command->add_option("--jobs", options->jobs, "Runs at once; default one a core")->check(CLI::Range(1, 1024));
  command->add_option("--rows", options->rows, "Rows of the table, e.g. 1,2; default all six")
      ->delimiter(',')
      ->check(CLI::Range(1, 6));
  command->add_option("--configs", options->configs, "Folder of the four tests' configurations")->capture_default_str();
  command->add_option("--out", options->out, "Folder for table.csv and table.md")->capture_default_str();
  command->footer("Example:\n  asperity audit --seeds 3\n  asperity audit --rows 1,2 --out outputs/audit_literal");
  command->callback([=, &action] { action = [=] { return audit_command(*options); }; });
}

void add_bench(CLI::App& cli, Action& action) {
  auto options = std::make_shared<BenchOptions>();
  CLI::App* command = cli.add_subcommand(
      "bench", "Times a step of the scalar reference and of the vector kernels in turns, one thread and all");
  command->add_option("--json", options->json, "Writes the figures to this file as well");
  command->add_option("--triangles", options->triangles, "One mesh of about so many; default 4k, 16k, 64k, 256k and 1M")
      ->check(CLI::Range(500, 4000000));
  command->footer("Examples:\n  asperity bench --triangles 4050\n  asperity bench --json bench.json");
  command->callback([=, &action] { action = [=] { return bench_command(*options); }; });
}

void add_acceleration(CLI::App& cli, Action& action) {
  auto options = std::make_shared<AccelerationOptions>();
  CLI::App* command = cli.add_subcommand(
      "acceleration", "Measures rate control, mass scaling and elastic start against slow, unscaled loading");
  command->add_option("config", options->configs, "Run configurations (JSON); default configs/acceleration/*.json");
  command->add_option("--seeds", options->seeds, "Meshes a test")->capture_default_str()->check(CLI::Range(1, 100));
  command
      ->add_option("--reference-rate", options->reference_rate_factor,
                   "Closing rate of the reference over the configuration's")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 1.0));
  command->add_option("--json", options->json, "Writes every run's figures to this file");
  command->footer(
      "Exits 6 where a mean peak lies more than 2 % off the reference's.\nExamples:\n  asperity acceleration\n"
      "  asperity acceleration configs/acceleration/coarse_uniaxial.json --seeds 5 --json outputs/acceleration.json");
  command->callback([=, &action] { action = [=] { return acceleration_command(*options); }; });
}

/// The options of every command that computes a campaign.
void add_campaign_options(CLI::App& command, CampaignSessionOptions& options) {
  command.add_option("--jobs", options.jobs, "Runs at once on this machine; default one a core")
      ->check(CLI::Range(1, 1024));
  command.add_option("--executor", options.executor, "local, or slurm: array jobs by sbatch")
      ->capture_default_str()
      ->check(CLI::IsMember({"local", "slurm"}));
  command
      .add_option("--store", options.store, "Folder of the run folders; campaigns that share it share finished runs")
      ->capture_default_str();
  command.add_flag("--quiet", options.quiet, "No progress on stderr");
}

void add_campaign(CLI::App& cli, Action& action) {
  auto options = std::make_shared<CampaignCommandOptions>();
  CLI::App* command = cli.add_subcommand(
      "campaign", "Computes many runs, none twice, and writes a table; started again, it goes on where it was ended");
  command->add_option("config", options->config, "Campaign (JSON)")->required();
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out, "Folder for table.csv and campaign.json; default outputs/<name>/");
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
  command->add_option("config", options->config, "Calibration (JSON)")->required();
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out,
                      "Folder for calibration.json, report.html and configs; default outputs/<name>/");
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
  command->add_option("config", options->config, "Confrontation (JSON)")->required();
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out,
                      "Folder for verdict.json, report.html and configs; default outputs/<name>/");
  command->add_option("--write-bank", options->write_bank,
                      "File for the features of all runs, to be shipped as a bank");
  command
      ->add_option("--check-bank", options->check_share,
                   "Share of the runs taken from the bank that is computed again; exit code 6 on a difference")
      ->check(CLI::Range(0.0, 1.0));
  command->add_flag("--next-tests", options->next_tests,
                    "Simulates further tests that would part several causes, also where linearise_at is reference");
  command->add_option("--check-seed", options->check_seed, "Which ones")->capture_default_str();
  command->add_flag("--no-report{false}", options->report, "Write the verdict only: no runs to be shown, no page");
  add_campaign_options(*command, options->session);
  command->footer(
      "Examples:\n  asperity confront configs/confrontation/zigong.json\n"
      "  asperity confront configs/confrontation/laboratory.json --set /measured=my_tests.json --out outputs/mine\n"
      "  asperity confront configs/confrontation/laboratory.json --check-bank 0.05");
  command->callback([=, &action] { action = [=] { return confront_command(*options); }; });
}

void add_features(CLI::App& cli, Action& action) {
  auto options = std::make_shared<FeaturesOptions>();
  CLI::App* command = cli.add_subcommand(
      "features", "Prints what is read off curves: peak, moduli, toe, drop, residual, dilation, loops and more");
  command->add_option("source", options->source, "Measured data (JSON) or a run folder")->required();
  command->add_flag("--json", options->json, "Prints JSON");
  command->footer(
      "Examples:\n  asperity features configs/measured/zigong_sandstone.json\n"
      "  asperity features outputs/quickstart --json");
  command->callback([=, &action] { action = [=] { return features_command(*options); }; });
}

void add_mechanisms(CLI::App& cli, Action& action) {
  auto options = std::make_shared<MechanismsOptions>();
  CLI::App* command = cli.add_subcommand(
      "mechanisms", "Lists the mechanisms a run may have, or tells of one: equation, parameters, source");
  command->add_option("id", options->ids, "Mechanisms to tell of; default a list of all");
  command->add_flag("--json", options->json, "Prints JSON");
  command->footer("Examples:\n  asperity mechanisms\n  asperity mechanisms platen_friction frame_compliance");
  command->callback([=, &action] { action = [=] { return mechanisms_command(*options); }; });
}

void add_gallery(CLI::App& cli, Action& action) {
  auto options = std::make_shared<GalleryOptions>();
  CLI::App* command = cli.add_subcommand(
      "gallery", "Shows what every mechanism does to every experiment: curves, patterns and features on common meshes");
  command->add_option("config", options->bases,
                      "Bases, one run configuration an experiment; default configs/gallery/*.json");
  command->add_option("--mechanism", options->mechanisms, "Only this one; may be repeated")->expected(1)->take_all();
  command->add_option("--seeds", options->seeds, "Meshes of each test")
      ->capture_default_str()
      ->check(CLI::Range(2, 100));
  command->add_option("--out", options->out, "Folder for gallery.html, .md and .json; default outputs/gallery/");
  add_campaign_options(*command, options->session);
  command->footer(
      "Examples:\n  asperity gallery\n"
      "  asperity gallery configs/gallery/uniaxial.json --mechanism platen_friction --mechanism seating --seeds 2");
  command->callback([=, &action] { action = [=] { return gallery_command(*options); }; });
}

void add_info(CLI::App& cli, Action& action) {
  CLI::App* command = cli.add_subcommand("info", "Prints version, revision, libraries and machine");
  command->footer("Example:\n  asperity info");
  command->callback([&action] { action = [] { return info_command(); }; });
}

/// CLI11 says of a mistyped command only that one is required: this names the word, and the command that may be meant.
void explain_unknown_command(const CLI::App& cli) {
  const std::vector<std::string> words = cli.remaining();
  if (!cli.get_subcommands().empty() || words.empty() || words.front().starts_with('-')) return;
  std::vector<std::string> names;
  for (const CLI::App* command : cli.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  const std::string meant = closest(words.front(), names);
  std::cerr << "error: " << words.front() << ": is no command"
            << (meant.empty() ? "" : ". Hint: did you mean " + meant + "?") << '\n';
}

}  // namespace

int run_command_line(int argc, char** argv) {
  CLI::App cli{"Asperity: a desktop-free workbench for rock failure", "asperity"};
  cli.set_version_flag("--version", build_info().version);
  cli.require_subcommand(1);
  cli.footer(
      "Start with:\n  asperity run configs/quickstart.json\n\nExit codes: 0 done, 1 unexpected, 2 usage, 3 config or "
      "data, "
      "4 numerical, 5 output, 6 outside tolerance, 130 interrupted with a checkpoint.");
  Action action;
  for (const auto add : {add_run, add_resume, add_validate, add_schema, add_derive, add_law, add_render, add_compare,
                         add_report, add_audit, add_campaign, add_calibrate, add_confront, add_features, add_mechanisms,
                         add_gallery, add_acceleration, add_bench, add_info}) {
    add(cli, action);
  }
  try {
    cli.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    explain_unknown_command(cli);
    return exit_code_of_command_line(cli.exit(error, std::cout, std::cerr));
  }
  try {
    return action();
  } catch (...) {
    return report_current_exception(std::cerr);
  }
}

}  // namespace asperity::app
