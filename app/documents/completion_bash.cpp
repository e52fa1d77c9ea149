#include <fmt/format.h>

#include "app/documents/completion.hpp"

namespace asperity::app {
namespace {

// `compopt` fails where a test calls the function outside a completion, hence 2>/dev/null. "=" is a word of its own for
// bash: --out=DIR arrives as three words.
constexpr const char* kHelpers = R"bash(_asperity_words() { mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur"); }
_asperity_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -f -- "$cur")
}
_asperity_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}
_asperity_configs() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$cur"; compgen -f -X '!*.json' -- "$cur")
}
_asperity_pointers() {
  compopt -o nospace 2>/dev/null
  _asperity_words "$1"
}
)bash";

constexpr const char* kHead = R"bash(_asperity() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} command='' word
  COMPREPLY=()
  if [[ $cur == '=' ]]; then
    cur=''
  elif [[ $prev == '=' ]]; then
    prev=${COMP_WORDS[COMP_CWORD-2]}
  fi
)bash";

/// What completes a value of the argument, as a line of shell; a lone colon does nothing.
std::string value_line(const ArgumentEntry& argument) {
  switch (argument.kind) {
    case ValueKind::config:
      return "_asperity_configs";
    case ValueKind::folder:
      return "_asperity_folders";
    case ValueKind::file:
      return "_asperity_files";
    case ValueKind::words:
      return "_asperity_words '" + in_a_line(argument.words) + "'";
    case ValueKind::pointer:
      return "_asperity_pointers \"$_asperity_run_keys\"";
    case ValueKind::none:
    case ValueKind::text:
      break;
  }
  return ":";
}

/// The branches that complete the value of an option, empty where no option has one.
std::string option_values(const CommandEntry& command) {
  std::string branches;
  for (const ArgumentEntry& option : command.options) {
    if (option.kind == ValueKind::none) continue;
    branches += fmt::format("        {}) {}; return ;;\n", in_a_line(option.names, "|"), value_line(option));
  }
  return branches.empty() ? "" : "      case $prev in\n" + branches + "      esac\n";
}

std::string command_branch(const CommandEntry& command) {
  std::string text = fmt::format("    {})\n", command.name) + option_values(command);
  const std::string options = fmt::format("_asperity_words '{}'", in_a_line(option_names(command)));
  if (command.positionals.empty()) return text + "      " + options + " ;;\n";
  return text + fmt::format("      if [[ $cur == -* ]]; then {}; else {}; fi ;;\n", options,
                            value_line(command.positionals.front()));
}

std::vector<std::string> run_keys(const CommandTree& tree) {
  for (const CommandEntry& command : tree.commands) {
    for (const ArgumentEntry& option : command.options) {
      if (option.kind == ValueKind::pointer) return option.words;
    }
  }
  return {};
}

}  // namespace

std::string bash_completion(const CommandTree& tree) {
  std::string text =
      "# Completion of asperity for bash, written by: asperity completion bash\n"
      "# Load it by: source <(asperity completion bash)\n";
  text += fmt::format("_asperity_run_keys='{}'\n", in_a_line(run_keys(tree))) + kHelpers + kHead;
  text += fmt::format(
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n    case $word in\n      {}) command=$word; break "
      ";;\n    esac\n  done\n  case $command in\n",
      in_a_line(command_names(tree), "|"));
  for (const CommandEntry& command : tree.commands) text += command_branch(command);
  text += fmt::format("    *) _asperity_words '{} {}' ;;\n  esac\n}}\ncomplete -F _asperity asperity\n",
                      in_a_line(command_names(tree)), in_a_line(option_names(tree.program)));
  return text;
}

}  // namespace asperity::app
