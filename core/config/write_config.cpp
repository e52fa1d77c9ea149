#include "core/config/write_config.hpp"

#include <nlohmann/json.hpp>

#include "core/base/sha256.hpp"
#include "core/config/applicability.hpp"
#include "core/config/bindings.hpp"

namespace asperity {

using nlohmann::ordered_json;

namespace {

/// A key without meaning that yet differs from its default is kept, so that cross_check can refuse it when read back.
bool is_written(const RunConfig& config, std::string_view pointer) {
  return applies(config, pointer) || differs_from_default(config, pointer);
}

}  // namespace

std::string effective_json(const RunConfig& config) {
  ordered_json document = ordered_json::object();
  for (const Binding& binding : bindings()) {
    const nlohmann::json value = binding.write(config);
    if (value.is_null() || !is_written(config, binding.pointer)) continue;
    document[ordered_json::json_pointer(std::string(binding.pointer))] = value;
  }
  return document.dump(2) + "\n";
}

std::string config_hash(const RunConfig& config) {
  RunConfig relevant = config;
  relevant.name.clear();
  relevant.description.clear();
  relevant.output.checkpoint_interval_s = OutputConfig().checkpoint_interval_s;
  relevant.output.measured_curve.reset();
  relevant.output.measured_name.reset();
  return sha256_hex(effective_json(relevant));
}

}  // namespace asperity
