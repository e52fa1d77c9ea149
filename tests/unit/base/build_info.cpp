#include "core/base/build_info.hpp"

#include <catch2/catch.hpp>

using namespace asperity;

TEST_CASE("the executable knows what it was built from") {
  const BuildInfo& build = build_info();
  CHECK_FALSE(build.version.empty());
  CHECK((build.revision == "unknown" || build.revision.size() == 40));
  CHECK(build.compiler.find(' ') != std::string::npos);
  CHECK(build.flags.find("-ffp-contract=off") != std::string::npos);
}
