#include "app/cli_documents.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/documents/completion.hpp"
#include "app/documents/manual.hpp"
#include "core/base/build_info.hpp"
#include "core/base/revision_date.hpp"

namespace asperity::app {
namespace {

int print(const std::string& text) {
  std::cout << text << std::flush;
  return 0;
}

int completion_command(const CLI::App& cli, const std::string& shell) {
  const CommandTree tree = read_command_tree(cli);
  if (shell == "bash") return print(bash_completion(tree));
  return print(shell == "zsh" ? zsh_completion(tree) : fish_completion(tree));
}

}  // namespace

void add_completion(CLI::App& cli, Action& action) {
  auto shell = std::make_shared<std::string>();
  CLI::App* command =
      cli.add_subcommand("completion", "Prints a script that completes commands, options and files in a shell");
  command->add_option("shell", *shell, "Shell to complete in")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish"}));
  command->footer(
      "Examples:\n  source <(asperity completion bash)\n"
      "  asperity completion bash > ~/.local/share/bash-completion/completions/asperity\n"
      "  asperity completion fish > ~/.config/fish/completions/asperity.fish");
  command->callback([=, &cli, &action] { action = [=, &cli] { return completion_command(cli, *shell); }; });
}

void add_manual(CLI::App& cli, Action& action) {
  CLI::App* command = cli.add_subcommand("manual", "Prints the manual page asperity(1), all commands and options");
  command->footer("Examples:\n  asperity manual | man -l -\n  asperity manual > asperity.1");
  command->callback([&cli, &action] {
    action = [&cli] { return print(manual_page(read_command_tree(cli), build_info().version, revision_date())); };
  });
}

}  // namespace asperity::app
