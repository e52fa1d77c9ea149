#include <catch2/catch.hpp>

#include "core/config/suggest.hpp"

using namespace asperity;

TEST_CASE("edit distance counts insertions, deletions, substitutions and swaps") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("", "ab") == 2);
  CHECK(edit_distance("edge", "edge") == 0);
  CHECK(edit_distance("edge", "edges") == 1);
  CHECK(edit_distance("edge", "ege") == 1);
  CHECK(edit_distance("edge", "edgy") == 1);
  CHECK(edit_distance("diametre", "diameter") == 1);  // one swap; two substitutions without it
  CHECK(edit_distance("kitten", "sitting") == 3);
}

TEST_CASE("the closest word is the nearest one that can be meant") {
  const std::vector<std::string> words{"width_mm", "height_mm", "diameter_mm"};
  CHECK(closest("diametre_mm", words) == "diameter_mm");
  CHECK(closest("hieght_mm", words) == "height_mm");
  CHECK(closest("diameter", words) == "diameter_mm");  // the unit left out: distance 3, yet meant
  CHECK(closest("edge", {"edge_deviation_mm", "edge_mm"}) == "edge_mm");
  CHECK(closest("bat", {"cat", "bad"}) == "cat");
  CHECK(closest("colour", words).empty());
  CHECK(closest("x", words).empty());
  CHECK(closest(std::string(100000, 'x'), words).empty());
}
