#include "app/documents/command_tree.hpp"

#include <CLI/CLI.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "app/cli_options.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/config/schema.hpp"
#include "render/field.hpp"

namespace asperity::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> mechanism_words() {
  std::vector<std::string> words;
  for (const MechanismDeclaration& mechanism : declared_mechanisms()) words.push_back(mechanism.id);
  return words;
}

std::vector<std::string> field_words() {
  std::vector<std::string> words;
  for (const render::Field field : render::all_fields()) words.emplace_back(render::field_name(field));
  return words;
}

/// JSON pointers, with "=", of every key below `schema` that is no object of keys itself.
void collect_pointers(const Json& schema, const std::string& pointer, std::vector<std::string>& pointers) {
  if (!schema.contains("properties")) return pointers.push_back(pointer + "=");
  for (const auto& [key, child] : schema["properties"].items()) {
    if (!key.starts_with('$')) collect_pointers(child, pointer + "/" + key, pointers);
  }
}

std::vector<std::string> run_pointers() {
  std::vector<std::string> pointers;
  collect_pointers(Json::parse(schema_text("run")), "", pointers);
  return pointers;
}

/// The words of "{local,slurm}", as CLI11 describes membership of a set; nothing where `limits` is no such text.
std::vector<std::string> words_of_set(const std::string& limits) {
  if (!limits.starts_with('{') || !limits.ends_with('}')) return {};
  return CLI::detail::split(limits.substr(1, limits.size() - 2), ',');
}

void take_words(ArgumentEntry& entry, std::vector<std::string> words) {
  entry.kind = ValueKind::words;
  entry.words = std::move(words);
}

/// What the name of the type says of the value.
void take_kind(ArgumentEntry& entry) {
  static const std::map<std::string, ValueKind> kinds{
      {kConfig, ValueKind::config}, {kFolder, ValueKind::folder}, {kFile, ValueKind::file}};
  const auto kind = kinds.find(entry.type);
  entry.kind = kind == kinds.end() ? ValueKind::text : kind->second;
  if (const auto words = words_of_set(entry.limits); !words.empty()) take_words(entry, words);
  if (entry.type == kMechanism) take_words(entry, mechanism_words());
  if (entry.type == kField) take_words(entry, field_words());
  if (entry.type == kSchemaKind) take_words(entry, schema_kinds());
  if (entry.type == kOverride) {
    take_words(entry, run_pointers());
    entry.kind = ValueKind::pointer;
  }
}

std::vector<std::string> names_of(const CLI::Option& option) {
  if (option.get_positional()) return {option.get_single_name()};
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

ArgumentEntry read_argument(const CLI::Option& option) {
  ArgumentEntry entry;
  entry.names = names_of(option);
  entry.description = option.get_description();
  if (option.get_expected_min() == 0) return entry;  // a flag
  const std::string type = option.get_type_name();   // "TEXT:{local,slurm}", "INT:INT in [1 - 1024]", "DIR"
  const std::size_t colon = type.find(':');
  entry.type = type.substr(0, colon);
  entry.limits = colon == std::string::npos ? "" : type.substr(colon + 1);
  entry.default_value = option.get_default_str();
  entry.required = option.get_required();
  entry.repeatable =
      option.get_expected_max() > 1 || option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
  take_kind(entry);
  return entry;
}

CommandEntry read_command(const CLI::App& app) {
  CommandEntry entry{app.get_name(), app.get_description(), {}, {}, app.get_footer()};
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; })) {
    (option->get_positional() ? entry.positionals : entry.options).push_back(read_argument(*option));
  }
  return entry;
}

}  // namespace

CommandTree read_command_tree(const CLI::App& cli) {
  CommandTree tree{read_command(cli), {}};
  for (const CLI::App* command : cli.get_subcommands([](const CLI::App*) { return true; })) {
    tree.commands.push_back(read_command(*command));
  }
  return tree;
}

std::vector<std::string> option_names(const CommandEntry& command) {
  std::vector<std::string> names;
  for (const ArgumentEntry& option : command.options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> command_names(const CommandTree& tree) {
  std::vector<std::string> names;
  for (const CommandEntry& command : tree.commands) names.push_back(command.name);
  return names;
}

std::string in_a_line(const std::vector<std::string>& words, const std::string& separator) {
  std::string line;
  for (const std::string& word : words) line += (line.empty() ? "" : separator) + word;
  return line;
}

}  // namespace asperity::app
