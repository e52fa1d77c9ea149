#include "app/cli_options.hpp"

#include <CLI/CLI.hpp>

namespace asperity::app {

void add_config(CLI::App& command, std::filesystem::path& config, const std::string& description) {
  command.add_option("config", config, description)->type_name(kConfig)->required();
}

void add_overrides(CLI::App& command, std::vector<std::string>& overrides) {
  command.add_option("--set", overrides, "Overrides a key: /json/pointer=value; may be repeated")
      ->type_name(kOverride)
      ->expected(1)
      ->take_all();
}

}  // namespace asperity::app
