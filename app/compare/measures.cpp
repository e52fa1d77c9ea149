#include "app/compare/measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/units.hpp"
#include "render/fragment_colours.hpp"
#include "render/series.hpp"

namespace asperity::app {
namespace {

constexpr double kGridEdges = 2;  // width of a grid's square, over the mean edge of the coarser mesh

/// Numbers places: two nearer than the mesh resolves are one vertex.
class Vertices {
 public:
  int of(Vec2 place) {
    constexpr double kPerMm = 1e3;
    const std::pair key{std::llround(kPerMm * place.x), std::llround(kPerMm * place.y)};
    return numbers_.try_emplace(key, static_cast<int>(numbers_.size())).first->second;
  }

 private:
  std::map<std::pair<long long, long long>, int> numbers_;
};

void measure_cracks(const MeasuredPattern& pattern, PatternMeasures& m) {
  for (const CrackLine& crack : pattern.cracks)
    (crack.mode == BreakMode::tension ? m.cracks_tension : m.cracks_shear) += 1;
  for (const CrackSegment& segment : pattern.frame.cracks) m.contacts_softening += segment.mode == CrackMode::softening;
  m.crack_length_mm = total_length(pattern.cracks);
  m.tension_share_of_length =
      length_share(pattern.cracks, [](const CrackLine& crack) { return crack.mode == BreakMode::tension; });
  const AxialStatistics statistics = axial_statistics(pattern.cracks);
  m.mean_orientation_deg = statistics.mean_deg;
  m.orientation_resultant = statistics.resultant;
  m.orientation = orientation_shares(pattern.cracks);
  if (pattern.cracks.empty()) return;
  const CrackPattern main_crack = largest_cluster(pattern.cracks);
  m.main_crack_angle_deg = principal_direction(main_crack).angle_deg;
  m.main_crack_share_of_length = total_length(main_crack) / m.crack_length_mm;
}

void measure_fragments(const Frame& frame, PatternMeasures& m) {
  const std::vector<render::FragmentShare> fragments = render::fragments_by_area(frame);
  m.fragments = static_cast<double>(fragments.size());
  m.largest_fragment_share = fragments.empty() ? PatternMeasures::kNothing : fragments.front().share;
}

/// energy.csv has a row for each of curves.csv; its last one where a run was cut off between the two.
void measure_energies(const CsvData& energy, std::size_t row, PatternMeasures& m) {
  if (energy.rows() == 0) return;
  const auto value = [&](const char* column) {
    return energy.has(column) ? energy.numbers(column)[std::min(row, energy.rows() - 1)] : 0.0;
  };
  m.external_work_n_mm = value("external_work_n_mm");
  const auto share = [&](double part) {
    return m.external_work_n_mm > 0 ? part / m.external_work_n_mm : PatternMeasures::kNothing;
  };
  m.elastic_share = share(value("elastic_n_mm") + value("recoverable_n_mm"));
  m.fracture_share = share(value("fracture_n_mm"));
  m.friction_share = share(value("friction_n_mm"));
  m.damping_share = share(value("damping_n_mm"));
  m.kinetic_share = share(value("kinetic_n_mm"));
  m.plasticity_share = share(value("plasticity_n_mm"));
}

MeasuredPattern measured(const ComparedRun& run, const AlignedFrame& aligned) {
  MeasuredPattern pattern{render::read_frame(run.folder, aligned.frame.number), aligned, {}, {}};
  pattern.cracks = crack_pattern(run.cracks, pattern.frame.time_s);
  PatternMeasures& m = pattern.measures;
  const bool sheared = run.config.experiment.type == ExperimentType::direct_shear;
  m.time_s = pattern.frame.time_s;
  m.stress_mpa = aligned.frame.stress_mpa;
  m.displacement_mm =
      run.curves.numbers(sheared ? "shear_displacement_mm" : "platen_displacement_mm")[aligned.frame.row];
  if (!sheared) m.axial_strain = run.curves.numbers("axial_strain")[aligned.frame.row];
  measure_cracks(pattern, m);
  measure_fragments(pattern.frame, m);
  measure_energies(run.energy, aligned.frame.row, m);
  return pattern;
}

void compare_with(const MeasuredPattern& first, MeasuredPattern& pattern) {
  PatternMeasures& m = pattern.measures;
  m.orientation_distance_to_first_deg = orientation_distance_deg(first.cracks, pattern.cracks);
  if (same_mesh(first.frame, pattern.frame))
    m.damage_overlap_same_mesh = damage_overlap_on_mesh(first.frame, pattern.frame);
  m.grid_mm = kGridEdges * std::max(mean_edge_mm(first.frame), mean_edge_mm(pattern.frame));
  m.damage_overlap_on_grid = damage_overlap_on_grid(first.frame, pattern.frame, m.grid_mm);
}

}  // namespace

CrackPattern crack_pattern(const CsvData& cracks, double until_s) {
  const std::vector<double> time = cracks.numbers("time_s"), x = cracks.numbers("x_mm"), y = cracks.numbers("y_mm"),
                            angle = cracks.numbers("orientation_deg"), length = cracks.numbers("length_mm");
  const std::vector<std::string> mode = cracks.words("mode");
  CrackPattern pattern;
  Vertices vertices;
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] > until_s) continue;
    const double a = angle[i] * units::kRadPerDeg;
    const Vec2 middle{x[i], y[i]}, half = (0.5 * length[i]) * Vec2{std::cos(a), std::sin(a)};
    const std::array<Vec2, 2> end{middle - half, middle + half};
    pattern.push_back({{vertices.of(end[0]), vertices.of(end[1])},
                       end,
                       mode[i] == "tension" ? BreakMode::tension : BreakMode::shear});
  }
  return pattern;
}

