#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace asperity::app {

/// Adds `compare` to the command line; parsed, it puts what is to be done into `action`.
void add_compare(CLI::App& cli, std::function<int()>& action);

}  // namespace asperity::app
