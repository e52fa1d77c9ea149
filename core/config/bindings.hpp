#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/config/run_config.hpp"

namespace asperity {

/// One key of the run configuration: where it stands in JSON and which member of RunConfig it is.
struct Binding {
  std::string_view pointer;
  void (*read)(RunConfig& config, const nlohmann::json& value);  ///< The value has passed the schema.
  nlohmann::json (*write)(const RunConfig& config);              ///< null: an optional member that is unset.
};

/// Every key of the run configuration, in the order in which the effective configuration is written.
const std::vector<Binding>& bindings();

/// The value of a key as the user would write it; empty if it is unset or no key stands there.
std::string value_text(const RunConfig& config, std::string_view pointer);

/// True if the key's value differs from that of a default RunConfig.
bool differs_from_default(const RunConfig& config, std::string_view pointer);

}  // namespace asperity
