#include "app/confrontation/confusion_picture.hpp"

#include <cmath>

#include "app/report/document.hpp"
#include "core/base/error.hpp"
#include "render/matrix_plot.hpp"
#include "render/paint.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names(const Value& list) {
  std::vector<std::string> all;
  for (const Value& name : list.items()) all.push_back(name.text());
  return all;
}

std::vector<std::vector<double>> counts_of(const Value& list, const fs::path& json) {
  std::vector<std::vector<double>> counts;
  for (const Value& row : list.items()) {
    counts.push_back(row.numbers());
    for (const double count : counts.back()) {
      if (std::isfinite(count) && count >= 0.0) continue;
      throw Error(ErrorKind::config, {{json.string() + ": /counts/" + std::to_string(counts.size() - 1),
                                       "holds what is no count", std::to_string(count), "0 or more", ""}});
    }
  }
  return counts;
}

}  // namespace

fs::path draw_confusion(const fs::path& json, const std::optional<fs::path>& picture) {
  const fs::path path = picture.value_or(fs::path(json).replace_extension(".png"));
  const std::string ending = path.extension().string();
  if (ending != ".png" && ending != ".svg")
    throw Error(ErrorKind::usage, {{"--out", "is no picture that can be written", path.string(), ".png or .svg", ""}});
  const Document document(json);
  const Value root = document.root();
  const render::Drawing drawing = render::draw_matrix(
      render::confusion_matrix(names(root["rows"]), names(root["columns"]), counts_of(root["counts"], json)));
  if (ending == ".svg")
    render::write_svg(drawing, path);
  else
    render::write_png(drawing, path);
  return path;
}

}  // namespace asperity::app
