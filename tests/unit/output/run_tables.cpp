#include "core/output/run_tables.hpp"

#include <catch2/catch.hpp>

#include "core/base/atomic_file.hpp"
#include "core/measurement/acoustic.hpp"
#include "core/measurement/crack_network.hpp"
#include "core/measurement/sample.hpp"

using namespace asperity;

namespace {

std::string text_at(const std::vector<std::string>& columns, const std::vector<CsvCell>& row, const std::string& name) {
  REQUIRE(columns.size() == row.size());
  const auto found = std::find(columns.begin(), columns.end(), name);
  REQUIRE(found != columns.end());
  return row[static_cast<std::size_t>(found - columns.begin())].text();
}

}  // namespace

TEST_CASE("a sample fills its columns") {
  Sample sample;
  sample.time_s = 0.5, sample.closure_mm = 0.25, sample.axial_strain = 0.01, sample.stress_mpa = 1.5;
  sample.cracks_shear = 7, sample.reaction_top_n = 33;
  sample.energy.external_work = 10, sample.energy.elastic = 6, sample.energy.damping = 3;
  CHECK(text_at(curve_columns(), curve_row(sample), "platen_displacement_mm") == "0.25");
  CHECK(text_at(curve_columns(), curve_row(sample), "axial_stress_mpa") == "1.5");
  CHECK(text_at(curve_columns(), curve_row(sample), "reaction_top_n") == "33");
  CHECK(text_at(curve_columns(), curve_row(sample), "cracks_shear") == "7");
  CHECK(text_at(curve_columns(), curve_row(sample), "elastic_n_mm") == "6");
  CHECK(text_at(energy_columns(), energy_row(sample), "time_s") == "0.5");
  CHECK(text_at(energy_columns(), energy_row(sample), "axial_strain") == "0.01");
  CHECK(text_at(energy_columns(), energy_row(sample), "damping_n_mm") == "3");
  CHECK(text_at(energy_columns(), energy_row(sample), "closure_error_n_mm") == "1");
}

TEST_CASE("a crack fills its columns, its mode as a word") {
  Crack crack;
  crack.contact = 12, crack.mode = BreakMode::shear, crack.place = {1.5, -2}, crack.energy_n_mm = 0.25;
  CHECK(text_at(crack_columns(), crack_row(crack), "contact") == "12");
  CHECK(text_at(crack_columns(), crack_row(crack), "mode") == "shear");
  CHECK(text_at(crack_columns(), crack_row(crack), "y_mm") == "-2");
  CHECK(text_at(crack_columns(), crack_row(crack), "energy_n_mm") == "0.25");
}

TEST_CASE("an acoustic event fills its columns") {
  AcousticEvent event;
  event.time_s = 0.5, event.duration_s = 0.25, event.place = {1, 2}, event.energy_n_mm = 3;
  event.cracks = 9, event.tension = 5, event.shear = 4;
  const std::vector<double> expected{0.5, 0.25, 1, 2, 9, 5, 4, 3};
  const std::vector<CsvCell> row = event_row(event);
  REQUIRE(row.size() == expected.size());
  REQUIRE(event_columns().size() == expected.size());
  for (std::size_t i = 0; i < row.size(); ++i) CHECK(row[i].text() == CsvCell(expected[i]).text());
}

TEST_CASE("outputs/README.md names every column of every table") {
  const std::string readme = read_file(std::string(ASPERITY_SOURCE_DIR) + "/outputs/README.md");
  for (const auto& columns : {curve_columns(), energy_columns(), crack_columns(), event_columns()}) {
    for (const std::string& column : columns) CHECK_THAT(readme, Catch::Contains("`" + column + "`"));
  }
}
