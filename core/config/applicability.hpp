#pragma once
#include <string_view>
#include <vector>

#include "core/config/run_config.hpp"

namespace asperity {

/// A key that has a meaning only for some values of another one. Given where it has none, it is a fault; the effective
/// configuration leaves it out there.
struct ConditionalKey {
  std::string_view pointer;
  std::string_view decided_by;  ///< Pointer of the key that decides, if need be together with /experiment/type.
  bool (*applies)(const RunConfig& config);
  std::string_view allowed;  ///< Where it has a meaning, in words.
  std::string_view hint;
};

/// All of them; a pointer may stand twice, then both conditions must hold.
const std::vector<ConditionalKey>& conditional_keys();

/// True if the key has a meaning in this configuration.
bool applies(const RunConfig& config, std::string_view pointer);

}  // namespace asperity
