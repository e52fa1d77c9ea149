#include "app/pictures.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>

#include "app/interruption.hpp"
#include "core/base/error.hpp"
#include "core/base/output_error.hpp"
#include "core/output/run_files.hpp"
#include "render/scene.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

std::vector<render::Field> parse_fields(const std::vector<std::string>& names) {
  std::vector<render::Field> fields;
  for (const std::string& name : names) {
    const auto field = render::field_from_name(name);
    if (!field) {
      std::string known;
      for (render::Field f : render::all_fields())
        known += (known.empty() ? "" : ", ") + std::string(render::field_name(f));
      throw Error(ErrorKind::usage, {{"--field", "is no field that can be drawn", name, known, ""}});
    }
    fields.push_back(*field);
  }
  return fields;
}

std::vector<int> parse_frames(const std::string& text, int count) {
  if (count == 0) {
    throw Error(ErrorKind::usage, {{"--frames", "there is nothing to draw: the run has no frames", "", "",
                                    "run it with /output/frames above 0"}});
  }
  if (text == "all") {
    std::vector<int> frames(count);
    std::iota(frames.begin(), frames.end(), 0);
    return frames;
  }
  if (text == "last") return {count - 1};
  int frame = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), frame);
  if (error != std::errc() || end != text.data() + text.size() || frame < 0 || frame >= count) {
    throw Error(ErrorKind::usage, {{"--frames", "names no frame of this run", text,
                                    "all, last, or 0 to " + std::to_string(count - 1), ""}});
  }
  return {frame};
}

render::PictureOptions picture_options(const OutputConfig& output) {
  render::PictureOptions options;
  options.width = output.width_px;
  options.height = output.height_px;
  return options;
}

}  // namespace

void draw_frames(const RunFolder& folder, const OutputConfig& output, const std::vector<std::string>& fields,
                 const std::string& frames) {
  const int count = static_cast<int>(render::series_times(folder.root()).size());
  render::draw_series(folder.root(), parse_fields(fields.empty() ? output.fields : fields), parse_frames(frames, count),
                      picture_options(output));
}

void clear_pictures(const RunFolder& folder) try {
  if (!std::filesystem::exists(folder.frames())) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder.frames())) {
    if (is_run_file(entry.path().lexically_relative(folder.root()))) std::filesystem::remove(entry.path());
  }
} catch (const std::filesystem::filesystem_error& failure) {
  throw output_error(failure.path1(), "cannot be cleared", failure.code().value());
}

std::vector<int> frames_to_draw(const std::filesystem::path& root, const OutputConfig& output) {
  const int count = static_cast<int>(render::series_times(root).size());
  const std::vector<render::Field> fields = parse_fields(output.fields);
  std::vector<int> missing;
  for (int frame = 0; frame < count; ++frame) {
    const bool drawn = std::all_of(fields.begin(), fields.end(), [&](render::Field field) {
      return std::filesystem::exists(render::picture_path(root, field, frame));
    });
    if (!drawn) missing.push_back(frame);
  }
  return missing;
}

bool draw_until_interrupted(const RunFolder& folder, const OutputConfig& output, const std::vector<int>& frames) {
  return render::draw_series(folder.root(), parse_fields(output.fields), frames, picture_options(output),
                             interruption_requested);
}

}  // namespace asperity::app
