#include "render/series.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "render/vtu.hpp"

namespace asperity::render {
namespace {

namespace fs = std::filesystem;

/// One of the run's series: the bytes of a frame's VTU file, and back.
struct Series {
  const char* name;
  std::string (*bytes)(const Frame& frame);
  void (*read)(const fs::path& path, Frame& frame);
  bool in_every_run = true;  ///< Else runs of older versions lack it.
};

constexpr Series kFields{"fields", fields_vtu, read_fields_vtu};
constexpr Series kCracks{"cracks", cracks_vtu, read_cracks_vtu};
constexpr Series kContacts{"contacts", contacts_vtu, read_contacts_vtu, false};
constexpr std::array kSeries{kFields, kCracks, kContacts};

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
  for (const Series& series : kSeries) write_file_atomically(pvd_path(run_dir, series.name), pvd(series.name, times));
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
    if ((extension == ".vtu" && !kept) || extension == ".tmp") old.push_back(entry.path());
  }
  for (const fs::path& path : old) remove_file(path);
}

/// Physical times (s) of the frames that a .pvd file lists.
std::vector<double> listed_times(const fs::path& path) {
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

std::vector<double> kept_times(const fs::path& run_dir, std::size_t count) {
  std::vector<double> times;
  for (std::size_t s = 0; s < kSeries.size() && count > 0; ++s) {
    const fs::path path = pvd_path(run_dir, kSeries[s].name);
    times = listed_times(path);
    if (times.size() < count)
      throw Error(ErrorKind::output, fmt::format("cannot continue {}: it lists {} frames, {} are to be kept",
                                                 path.string(), times.size(), count));
    times.resize(count);
  }
  return times;
}

}  // namespace

SeriesWriter::SeriesWriter(fs::path run_dir, std::size_t frames_to_keep)
    : run_dir_(std::move(run_dir)), times_(kept_times(run_dir_, frames_to_keep)) {
  for (const Series& series : kSeries) make_folder(run_dir_ / series.name);
  write_pvds(run_dir_, times_);
  for (const Series& series : kSeries) remove_frames(run_dir_, series.name, times_.size());
}

void SeriesWriter::write(const Frame& frame) {
  std::vector<double> times = times_;
  times.push_back(frame.time_s);
  for (const Series& series : kSeries)
    write_file_atomically(run_dir_ / relative_file(series.name, times_.size()), series.bytes(frame));
  write_pvds(run_dir_, times);
  times_ = std::move(times);
}

std::vector<double> series_times(const fs::path& run_dir) { return listed_times(pvd_path(run_dir, kFields.name)); }

void require_contacts(const fs::path& run_dir) {
  const fs::path path = pvd_path(run_dir, kContacts.name);
  if (!fs::exists(path))
    throw Error(ErrorKind::output, "cannot draw contacts: there is no " + path.string() +
                                       " (older versions wrote none; run the test again)");
}

Frame read_frame(const fs::path& run_dir, int index) {
  Frame frame;
  frame.index = index;
  for (const Series& series : kSeries) {
    if (!series.in_every_run && !fs::exists(pvd_path(run_dir, series.name))) continue;
    series.read(run_dir / relative_file(series.name, static_cast<std::size_t>(index)), frame);
  }
  return frame;
}

}  // namespace asperity::render
