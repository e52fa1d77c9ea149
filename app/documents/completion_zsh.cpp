#include <fmt/format.h>

#include <CLI/StringTools.hpp>

#include "app/documents/completion.hpp"

namespace asperity::app {
namespace {

/// Text inside the single quotes of a specification: the marks that _arguments reads are escaped.
std::string escaped(std::string text) {
  for (const char* mark : {"\\", ":", "[", "]"}) {
    text = CLI::detail::find_and_replace(text, mark, std::string("\\") + mark);
  }
  return CLI::detail::find_and_replace(text, "'", "'\\''");
}

/// The action of _arguments that completes a value.
std::string value_action(const ArgumentEntry& argument) {
  switch (argument.kind) {
    case ValueKind::config:
      return "_files -g \"*.json(-.)\"";
    case ValueKind::folder:
      return "_files -/";
    case ValueKind::file:
      return "_files";
    case ValueKind::words:
      return "(" + in_a_line(argument.words) + ")";
    case ValueKind::pointer:
      return "compadd -S \"\" -a run_keys";
    case ValueKind::none:
    case ValueKind::text:
      break;
  }
  return " ";
}

std::string value_part(const ArgumentEntry& argument) {
  if (argument.kind == ValueKind::none) return "";
  return ":" + escaped(argument.type) + ":" + value_action(argument);
}

/// One line for each name of an option: '*--set[Overrides a key]:POINTER=VALUE:...'.
std::string option_lines(const ArgumentEntry& option) {
  std::string lines;
  for (const std::string& name : option.names) {
    lines += fmt::format("            '{}{}[{}]{}' \\\n", option.repeatable ? "*" : "", name,
                         escaped(option.description), value_part(option));
  }
  return lines;
}

std::string positional_line(const ArgumentEntry& positional) {
  const std::string place = positional.repeatable ? "*" : "";
  return fmt::format("            '{}:{}:{}' \\\n", place, escaped(positional.names.front()), value_action(positional));
}

std::string command_branch(const CommandEntry& command) {
  std::string text = fmt::format("        {})\n          _arguments \\\n", command.name);
  for (const ArgumentEntry& option : command.options) text += option_lines(option);
  for (const ArgumentEntry& positional : command.positionals) text += positional_line(positional);
  return text + "            && return 0 ;;\n";
}

std::string run_keys_line(const CommandTree& tree) {
  for (const CommandEntry& command : tree.commands) {
    for (const ArgumentEntry& option : command.options) {
      if (option.kind == ValueKind::pointer) return "  run_keys=(" + in_a_line(option.words) + ")\n";
    }
  }
  return "";
}

}  // namespace

std::string zsh_completion(const CommandTree& tree) {
  std::string text =
      "#compdef asperity\n"
      "# Completion of asperity for zsh, written by: asperity completion zsh\n"
      "# Load it by: source <(asperity completion zsh)\n"
      "_asperity() {\n"
      "  local curcontext=$curcontext state line\n"
      "  typeset -A opt_args\n"
      "  local -a commands run_keys\n"
      "  commands=(\n";
  for (const CommandEntry& command : tree.commands) {
    text += fmt::format("    '{}:{}'\n", command.name, escaped(command.description));
  }
  text += "  )\n" + run_keys_line(tree);
  text += "  _arguments -C \\\n";
  for (const ArgumentEntry& option : tree.program.options) text += option_lines(option);
  text +=
      "    '1:command:->command' '*::argument:->argument' && return 0\n"
      "  case $state in\n"
      "    command) _describe command commands ;;\n"
      "    argument)\n"
      "      case $line[1] in\n";
  for (const CommandEntry& command : tree.commands) text += command_branch(command);
  return text +
         "      esac ;;\n"
         "  esac\n"
         "}\n"
         "if [[ $funcstack[1] == _asperity ]]; then _asperity \"$@\"; else compdef _asperity asperity; fi\n";
}

}  // namespace asperity::app
