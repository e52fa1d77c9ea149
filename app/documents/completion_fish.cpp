#include <fmt/format.h>

#include <CLI/StringTools.hpp>

#include "app/documents/completion.hpp"

namespace asperity::app {
namespace {

std::string quoted(const std::string& text) {
  const std::string backslashes = CLI::detail::find_and_replace(text, "\\", "\\\\");
  return "'" + CLI::detail::find_and_replace(backslashes, "'", "\\'") + "'";
}

/// The options of `complete` that say what a value may be.
std::string value_part(const ArgumentEntry& argument) {
  switch (argument.kind) {
    case ValueKind::config:
      return " -k -a '(__fish_complete_suffix .json)'";
    case ValueKind::folder:
      return " -a '(__fish_complete_directories)'";
    case ValueKind::file:
      return " -r -F";
    case ValueKind::words:
    case ValueKind::pointer:
      return " -a " + quoted(in_a_line(argument.words));
    case ValueKind::none:
    case ValueKind::text:
      break;
  }
  return "";
}

std::string option_line(const std::string& condition, const ArgumentEntry& option) {
  std::string line = "complete -c asperity -n " + quoted(condition);
  for (const std::string& name : option.names) {
    line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  if (option.kind != ValueKind::none && option.kind != ValueKind::file) line += " -x";
  return line + value_part(option) + " -d " + quoted(option.description) + "\n";
}

std::string command_lines(const CommandEntry& command) {
  const std::string condition = "__fish_seen_subcommand_from " + command.name;
  std::string lines = fmt::format("complete -c asperity -n __fish_use_subcommand -a {} -d {}\n", command.name,
                                  quoted(command.description));
  for (const ArgumentEntry& option : command.options) lines += option_line(condition, option);
  for (const ArgumentEntry& positional : command.positionals) {
    lines += fmt::format("complete -c asperity -n {}{}\n", quoted(condition), value_part(positional));
  }
  return lines;
}

}  // namespace

std::string fish_completion(const CommandTree& tree) {
  std::string text =
      "# Completion of asperity for fish, written by: asperity completion fish\n"
      "# Load it by: asperity completion fish | source\n"
      "complete -c asperity -f\n";
  for (const ArgumentEntry& option : tree.program.options) text += option_line("__fish_use_subcommand", option);
  for (const CommandEntry& command : tree.commands) text += command_lines(command);
  return text;
}

}  // namespace asperity::app
