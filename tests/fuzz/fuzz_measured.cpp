#include "core/base/error.hpp"
#include "core/confrontation/read_measured.hpp"
#include "core/confrontation/test_features.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

/// The bytes of a measured file; the curves it names are not there.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const MeasuredData measured =
        parse_measured_data(std::string(fuzz::text_of(data, size)), "no_such_folder/input.json");
    for (const MeasuredTest& test : measured.tests) {
      const std::size_t specimens = specimens_of(test).size();
      fuzz::require(specimens > 0, "a test has a specimen");
      for (const TestFeature& f : features_of(test))
        fuzz::require(f.specimens.size() == specimens, "a feature has a place for each");
    }
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::config && !error.faults().empty(), "a refusal names a fault of the input");
  }
  return 0;
}
