#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

/// The bytes of a configuration file, read as `asperity run` reads them.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const RunConfig config = parse_run_config(std::string(fuzz::text_of(data, size)), "input.json");
    const RunConfig again = parse_run_config(effective_json(config), "again.json");
    fuzz::require(config_hash(again) == config_hash(config), "the effective configuration reads back to the same");
  } catch (const Error& error) {
    fuzz::require(error.kind() == ErrorKind::config && !error.faults().empty(), "a refusal names a fault of the input");
  }
  return 0;
}
