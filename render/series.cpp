#include "render/series.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>
#include <sstream>
#include <string>

#include "core/base/error.hpp"
#include "render/file.hpp"
#include "render/vtu.hpp"

namespace asperity::render {
namespace {

namespace fs = std::filesystem;

std::string relative_file(const char* series, std::size_t index) {
  return fmt::format("{0}/{0}_{1:06}.vtu", series, index);
}

/// {} prints the shortest digits that read back as the same double.
std::string pvd(const char* series, const std::vector<double>& times) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "  <Collection>\n";
  for (std::size_t i = 0; i < times.size(); ++i)
    text += fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", times[i], relative_file(series, i));
  return text + "  </Collection>\n</VTKFile>\n";
}

fs::path pvd_path(const fs::path& run_dir, const char* series) { return run_dir / (std::string(series) + ".pvd"); }

void write_pvds(const fs::path& run_dir, const std::vector<double>& times) {
  for (const char* series : {"fields", "cracks"}) write_file(pvd_path(run_dir, series), pvd(series, times));
}

void remove_file(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) throw Error(ErrorKind::output, "cannot remove " + path.string() + ": " + error.message());
}

/// Removes the frames from number `first` on, and unfinished files.
void remove_frames(const fs::path& run_dir, const char* series, std::size_t first) {
  std::error_code error;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(run_dir / series, error)) {
    const std::string extension = entry.path().extension().string();
    const bool kept =
        extension == ".vtu" && entry.path().filename() < fs::path(relative_file(series, first)).filename();
    if ((extension == ".vtu" && !kept) || extension == ".part") old.push_back(entry.path());
  }
  for (const fs::path& path : old) remove_file(path);
}

std::vector<double> kept_times(const fs::path& run_dir, std::size_t count) {
  if (count == 0) return {};
  std::vector<double> times = series_times(run_dir);
  if (times.size() < count)
    throw Error(ErrorKind::output, fmt::format("cannot continue {}: it lists {} frames, {} are to be kept",
                                               pvd_path(run_dir, "fields").string(), times.size(), count));
  times.resize(count);
  return times;
}

}  // namespace

SeriesWriter::SeriesWriter(fs::path run_dir, std::size_t frames_to_keep)
    : run_dir_(std::move(run_dir)), times_(kept_times(run_dir_, frames_to_keep)) {
  write_pvds(run_dir_, times_);
  for (const char* series : {"fields", "cracks"}) remove_frames(run_dir_, series, times_.size());
}

void SeriesWriter::write(const Frame& frame) {
  std::vector<double> times = times_;
  times.push_back(frame.time_s);
  write_file(run_dir_ / relative_file("fields", times_.size()), fields_vtu(frame));
  write_file(run_dir_ / relative_file("cracks", times_.size()), cracks_vtu(frame));
  write_pvds(run_dir_, times);
  times_ = std::move(times);
}

std::vector<double> series_times(const fs::path& run_dir) {
  const fs::path path = pvd_path(run_dir, "fields");
  std::ifstream file(path);
  if (!file) throw Error(ErrorKind::output, "cannot read " + path.string());
  std::stringstream content;
  content << file.rdbuf();
  const std::string text = content.str(), key = "timestep=\"";
  if (text.find("</VTKFile>") == std::string::npos)
    throw Error(ErrorKind::output, "cannot read " + path.string() + ": not a whole .pvd file");
  std::vector<double> times;
  for (std::size_t at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    double time = 0;
    const char* first = text.data() + at + key.size();
    if (std::from_chars(first, text.data() + text.size(), time).ec != std::errc{})
      throw Error(ErrorKind::output, "cannot read " + path.string() + ": a time step is not a number");
    times.push_back(time);
  }
  return times;
}

Frame read_frame(const fs::path& run_dir, int index) {
  Frame frame;
  frame.index = index;
  read_fields_vtu(run_dir / relative_file("fields", static_cast<std::size_t>(index)), frame);
  read_cracks_vtu(run_dir / relative_file("cracks", static_cast<std::size_t>(index)), frame);
  return frame;
}

}  // namespace asperity::render
