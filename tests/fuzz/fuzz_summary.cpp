#include "core/base/error.hpp"
#include "core/output/summary.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

/// The bytes of summary.json.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Summary summary = parse_summary(fuzz::text_of(data, size), "summary.json");
    fuzz::require(summary.results.is_object(), "results are an object");  // they are printed key by key
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::output, "a refusal is an output error");
  }
  return 0;
}
