#pragma once
#include <map>
#include <string>

namespace asperity::app {

/// Libraries this executable was built with: name -> version.
std::map<std::string, std::string> library_versions();

}  // namespace asperity::app
