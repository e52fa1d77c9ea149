#include "app/documents/manual.hpp"

#include <fmt/format.h>

#include <sstream>

#include "app/documents/roff.hpp"
#include "app/exit_code.hpp"
#include "app/installation.hpp"

namespace asperity::app {
namespace {

/// "--out" DIR in the type of a manual.
std::string with_value(const std::string& name, const ArgumentEntry& option) {
  return roff::bold(name) + (option.type.empty() ? "" : " " + roff::italic(option.type));
}

std::string positional_usage(const ArgumentEntry& positional) {
  const std::string usage = roff::italic(positional.names.front()) + (positional.repeatable ? " ..." : "");
  return positional.required ? usage : "[" + usage + "]";
}

/// What may be said of a value beyond its description.
std::string remarks(const ArgumentEntry& argument) {
  std::string text;
  if (argument.kind == ValueKind::words) text += " One of " + in_a_line(argument.words, ", ") + ".";
  if (argument.kind == ValueKind::text && !argument.limits.empty()) text += " " + argument.limits + ".";
  if (!argument.default_value.empty()) text += " Default " + argument.default_value + ".";
  return text;
}

std::string sentence(const std::string& text) { return text.ends_with('.') ? text : text + "."; }

std::string argument_entry(const ArgumentEntry& argument, bool positional) {
  std::string names;
  for (const std::string& name : argument.names) {
    names += (names.empty() ? "" : ", ") + (positional ? positional_usage(argument) : with_value(name, argument));
  }
  return ".TP\n" + names + "\n" + roff::prose(sentence(argument.description) + remarks(argument));
}

std::string argument_entries(const CommandEntry& command) {
  std::string text;
  for (const ArgumentEntry& positional : command.positionals) text += argument_entry(positional, true);
  for (const ArgumentEntry& option : command.options) text += argument_entry(option, false);
  return text;
}

/// Indented lines as they are, the others as paragraphs.
std::string footer_text(const std::string& footer) {
  std::istringstream lines(footer);
  std::string text, line;
  bool example = false;
  while (std::getline(lines, line)) {
    const bool indented = line.starts_with("  ");
    if (example && !indented) text += ".EE\n.RE\n";
    if (!example && indented) text += ".RS 4\n.EX\n";
    example = indented;
    if (indented) text += roff::literal(line.substr(2)) + "\n";
    if (!indented && !line.empty()) text += ".PP\n" + roff::prose(line);
  }
  return text + (example ? ".EE\n.RE\n" : "");
}

std::string command_section(const CommandEntry& command) {
  std::string usage = roff::bold("asperity " + command.name) + " [" + roff::italic("options") + "]";
  for (const ArgumentEntry& positional : command.positionals) usage += " " + positional_usage(positional);
  return fmt::format(".SS {}\n{}\n.PP\n", command.name, usage) + roff::prose(sentence(command.description)) +
         argument_entries(command) + footer_text(command.footer);
}

std::string exit_section() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : exit_code_meanings()) {
    text += fmt::format(".TP\n.B {}\n", code) + roff::prose(sentence(meaning));
  }
  return text;
}

std::string file_entry(const std::string& path, const std::string& what) {
  return ".TP\n" + roff::italic(path) + "\n" + roff::prose(what);
}

std::string files_section() {
  return ".SH FILES\nBelow the prefix that Asperity was installed to:\n" +
         file_entry(
             "share/" + std::string(kSharedFolder) + "/configs",
             "Configurations of the tests in the examples above, with the data they need. Copy the folder to where you "
             "work, and the examples run as they are printed.") +
         file_entry("share/" + std::string(kSharedFolder) + "/configs/schema",
                    "JSON Schemas that explain every key; editors complete by them.") +
         file_entry("share/doc/asperity/README.md", "Where the documentation begins.");
}

}  // namespace

std::string manual_page(const CommandTree& tree, const std::string& version, const std::string& date) {
  std::string text = fmt::format(
      ".\\\" Written by: asperity manual\n.TH ASPERITY 1 {} \"Asperity {}\" \"User Commands\"\n", date, version);
  text += ".SH NAME\nasperity \\- discrete element workbench for rock failure\n";
  text += ".SH SYNOPSIS\n" + roff::bold("asperity") + " " + roff::italic("command") + " [" + roff::italic("options") +
          "] [" + roff::italic("argument") + " ...]\n";
  text += ".SH DESCRIPTION\n" +
          roff::prose(
              "A JSON file describes a laboratory test of rock; on a machine with no display Asperity simulates it "
              "with discrete elements and leaves a time series for ParaView, pictures, curves, an energy account "
              "and the record of where every number comes from.");
  text += ".SH OPTIONS\n" + argument_entries(tree.program) + ".SH COMMANDS\n";
  for (const CommandEntry& command : tree.commands) text += command_section(command);
  return text + exit_section() + files_section();
}

}  // namespace asperity::app
