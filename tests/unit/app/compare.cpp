#include <catch2/catch.hpp>
#include <cmath>

#include "app/compare/comparison.hpp"
#include "app/compare/differences.hpp"
#include "core/base/error.hpp"

using namespace asperity;
using namespace asperity::app;

namespace {

/// A run of a compression test whose stress rises to 10 MPa at row 10 and falls by 1 MPa a row to 2 MPa.
ComparedRun course(double strain_a_row, std::size_t rows = 19) {
  std::string curves = "time_s,platen_displacement_mm,axial_strain,axial_stress_mpa\n";
  ComparedRun run;
  run.folder = "somewhere";
  run.config.experiment.type = ExperimentType::uniaxial;
  run.config.measurement.peak_strain_limit = 1;
  for (std::size_t i = 0; i < rows; ++i) {
    const double strain = strain_a_row * static_cast<double>(i);
    const double stress = i <= 10 ? static_cast<double>(i) : 20.0 - static_cast<double>(i);
    curves += std::to_string(1e-3 * static_cast<double>(i)) + "," + std::to_string(100 * strain) + "," +
              std::to_string(strain) + "," + std::to_string(stress) + "\n";
    if (i % 2 == 0) run.frames.push_back({static_cast<int>(i / 2), i, 100 * strain, stress});
  }
  run.curves = parse_csv(curves, "curves.csv");
  return run;
}

ComparedRun configured(const std::string& json, std::vector<MechanismConfig> mechanisms = {}) {
  ComparedRun run;
  run.effective = nlohmann::ordered_json::parse(json);
  run.config.mechanisms = std::move(mechanisms);
  return run;
}

std::vector<int> numbers_of(const AlignedFrames& aligned) {
  std::vector<int> numbers;
  for (const AlignedFrame& frame : aligned.frames) numbers.push_back(frame.frame.number);
  return numbers;
}

}  // namespace

TEST_CASE("A part of the peak is the first row that has fallen to it, or for a negative one has risen to it") {
  const std::vector<double> stress{1, 3, 5, 4, 9, 7, 3, 4, 1};
  CHECK(row_at_peak_part(stress, 0, 9, 1.0) == 4u);
  CHECK(row_at_peak_part(stress, 0, 9, 0.5) == 6u);
  CHECK(row_at_peak_part(stress, 0, 9, -0.5) == 2u);
  CHECK(row_at_peak_part(stress, 0, 4, 0.8) == 3u);   // of the peak among the first four rows
  CHECK(row_at_peak_part(stress, 1, 9, 0.25) == 6u);  // 1 + 0.25 (9 - 1) = 3
  CHECK_FALSE(row_at_peak_part(stress, 0, 9, 0.1).has_value());
  CHECK_FALSE(row_at_peak_part({}, 0, 0, 1.0).has_value());
}

TEST_CASE("Frames are aligned by strain or displacement at the last value that all runs have reached") {
  const std::vector<ComparedRun> runs{course(0.001), course(0.002, 7)};  // to 0.018, and to 0.012
  const AlignedFrames by_strain = align(runs, {});
  CHECK(by_strain.by == Alignment::strain);
  CHECK(by_strain.at == Approx(0.012));
  CHECK(numbers_of(by_strain) == std::vector<int>{6, 3});
  CHECK(numbers_of(align(runs, {Alignment::displacement, 0.4})) == std::vector<int>{2, 1});
  CHECK(numbers_of(align(runs, {std::nullopt, 0.0})) == std::vector<int>{0, 0});
  CHECK_THROWS_WITH(align(runs, {Alignment::strain, 0.02}), Catch::Contains("--at") && Catch::Contains("0 to 0.012"));
  CHECK_THROWS_AS(align(runs, {Alignment::displacement, -1.0}), Error);
}

TEST_CASE("Frames are aligned by parts of the peak, and a run that never fell so far says so") {
  const std::vector<ComparedRun> runs{course(0.001), course(0.001, 13)};  // the second ends at 8 MPa
  CHECK(numbers_of(align(runs, {Alignment::peak, 1.0})) == std::vector<int>{5, 5});
  CHECK(numbers_of(align(runs, {Alignment::peak, -0.4})) == std::vector<int>{2, 2});
  const AlignedFrames half = align(runs, {Alignment::peak, std::nullopt});
  CHECK(half.at == 0.5);
  CHECK(numbers_of(half)[1] == 6);
  CHECK(half.frames[0].reached);
  CHECK_FALSE(half.frames[1].reached);
  for (const double part : {0.0, 1.5, -2.0}) CHECK_THROWS_AS(align(runs, {Alignment::peak, part}), Error);
}