std::vector<MeasuredPattern> measure_patterns(const std::vector<ComparedRun>& runs, const AlignedFrames& aligned) {
  std::vector<MeasuredPattern> patterns;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    patterns.push_back(measured(runs[i], aligned.frames[i]));
    compare_with(patterns.front(), patterns.back());
  }
  return patterns;
}

const std::vector<MeasureKind>& measure_kinds() {
  using M = PatternMeasures;
  static const std::vector<MeasureKind> kinds{
      {"time_s", "time", "s", &M::time_s},
      {"displacement_mm", "displacement", "mm", &M::displacement_mm},
      {"axial_strain", "axial strain", "–", &M::axial_strain},
      {"stress_mpa", "stress", "MPa", &M::stress_mpa},
      {"cracks_tension", "broken in tension", "–", &M::cracks_tension},
      {"cracks_shear", "broken in shear", "–", &M::cracks_shear},
      {"contacts_softening", "softening", "–", &M::contacts_softening},
      {"crack_length_mm", "total crack length", "mm", &M::crack_length_mm},
      {"tension_share_of_length", "tension's share of it", "–", &M::tension_share_of_length},
      {"mean_orientation_deg", "mean crack orientation", "°", &M::mean_orientation_deg},
      {"orientation_resultant", "how marked it is (0 to 1)", "–", &M::orientation_resultant},
      {"orientation_distance_to_first_deg", "orientations: distance to the first", "°",
       &M::orientation_distance_to_first_deg},
      {"main_crack_angle_deg", "main crack's angle", "°", &M::main_crack_angle_deg},
      {"main_crack_share_of_length", "main crack's share of length", "–", &M::main_crack_share_of_length},
      {"damage_overlap_same_mesh", "damage shared with the first, same mesh", "–", &M::damage_overlap_same_mesh},
      {"damage_overlap_on_grid", "damage shared with the first, on a grid", "–", &M::damage_overlap_on_grid},
      {"grid_mm", "the grid's squares", "mm", &M::grid_mm},
      {"fragments", "fragments", "–", &M::fragments},
      {"largest_fragment_share", "largest fragment's share of area", "–", &M::largest_fragment_share},
      {"external_work_n_mm", "external work", "N mm", &M::external_work_n_mm},
      {"elastic_share", "share of it: elastic", "–", &M::elastic_share},
      {"fracture_share", "share of it: fracture", "–", &M::fracture_share},
      {"friction_share", "share of it: friction", "–", &M::friction_share},
      {"damping_share", "share of it: damping", "–", &M::damping_share},
      {"kinetic_share", "share of it: kinetic", "–", &M::kinetic_share},
      {"plasticity_share", "share of it: plasticity", "–", &M::plasticity_share}};
  return kinds;
}

}  // namespace asperity::app
