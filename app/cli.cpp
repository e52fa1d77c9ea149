#include "app/cli.hpp"

#include <CLI/CLI.hpp>
#include <functional>
#include <iostream>
#include <memory>

#include "app/cli_compare.hpp"
#include "app/cli_documents.hpp"
#include "app/cli_options.hpp"
#include "app/cli_schema.hpp"
#include "app/cli_studies.hpp"
#include "app/commands/commands.hpp"
#include "app/exit_code.hpp"
#include "core/base/build_info.hpp"
#include "core/config/suggest.hpp"

namespace asperity::app {
namespace {

void add_run(CLI::App& cli, Action& action) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = cli.add_subcommand("run", "Runs one test into a run folder");
  add_config(*command, options->config, "Run configuration (JSON)");
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out, "Run folder; default outputs/<config name>/")->type_name(kFolder);
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
  command->add_option("run_dir", options->run_dir, "Run folder")->type_name(kFolder)->required();
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
      ->type_name(kConfig)
      ->required();
  add_overrides(*command, *overrides);
  command->footer("Example:\n  asperity validate configs/paper/*.json");
  command->callback([=, &action] { action = [=] { return validate_command(*configs, *overrides); }; });
}

void add_derive(CLI::App& cli, Action& action) {
  auto options = std::make_shared<DeriveOptions>();
  CLI::App* command =
      cli.add_subcommand("derive", "Prints the closed forms of a configuration, each with its equation");
  add_config(*command, options->config, "Run configuration (JSON)");
  add_overrides(*command, options->overrides);
  command->add_flag("--json", options->json, "Prints JSON");
  command->footer("Example:\n  asperity derive configs/paper/brazilian.json");
  command->callback([=, &action] { action = [=] { return derive_command(*options); }; });
}

void add_law(CLI::App& cli, Action& action) {
  auto options = std::make_shared<LawOptions>();
  CLI::App* command = cli.add_subcommand(
      "law", "Draws the contact law of a configuration: tension, shear under pressure, strength, with unloading");
  add_config(*command, options->config, "Run configuration (JSON)");
  add_overrides(*command, options->overrides);
  command->add_option("--out", options->out, "Folder for PNG, SVG and CSV; default outputs/<config name>_law/")
      ->type_name(kFolder);
  command->footer(
      "Examples:\n  asperity law configs/paper/brazilian.json\n"
      "  asperity law configs/paper/uniaxial.json --set '/mechanisms=[{\"type\":\"curved_envelope\"}]' --out "
      "outputs/curved");
  command->callback([=, &action] { action = [=] { return law_command(*options); }; });
}

void add_render(CLI::App& cli, Action& action) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* command = cli.add_subcommand("render", "Draws a finished run again, from its VTU files alone");
  command->add_option("run_dir", options->run_dir, "Run folder")->type_name(kFolder)->required();
  command
      ->add_option("--field", options->fields,
                   "cracks, contacts, damage, stress, compressive_stress, shear_stress, fragments or displacement; may "
                   "be repeated")
      ->type_name(kField);
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
  auto* folder =
      command
          ->add_option("dir", options->folder, "Folder of a run, a calibration or a confrontation, or of several runs")
          ->type_name(kFolder);
  auto* confusion = command
                        ->add_option("--confusion", options->confusion,
                                     "Instead: the picture of a confusion matrix (JSON: rows, columns, counts)")
                        ->type_name(kConfig);
  confusion->excludes(folder);
  command->add_option("--out", options->out, "Its picture, .png or .svg; default: the JSON file's name with .png")
      ->type_name(kFile)
      ->needs(confusion);
  command->footer(
      "Examples:\n  asperity report outputs/quickstart\n  asperity report outputs\n"
      "  asperity report --confusion outputs/hidden/confusion.json --out outputs/hidden/confusion.png");
  command->callback([=, &action] {
    if (options->folder.empty() && !options->confusion) throw CLI::RequiredError("dir");
    action = [=] { return report_command(*options); };
  });
}

void add_features(CLI::App& cli, Action& action) {
  auto options = std::make_shared<FeaturesOptions>();
  CLI::App* command = cli.add_subcommand(
      "features", "Prints what is read off curves: peak, moduli, toe, drop, residual, dilation, loops and more");
  command->add_option("source", options->source, "Measured data (JSON) or a run folder")
      ->type_name(kConfig)
      ->required();
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
  command->add_option("id", options->ids, "Mechanisms to tell of; default a list of all")->type_name(kMechanism);
  command->add_flag("--json", options->json, "Prints JSON");
  command->footer("Examples:\n  asperity mechanisms\n  asperity mechanisms platen_friction frame_compliance");
  command->callback([=, &action] { action = [=] { return mechanisms_command(*options); }; });
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
  cli.footer("Start with:\n  asperity run configs/quickstart.json\n\n" + exit_codes_in_a_line());
  Action action;
  for (const auto add :
       {add_run,        add_resume,  add_validate,     add_schema,   add_derive,    add_law,        add_render,
        add_compare,    add_report,  add_audit,        add_campaign, add_calibrate, add_confront,   add_features,
        add_mechanisms, add_gallery, add_acceleration, add_bench,    add_info,      add_completion, add_manual}) {
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