TEST_CASE("Joints are aligned by displacement, and have no strain") {
  std::vector<ComparedRun> runs{course(0.001), course(0.001)};
  for (ComparedRun& run : runs) {
    run.config.experiment.type = ExperimentType::direct_shear;
    run.curves = parse_csv("time_s,shear_displacement_mm,shear_stress_mpa\n0,0,0\n1,2,1\n2,4,1\n", "curves.csv");
    run.frames = {{0, 0, 0, 0}, {1, 2, 4, 1}};
  }
  CHECK(align(runs, {}).by == Alignment::displacement);
  CHECK(align(runs, {}).at == 4);
  CHECK_THROWS_WITH(align(runs, {Alignment::strain, std::nullopt}), Catch::Contains("no strain"));
}

TEST_CASE("What differs is told by name and unit: the seed first, then mechanisms, names and output never") {
  const std::vector<ComparedRun> runs{
      configured(R"({"name":"a","contacts":{"cohesion_mpa":5.02,"law":{"reading":"default"}},"particles":{"seed":1},
                     "output":{"frames":5}})"),
      configured(R"({"name":"b","contacts":{"cohesion_mpa":4,"law":{"reading":"default"}},"particles":{"seed":2},
                     "output":{"frames":9},"extra":true,"mechanisms":[{"type":"platen_friction"}]})",
                 {{"platen_friction", 0.5, {}}})};
  const std::vector<DifferingKey> keys = differing_keys(runs);
  REQUIRE(keys.size() == 4);
  CHECK(keys[0].pointer == "/particles/seed");
  CHECK(keys[1].pointer == "/mechanisms");
  CHECK(keys[1].values == std::vector<std::string>{"none", "platen_friction (friction_coefficient 0.15)"});
  CHECK(keys[2].pointer == "/contacts/cohesion_mpa");
  CHECK(keys[3].values == std::vector<std::string>{"–", "true"});
  CHECK(label_of(keys, 0) == "seed 1, no mechanism, contact cohesion 5.02 MPa, and 1 more");
  CHECK(label_of({keys[2]}, 1) == "contact cohesion 4 MPa");
  CHECK(label_of({}, 0) == "same configuration");
}

TEST_CASE("Cracks of a table up to a time are lines at rest that hang together where their ends meet") {
  const CsvData table = parse_csv(
      "contact,mode,time_s,x_mm,y_mm,orientation_deg,length_mm\n"
      "7,shear,0.1,1,0,0,2\n3,tension,0.2,2,1,90,2\n5,tension,0.3,9,9,45,1\n",
      "cracks.csv");
  const CrackPattern pattern = crack_pattern(table, 0.25);
  REQUIRE(pattern.size() == 2);
  CHECK(pattern[0].mode == BreakMode::shear);
  CHECK(pattern[0].end[1].x == Approx(2));
  CHECK(pattern[0].vertex[1] == pattern[1].vertex[0]);  // (2, 0)
  CHECK(pattern[0].vertex[0] != pattern[1].vertex[1]);
  CHECK(largest_cluster(pattern).size() == 2);
}

TEST_CASE("A montage begins before anything broke and ends with the last frame") {
  ComparedRun run = course(0.001);
  const auto numbers = [&](const std::string& cracks, std::size_t count) {
    run.cracks = parse_csv("time_s\n" + cracks, "cracks.csv");
    std::vector<int> all;
    for (const RunFrame& frame : montage_frames(run, count)) all.push_back(frame.number);
    return all;
  };
  CHECK(numbers("0.0095\n0.012\n", 3) == std::vector<int>{4, 7, 9});  // frames lie at 0, 2, ... 18 ms
  CHECK(numbers("", 4) == std::vector<int>{0, 3, 6, 9});
  CHECK(numbers("0.0165\n", 8) == std::vector<int>{8, 9});
  CHECK(numbers("0.0095\n", 1) == std::vector<int>{9});
}

TEST_CASE("Measures are written for readers") {
  CHECK(measure_text(12) == "12");
  CHECK(measure_text(-0.0) == "0");
  CHECK(measure_text(-8.5912) == "−8.591");
  CHECK(measure_text(std::nan("")) == "–");
}
