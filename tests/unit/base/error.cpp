#include "core/base/error.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

TEST_CASE("a fault is described with all it has") {
  CHECK(describe({"/experiment/diameter_mm", "must be above 0", "-5", "1 to 1000 mm", "check the sign"}) ==
        "/experiment/diameter_mm: must be above 0 (found -5; allowed: 1 to 1000 mm). Hint: check the sign");
}

TEST_CASE("a fault is described without what it has not") {
  CHECK(describe({"", "nothing to do", "", "", ""}) == "nothing to do");
  CHECK(describe({"a.csv:3", "is no number", "x", "", ""}) == "a.csv:3: is no number (found x)");
  CHECK(describe({"/name", "is missing", "", "a word", ""}) == "/name: is missing (allowed: a word)");
}

TEST_CASE("an error lists all its faults, one a line, and keeps its kind") {
  const Error error(ErrorKind::config, {{"/a", "one", "", "", ""}, {"/b", "two", "", "", ""}});
  CHECK(std::string(error.what()) == "/a: one\n/b: two");
  CHECK(error.faults().size() == 2);
  CHECK(error.kind() == ErrorKind::config);
}

TEST_CASE("an error of one sentence has no faults") {
  const Error error(ErrorKind::numerical, "a node's velocity is not finite");
  CHECK(std::string(error.what()) == "a node's velocity is not finite");
  CHECK(error.faults().empty());
}

TEST_CASE("kinds carry the documented exit codes") {
  CHECK(static_cast<int>(ErrorKind::unexpected) == 1);
  CHECK(static_cast<int>(ErrorKind::usage) == 2);
  CHECK(static_cast<int>(ErrorKind::config) == 3);
  CHECK(static_cast<int>(ErrorKind::numerical) == 4);
  CHECK(static_cast<int>(ErrorKind::output) == 5);
  CHECK(static_cast<int>(ErrorKind::tolerance) == 6);
}
