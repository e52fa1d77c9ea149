#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

/// The command line as plain data, read off the parser itself: completions and the manual are written from it, so that
/// they name the commands and options that there are.
namespace asperity::app {

/// What completes a value.
enum class ValueKind { none, text, config, folder, file, words, pointer };

/// An option, a flag, or a positional argument.
struct ArgumentEntry {
  std::vector<std::string> names;  ///< "-h", "--help"; of a positional its name.
  ValueKind kind = ValueKind::none;
  std::string type;                ///< "DIR", "INT"; empty for a flag.
  std::vector<std::string> words;  ///< Of kind words: all that are allowed. Of kind pointer: the keys of a run.
  std::string limits;              ///< "INT in [1 - 1024]"; empty without.
  std::string default_value;       ///< Empty without.
  std::string description;
  bool required = false;
  bool repeatable = false;
};

struct CommandEntry {
  std::string name;
  std::string description;
  std::vector<ArgumentEntry> positionals;
  std::vector<ArgumentEntry> options;
  std::string footer;  ///< Its examples, indented by two blanks, and remarks.
};

struct CommandTree {
  CommandEntry program;  ///< The options before any command.
  std::vector<CommandEntry> commands;
};

CommandTree read_command_tree(const CLI::App& cli);

/// All option names, with their dashes.
std::vector<std::string> option_names(const CommandEntry& command);

/// The names of all commands.
std::vector<std::string> command_names(const CommandTree& tree);

/// The words with blanks between them.
std::string in_a_line(const std::vector<std::string>& words, const std::string& separator = " ");

}  // namespace asperity::app
