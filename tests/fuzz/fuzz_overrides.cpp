#include "core/base/error.hpp"
#include "core/config/read_config.hpp"
#include "core/config/write_config.hpp"
#include "tests/fuzz/harness.hpp"

using namespace asperity;

namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t end; !text.empty(); text.remove_prefix(end)) {
    end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    if (end < text.size()) ++end;
  }
  return lines;
}

constexpr const char* kBase = R"({"experiment": {"type": "triaxial", "confining_pressure_mpa": 1}})";

}  // namespace

/// Arguments of `--set`, one a line, laid over a small configuration.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const RunConfig config = parse_run_config(kBase, "base.json", lines_of(fuzz::text_of(data, size)));
    const RunConfig again = parse_run_config(effective_json(config), "again.json");
    fuzz::require(config_hash(again) == config_hash(config), "the effective configuration reads back to the same");
  } catch (const Error& error) {
    const bool told = error.kind() == ErrorKind::config || error.kind() == ErrorKind::usage;
    fuzz::require(told && !error.faults().empty(), "a refusal names a fault of the arguments");
  }
  return 0;
}
