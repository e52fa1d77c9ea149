#include "app/cli_compare.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli_options.hpp"
#include "app/commands/commands.hpp"

namespace asperity::app {

void add_compare(CLI::App& cli, std::function<int()>& action) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command = cli.add_subcommand(
      "compare", "Draws failure patterns of 2 to 12 runs side by side at one scale, with a table and a page");
  CLI::Option* runs =
      command->add_option("run_dir", options->run_dirs, "Run folders; the first is the reference")->type_name(kFolder);
  CLI::Option* montage =
      command->add_option("--montage", options->montage, "One run through time instead")->type_name(kFolder);
  montage->excludes(runs);
  command->add_option("--frames", options->frames, "Frames of a montage")
      ->capture_default_str()
      ->check(CLI::Range(1, 12))
      ->needs(montage);
  CLI::Option* align = command->add_option(
      "--align", options->align,
      "displacement, strain or peak: what the frames have in common; default strain, of joints displacement");
  align->check(CLI::IsMember({"displacement", "strain", "peak"}))->excludes(montage);
  command
      ->add_option("--at", options->at,
                   "mm, strain as in curves.csv, or part of the peak (0.5: fallen to half of it, -0.5: risen to it); "
                   "default the last that all reach, or 0.5")
      ->excludes(montage);
  command->add_option("--field", options->field, "cracks or damage")
      ->capture_default_str()
      ->check(CLI::IsMember({"cracks", "damage"}));
  command->add_option("--out", options->out, "Picture (.png); tables go beside it; default outputs/compare_<names>.png")
      ->type_name(kFile);
  command->add_option("--html", options->html, "Page; default beside the picture")->type_name(kFile)->excludes(montage);
  command->footer(
      "Examples:\n  asperity compare outputs/seed1 outputs/seed2 --align peak --at 0.5 --out outputs/seeds.png\n"
      "  asperity compare --montage outputs/quickstart --frames 6 --field damage");
  command->callback([=, &action] { action = [=] { return compare_command(*options); }; });
}

}  // namespace asperity::app
