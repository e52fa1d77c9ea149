#include "core/confrontation/config_numbers.hpp"

#include <algorithm>
#include <cassert>

#include "core/config/bindings.hpp"

namespace asperity {
namespace {

const Binding* find_binding(const std::string& pointer) {
  const std::vector<Binding>& all = bindings();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Binding& b) { return b.pointer == pointer; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::optional<double> number_of(const RunConfig& config, const std::string& pointer) {
  const Binding* binding = find_binding(pointer);
  if (!binding) return std::nullopt;
  const nlohmann::json value = binding->write(config);
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

void set_number(RunConfig& config, const std::string& pointer, double value) {
  const Binding* binding = find_binding(pointer);
  assert(binding && "a pointer that the checks should have refused");
  binding->read(config, value);
}

}  // namespace asperity
