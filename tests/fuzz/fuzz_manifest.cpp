#include "core/base/error.hpp"
#include "core/output/manifest.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

/// The bytes of manifest.json.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const Manifest manifest = parse_manifest(fuzz::text_of(data, size), "manifest.json");
    fuzz::require(manifest.threads >= 1, "a run has a thread");
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::output, "a refusal is an output error");
  }
  return 0;
}
