#include "core/config/write_config.hpp"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/config/applicability.hpp"
#include "core/config/bindings.hpp"

namespace asperity {

using nlohmann::ordered_json;

namespace {

__extension__ using Uint128 = unsigned __int128;

constexpr Uint128 make_uint128(std::uint64_t high, std::uint64_t low) { return (Uint128{high} << 64) | low; }

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
  return fnv1a_128(effective_json(relevant));
}

std::string fnv1a_128(std::string_view text) {
  constexpr Uint128 kPrime = make_uint128(0x0000000001000000, 0x000000000000013b);
  Uint128 hash = make_uint128(0x6c62272e07bb0142, 0x62b821756295c58d);
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * kPrime;
  std::array<char, 33> digits{};
  std::snprintf(digits.data(), digits.size(), "%016llx%016llx", static_cast<unsigned long long>(hash >> 64),
                static_cast<unsigned long long>(hash & ~std::uint64_t{0}));
  return digits.data();
}

}  // namespace asperity
