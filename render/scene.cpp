#include "render/scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>

#include "core/base/atomic_file.hpp"
#include "render/paint.hpp"
#include "render/series.hpp"
#include "render/side_panel.hpp"
#include "render/specimen.hpp"
#include "render/style.hpp"
#include "render/text_metrics.hpp"

namespace asperity::render {
namespace {

// Pixels of the standard picture, 1600 x 1200.
constexpr double kMargin = 36, kHeader = 142, kScaleBarRow = 62, kBetween = 48;
constexpr double kNarrowPanel = 530, kWidePanel = 860;
constexpr double kBeside = 32;  // loose pieces may come so near to the picture's edge and the panel
constexpr double kInsetAspect = 1.15, kInsetPart = 0.76;  // highest inset: of its width, of the panel's height
constexpr double kBelowKey = 44;

Text line(Vec2 at, const std::string& text, double size, Weight weight, Colour colour) {
  return {at, text, size, Anchor::left, weight, Direction::across, colour};
}

std::string state_of(const Frame& frame, const PictureOptions& options) {
  const ExperimentTexts texts = experiment_texts(frame);
  const auto number = [](const char* format, double value) {
    const std::string text = fmt::format(fmt::runtime(format), std::abs(value));
    const bool zero = text.find_first_of("123456789") == std::string::npos;
    return value < 0 && !zero ? "−" + text : text;
  };
  std::string text = "Time " + number("{:.3f}", 1e3 * frame.time_s) + " ms  ·  " + texts.strain + " " +
                     number("{:.3f}", texts.strain_factor * frame.axial_strain) + " " + texts.strain_unit + "  ·  " +
                     texts.stress + " " + number("{:.2f}", frame.stress_mpa) + " MPa";
  if (frame.confining_pressure_mpa != 0)
    text += "  ·  Confining pressure " + number("{:.2f}", frame.confining_pressure_mpa) + " MPa";
  if (frame.joint.length_mm > 0) text += "  ·  Dilation " + number("{:.2f}", frame.joint.dilation_mm) + " mm";
  if (options.displacement_scale != 1) text += fmt::format("  ·  Displacements × {:g}", options.displacement_scale);
  return text;
}

void draw_header(Drawing& drawing, const Frame& frame, const PictureOptions& options, double unit) {
  const std::string experiment = experiment_texts(frame).title;
  const std::string title = frame.name.empty() ? experiment : experiment + ": " + frame.name;
  const std::string state = state_of(frame, options);
  const double room = drawing.width - 2 * kMargin * unit;
  const double title_size = fitting_size(title, style::kTitleSize * unit, Weight::bold, room);
  const double state_size = fitting_size(state, style::kSubtitleSize * unit, Weight::regular, room);
  drawing.shapes.push_back(line({kMargin * unit, (kMargin + 34) * unit}, title, title_size, Weight::bold, style::kInk));
  drawing.shapes.push_back(
      line({kMargin * unit, (kMargin + 82) * unit}, state, state_size, Weight::regular, style::kSoftInk));
}

/// The specimen's part of the picture, moved to the middle of the room the panel leaves it.
View place_view(const Frame& frame, const Drawing& drawing, double unit) {
  const Box room{kMargin * unit, kHeader * unit, drawing.width - (kMargin + kBetween + kNarrowPanel) * unit,
                 drawing.height - (kMargin + kScaleBarRow) * unit};
  View view = fit_view(frame, room);
  const double widest = drawing.width - (kMargin + kBetween + kWidePanel) * unit;
  view.area.right = std::max(view.area.right, widest);
  view.beside = kBeside * unit;
  return view;
}

/// Encodes and writes each picture on a thread of its own while the next one is painted.
class WriterBehind {
 public:
  void write(Pixels pixels, const std::filesystem::path& png) {
    finish();
    written_ = std::async(std::launch::async, [pixels = std::move(pixels), png] {
      write_file_atomically(preview_path(png), preview_bytes(pixels));
      write_file_atomically(png, png_bytes(pixels));  // last: where it stands, its preview does too
    });
  }

  /// Waits for the last picture. Throws what its writing threw.
  void finish() {
    if (written_.valid()) written_.get();
  }

 private:
  std::future<void> written_;
};

}  // namespace

Drawing draw_picture(const Frame& frame, const PictureOptions& options) {
  Drawing drawing{options.width, options.height, {}};
  const double unit = std::min(options.width / 1600.0, options.height / 1200.0);
  const View view = place_view(frame, drawing, unit);
  draw_specimen(drawing, frame, options, view, unit);
  draw_scale_bar(drawing, view, unit);
  draw_header(drawing, frame, options, unit);
  Box panel{view.area.right + kBetween * unit, kHeader * unit, drawing.width - kMargin * unit,
            drawing.height - kMargin * unit};
  const double key_end = draw_key(drawing, frame, options, view, panel, unit);
  panel.top = std::max(key_end + kBelowKey * unit,
                       panel.bottom - std::min(kInsetAspect * panel.width(), kInsetPart * panel.height()));
  draw_inset(drawing, frame, options, panel, unit);
  return drawing;
}

void draw_frame(const Frame& frame, const PictureOptions& options, const std::filesystem::path& png) {
  write_png(draw_picture(frame, options), png);
}

SeriesRanges ranges_over_series(const std::filesystem::path& run_dir, const std::vector<Field>& fields) {
  SeriesRanges ranges{std::vector<std::optional<Range>>(fields.size()), {}, {}};
  const int count = static_cast<int>(series_times(run_dir).size());
  for (int index = 0; index < count; ++index) {
    const Frame frame = read_frame(run_dir, index);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      const std::optional<Range> range = frame_range(frame, fields[f]);
      if (range) ranges.values[f] = united(ranges.values[f].value_or(*range), *range);
    }
    ranges.strain = range_of(frame.curve.axial_strain);
    ranges.stress = range_of(frame.curve.stress_mpa);
  }
  return ranges;
}

std::optional<Range> range_over_series(const std::filesystem::path& run_dir, Field field) {
  return ranges_over_series(run_dir, {field}).values.front();
}

std::filesystem::path picture_path(const std::filesystem::path& run_dir, Field field, int frame) {
  return run_dir / "frames" / fmt::format("{}_{:06}.png", field_name(field), frame);
}

std::filesystem::path preview_path(std::filesystem::path picture) { return picture.replace_extension(".jpg"); }

bool draw_series(const std::filesystem::path& run_dir, const std::vector<Field>& fields, const std::vector<int>& frames,
                 const PictureOptions& options, const std::function<bool()>& interrupted) {
  if (std::find(fields.begin(), fields.end(), Field::contacts) != fields.end()) require_contacts(run_dir);
  const SeriesRanges ranges = ranges_over_series(run_dir, fields);
  make_folder(run_dir / "frames");
  WriterBehind writer;
  for (const int index : frames) {
    const Frame frame = read_frame(run_dir, index);
    for (std::size_t f = 0; f < fields.size(); ++f) {
      if (interrupted && interrupted()) {
        writer.finish();
        return false;
      }
      PictureOptions picture = options;
      picture.field = fields[f];
      if (!picture.value_range) picture.value_range = range_in_run(frame, fields[f], ranges.values[f]);
      if (!picture.strain_range) picture.strain_range = ranges.strain;
      if (!picture.stress_range) picture.stress_range = ranges.stress;
      writer.write(paint(draw_picture(frame, picture)), picture_path(run_dir, fields[f], index));
    }
  }
  writer.finish();
  return true;
}

}  // namespace asperity::render
