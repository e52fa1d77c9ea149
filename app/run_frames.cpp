#include "app/run_frames.hpp"

#include <algorithm>
#include <cmath>

#include "render/series.hpp"

namespace asperity::app {
namespace {

constexpr std::size_t kTelling = 5;

std::size_t nearest_row(const std::vector<double>& times, double time_s) {
  const auto after = std::lower_bound(times.begin(), times.end(), time_s);
  if (after == times.begin()) return 0;
  if (after == times.end()) return times.size() - 1;
  const auto row = static_cast<std::size_t>(after - times.begin());
  return time_s - times[row - 1] < times[row] - time_s ? row - 1 : row;
}

std::size_t peak_row(const std::vector<double>& stresses) {
  return static_cast<std::size_t>(std::max_element(stresses.begin(), stresses.end()) - stresses.begin());
}

/// Where the stress is farthest below what it was a tenth of the rest earlier.
std::size_t end_of_largest_fall(const std::vector<double>& stresses, std::size_t peak) {
  const std::size_t back = std::max<std::size_t>(1, (stresses.size() - 1 - peak) / 10);
  std::size_t found = peak;
  double largest = 0;
  for (std::size_t i = peak; i < stresses.size(); ++i) {
    const double fall = stresses[std::max(peak, i > back ? i - back : 0)] - stresses[i];
    if (fall <= largest) continue;
    largest = fall;
    found = i;
  }
  return found;
}

}  // namespace

Abscissa abscissa_of(ExperimentType type) {
  if (type == ExperimentType::direct_shear) return {"shear_displacement_mm", 1.0, "shear displacement [mm]"};
  return {"axial_strain", 100.0, is_compression(type) ? "axial strain [%]" : "closure / diameter [%]"};
}

std::vector<double> abscissae(const CsvData& table, const Abscissa& abscissa) {
  std::vector<double> values = table.numbers(abscissa.column);
  for (double& value : values) value *= abscissa.factor;
  return values;
}

const char* stress_column(ExperimentType type) {
  return type == ExperimentType::direct_shear ? "shear_stress_mpa" : "axial_stress_mpa";
}

const char* stress_label(ExperimentType type) {
  if (type == ExperimentType::direct_shear) return "shear stress [MPa]";
  return is_compression(type) ? "σ₁ [MPa]" : "2P/(πDt) [MPa]";
}

std::vector<RunFrame> run_frames(const std::filesystem::path& root, const CsvData& curves, ExperimentType type) {
  if (!std::filesystem::exists(root / "fields.pvd") || curves.rows() == 0) return {};
  const std::vector<double> times = curves.numbers("time_s"), x = abscissae(curves, abscissa_of(type));
  const std::vector<double> stresses = curves.numbers(stress_column(type));
  std::vector<RunFrame> frames;
  for (const double time : render::series_times(root)) {
    const std::size_t row = nearest_row(times, time);
    frames.push_back({static_cast<int>(frames.size()), row, x[row], stresses[row]});
  }
  return frames;
}

std::vector<RunFrame> telling_frames(const std::vector<RunFrame>& frames, const std::vector<double>& abscissae,
                                     const std::vector<double>& stresses) {
  if (frames.size() <= kTelling) return frames;
  const std::size_t peak = peak_row(stresses), fallen = end_of_largest_fall(stresses, peak);
  const double end = abscissae.back();
  std::vector<RunFrame> left = frames, chosen;
  for (const double wanted :
       {end, abscissae[peak], abscissae[fallen], 0.5 * abscissae[peak], 0.5 * (abscissae[fallen] + end)}) {
    const auto nearest = std::min_element(left.begin(), left.end(), [&](const RunFrame& a, const RunFrame& b) {
      return std::abs(a.abscissa - wanted) < std::abs(b.abscissa - wanted);
    });
    chosen.push_back(*nearest);
    left.erase(nearest);
  }
  std::sort(chosen.begin(), chosen.end(), [](const RunFrame& a, const RunFrame& b) { return a.number < b.number; });
  return chosen;
}

}  // namespace asperity::app
