#include "core/output/csv.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/base/random.hpp"
#include "tests/unit/output/scratch.hpp"

using namespace asperity;
using asperity::testing::fresh_folder;
using asperity::testing::SmallFiles;

namespace fs = std::filesystem;

namespace {

fs::path csv_of(const std::string& name, const std::string& text) {
  const fs::path path = fresh_folder(name) / "data.csv";
  write_file_atomically(path, text);
  return path;
}

}  // namespace

TEST_CASE("numbers are written in their shortest form that reads back") {
  CHECK(CsvCell(0.1).text() == "0.1");
  CHECK(CsvCell(1e-300).text() == "1e-300");
  CHECK(CsvCell(-2.0).text() == "-2");
  CHECK(CsvCell(42).text() == "42");
  CHECK(CsvCell(std::nan("")).text() == "nan");
  CHECK(CsvCell("say \"a, b\"").text() == "\"say \"\"a, b\"\"\"");
}

TEST_CASE("a table reads back bit for bit") {
  const fs::path path = fresh_folder("csv_round") / "curves.csv";
  RandomStream stream(3, "csv");
  std::vector<double> written{0.0, -0.0, std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min()};
  for (int i = 0; i < 1000; ++i) written.push_back(stream.normal() * std::pow(10.0, stream.uniform(-30, 30)));
  CsvTable table = CsvTable::create(path, {"time_s", "axial_stress_mpa"});
  for (const double value : written) table.append(std::vector<double>{1.0, value});
  CHECK(table.rows() == written.size());
  CHECK(read_csv(path).numbers("axial_stress_mpa") == written);
}

TEST_CASE("rows are in the file before the table is closed") {
  const fs::path path = fresh_folder("csv_flush") / "cracks.csv";
  CsvTable table = CsvTable::create(path, {"id", "mode", "time_s"});
  table.append({7, "shear", 0.25});
  CHECK(read_file(path) == "id,mode,time_s\n7,shear,0.25\n");
}

TEST_CASE("a resumed table keeps the checkpoint's rows and goes on") {
  const fs::path path = fresh_folder("csv_resume") / "curves.csv";
  {
    CsvTable table = CsvTable::create(path, {"a", "b"});
    for (int i = 0; i < 5; ++i) table.append({i, 10 * i});
  }
  CsvTable table = CsvTable::resume(path, {"a", "b"}, 2);
  table.append({7, 70});
  CHECK(read_file(path) == "a,b\n0,0\n1,10\n7,70\n");
  CHECK(table.rows() == 3);
}

TEST_CASE("a row cut off by a crash is dropped on resuming") {
  const fs::path path = csv_of("csv_cut", "a,b\n1,2\n3,");
  CHECK_THROWS_WITH(CsvTable::resume(path, {"a", "b"}, 2), Catch::Contains("rows are missing"));
  CsvTable::resume(path, {"a", "b"}, 1);
  CHECK(read_file(path) == "a,b\n1,2\n");
}

TEST_CASE("a table with other columns is not continued") {
  const fs::path path = csv_of("csv_other", "a,b\n1,2\n");
  CHECK_THROWS_WITH(CsvTable::resume(path, {"a", "c"}, 1), Catch::Contains("its columns are others"));
  CHECK_THROWS_WITH(CsvTable::resume(path, {"a"}, 1), Catch::Contains("its columns are others"));
}

TEST_CASE("a row that does not fit is an output error with path and reason, and leaves whole rows") {
  const fs::path path = fresh_folder("csv_limit") / "data.csv";
  CsvTable table = CsvTable::create(path, {"a", "b"});
  table.append({1, 2});
  const SmallFiles limit(10);  // four bytes of header, four of a row, two of the next
  try {
    table.append({3, 4});
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    CHECK_THAT(error.what(), Catch::StartsWith(path.string() + ": cannot be written: File too large"));
  }
  CHECK(read_file(path) == "a,b\n1,2\n");
  CHECK(table.rows() == 1);
}

TEST_CASE("a whole table replaces the old one, or leaves it") {
  const fs::path path = csv_of("csv_whole", "old\n");
  write_csv(path, {"a", "mode"}, {{1.5, "shear"}, {2, "tension"}});
  CHECK(read_file(path) == "a,mode\n1.5,shear\n2,tension\n");
  const SmallFiles limit(10);
  CHECK_THROWS_AS(write_csv(path, {"a", "mode"}, {{1.5, "shear"}}), Error);
  CHECK(read_file(path) == "a,mode\n1.5,shear\n2,tension\n");
}

