#include "app/cli_schema.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <string>

#include "app/cli_options.hpp"
#include "app/commands/commands.hpp"
#include "core/config/schema_reference.hpp"

namespace asperity::app {

namespace {

struct SchemaOptions {
  std::string kind = "run";
  bool markdown = false;  ///< The reference of every key in place of the JSON Schema.
};

int print_schema(const SchemaOptions& options) {
  if (!options.markdown) return schema_command(options.kind);
  std::cout << schema_reference(options.kind);
  return 0;
}

}  // namespace

void add_schema(CLI::App& cli, std::function<int()>& action) {
  auto options = std::make_shared<SchemaOptions>();
  CLI::App* command =
      cli.add_subcommand("schema", "Prints the JSON Schema of a kind of configuration, or the reference of its keys");
  command->add_option("kind", options->kind, "run, campaign, calibration, confrontation or measured")
      ->type_name(kSchemaKind)
      ->capture_default_str();
  command->add_flag("--markdown", options->markdown, "The reference of every key, as docs/reference has it");
  command->footer(
      "Examples:\n  asperity schema run > run.schema.json\n"
      "  asperity schema measured --markdown > docs/reference/measured.md");
  command->callback([=, &action] { action = [=] { return print_schema(*options); }; });
}

}  // namespace asperity::app
