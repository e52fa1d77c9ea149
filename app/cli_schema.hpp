#pragma once
#include <functional>

namespace CLI {
class App;
}

namespace asperity::app {

/// Adds `schema` to the command line; parsed, it puts what is to be done into `action`.
void add_schema(CLI::App& cli, std::function<int()>& action);

}  // namespace asperity::app
