#include "app/libraries.hpp"

#include <CLI/Version.hpp>

namespace asperity::app {

std::map<std::string, std::string> library_versions() {
  return {{"CGAL", ASPERITY_CGAL_VERSION}, {"CLI11", CLI11_VERSION},           {"VTK", ASPERITY_VTK_VERSION},
          {"oneTBB", ASPERITY_TBB_VERSION}, {"nlohmann_json", ASPERITY_JSON_VERSION}};
}

}  // namespace asperity::app
