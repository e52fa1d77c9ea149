#include "core/config/measured_path.hpp"

#include <string>

namespace asperity {

using nlohmann::json;

std::vector<Fault> take_in_measured_curve(json& document, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const json::json_pointer curve("/output/measured_curve"), name("/output/measured_name");
  if (!document.contains(curve)) {
    if (!document.contains(name)) return {};
    return {{name.to_string(), "names a measured curve that is not given", document.at(name).dump(), "",
             "give its file in /output/measured_curve, or remove the name"}};
  }
  if (!document.at(curve).is_string()) return {};
  const fs::path given = document.at(curve).get<std::string>();
  std::error_code ignored;  // what is wrong shows below
  const fs::path path = fs::absolute(given.is_absolute() ? given : folder / given, ignored).lexically_normal();
  if (!fs::is_regular_file(path, ignored)) {
    return {{curve.to_string(), "no such file", path.string(), "a CSV file",
             "check the path: it counts from the configuration's folder"}};
  }
  document[curve] = path.string();
  if (!document.contains(name)) document[name] = path.stem().string();
  return {};
}

}  // namespace asperity
