#include <iostream>
#include <system_error>

#include "app/commands/commands.hpp"
#include "app/compare/comparison.hpp"
#include "core/base/error.hpp"
#include "core/base/log.hpp"
#include "core/base/output_error.hpp"

namespace asperity::app {
namespace {

namespace fs = std::filesystem;

/// Names that would make a longer file name than systems take are counted instead.
std::string default_stem(const std::vector<ComparedRun>& runs) {
  constexpr std::size_t kLongest = 120;
  std::string stem = "compare";
  for (const ComparedRun& run : runs) stem += "_" + run.name;
  if (stem.size() <= kLongest) return stem;
  return ("compare_" + runs.front().name).substr(0, kLongest) + "_and_" + std::to_string(runs.size() - 1) + "_more";
}

fs::path picture_path(const std::optional<fs::path>& out, const std::string& stem) {
  if (!out) return fs::path("outputs") / (stem + ".png");
  if (out->extension() != ".png") {
    throw Error(ErrorKind::usage, {{"--out", "is no name of a PNG file", out->string(), "a name that ends in .png",
                                    "tables and page go beside it, named after it"}});
  }
  return *out;
}

void make_parents(const fs::path& file) {
  if (!file.has_parent_path()) return;
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) throw output_error(file.parent_path(), "cannot be created", error.value());
}

render::Field field_of(const std::string& name) {
  return name == "damage" ? render::Field::damage : render::Field::cracks;
}

/// A difference map of other runs that was drawn under the same name must not stand beside this picture.
void remove_old_difference(const ComparisonFiles& files) {
  std::error_code ignored;
  fs::remove(files.beside("_difference.png"), ignored);
}

int montage(const CompareOptions& options) {
  const ComparedRun run = read_compared_run(*options.montage);
  const fs::path picture = picture_path(options.out, "montage_" + run.name);
  make_parents(picture);
  draw_montage(run, options.frames, field_of(options.field), picture);
  std::cout << picture.string() << std::endl;
  return 0;
}

}  // namespace

int compare_command(const CompareOptions& options) {
  if (options.montage) return montage(options);
  const AlignmentRequest request{alignment_from_name(options.align), options.at};
  const Comparison comparison = compare_runs(options.run_dirs, request, field_of(options.field));
  const fs::path picture = picture_path(options.out, default_stem(comparison.runs));
  const ComparisonFiles files{picture, options.html.value_or(fs::path(picture).replace_extension(".html"))};
  make_parents(files.picture);
  make_parents(files.html);
  for (const std::string& warning : comparison.warnings) log_warning(warning);
  remove_old_difference(files);
  draw_comparison(comparison, files);
  const bool difference = draw_difference(comparison, files);
  draw_comparison_curves(comparison, files);
  write_tables(comparison, files);
  write_comparison_page(comparison, files);
  std::cout << markdown_table(comparison) << files.html.string() << "\n";
  if (difference) std::cout << files.beside("_difference.png").string() << "\n";
  std::cout << files.picture.string() << std::endl;
  return 0;
}

}  // namespace asperity::app
