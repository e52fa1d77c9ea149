#include "app/libraries.hpp"

#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

namespace asperity::app {

namespace {

std::string json_version() {
  return std::to_string(NLOHMANN_JSON_VERSION_MAJOR) + "." + std::to_string(NLOHMANN_JSON_VERSION_MINOR) + "." +
         std::to_string(NLOHMANN_JSON_VERSION_PATCH);
}

}  // namespace

std::map<std::string, std::string> library_versions() {
  return {{"CGAL", ASPERITY_CGAL_VERSION},
          {"CLI11", CLI11_VERSION},
          {"Eigen", ASPERITY_EIGEN_VERSION},
          {"VTK", ASPERITY_VTK_VERSION},
          {"oneTBB", ASPERITY_TBB_VERSION},
          {"nlohmann_json", json_version()}};
}

}  // namespace asperity::app