TEST_CASE("comments, blanks, quotes, Windows line ends and a byte order mark are read") {
  const CsvData data =
      read_csv(csv_of("csv_read", "\xef\xbb\xbf# source\r\nspecimen, x_mm\r\n\r\n\"A, \"\"1\"\"\",+1.5\r\nB, \r\n"));
  CHECK(data.names() == std::vector<std::string>{"specimen", "x_mm"});
  CHECK(data.rows() == 2);
  CHECK(data.words("specimen") == std::vector<std::string>{"A, \"1\"", "B"});
  CHECK(data.numbers("x_mm").at(0) == 1.5);
  CHECK(std::isnan(data.numbers("x_mm").at(1)));
  CHECK(data.has("x_mm"));
  CHECK_FALSE(data.has("y_mm"));
}

TEST_CASE("faults in a CSV file name file and line") {
  const auto message = [](const std::string& text) {
    try {
      read_csv(csv_of("csv_fault", text)).numbers("x_mm");
    } catch (const Error& error) {
      CHECK(error.kind() == ErrorKind::config);
      return std::string(error.what());
    }
    return std::string("no error");
  };
  CHECK_THAT(message("# c\nx_mm,y\n1,2\n1\n"),
             Catch::Contains("data.csv:4: wrong number of cells (found 1; allowed: 2: x_mm, y)"));
  CHECK_THAT(message("x_mm\n1\nabc\n"),
             Catch::Contains("data.csv:3: x_mm is no number (found abc; allowed: a number)"));
  CHECK_THAT(message("x_mm\n1.0.0\n"), Catch::Contains("data.csv:2: x_mm is no number"));
  CHECK_THAT(message("x_mm\n\"1\n"), Catch::Contains("data.csv:2: a quote stays open"));
  CHECK_THAT(message("x_mm,y\n\"0.05\"junk,0.9\n"), Catch::Contains("data.csv:2: text stands behind a closing quote"));
  CHECK_THAT(message("x_mm;y\n0,5;1\n"),
             Catch::Contains("data.csv:1: the columns are separated by semicolons (found x_mm;y; allowed: commas"));
  CHECK_THAT(message("x_mm\ty\n1\t2\n"), Catch::Contains("data.csv:1: the columns are separated by tabs"));
  CHECK_THAT(message("x_mm,x_mm\n"), Catch::Contains("data.csv:1: a column is named twice (found x_mm)"));
  CHECK_THAT(message("y\n1\n"), Catch::Contains("data.csv: no column \"x_mm\" (allowed: y)"));
  CHECK_THAT(message("# only a comment\n"), Catch::Contains("data.csv: has no header row"));
}

TEST_CASE("text that is not UTF-8 is refused at its line") {
  const std::vector<std::string> wrong{
      "\xfc", "a\xc3", "\xc0\xaf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf4\x90\x80\x80", "\xf8", "\xff\xfe"};
  for (const std::string& text : wrong) {
    CAPTURE(text);
    CHECK_THROWS_WITH(parse_csv("x_mm\n1\n" + text + "\n", "data.csv"),
                      Catch::StartsWith("data.csv:3: is no UTF-8 text (found ") && Catch::Contains("save the file as"));
  }
  CHECK_THROWS_WITH(parse_csv("Pr\xfc"
                              "f,x\n",
                              "data.csv"),
                    Catch::Contains("(found Pr\\xfcf,x)"));
  CHECK(parse_csv("# 20 \xb0"
                  "C\nx_mm\n1\n",
                  "data.csv")
            .rows() == 1);
  const CsvData data = parse_csv(
      "name\nPr\xc3\xbc"
      "f\n\xed\x9f\xbf\n\xe2\x82\xac\n\xf4\x8f\xbf\xbf\n",
      "data.csv");
  CHECK(data.rows() == 4);
}

TEST_CASE("a missing CSV file is wrong input, not a failed output") {
  try {
    read_csv("no/such.csv");
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    CHECK_THAT(error.what(), Catch::StartsWith("no/such.csv: cannot be opened: No such file"));
  }
}
