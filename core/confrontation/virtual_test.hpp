#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/confrontation/confrontation_config.hpp"

namespace asperity {

/// What a virtual test writes beside its tables.
enum class VirtualOutput {
  least,   ///< No frames and plots.
  as_base  ///< What the base asks for.
};

/// The run that repeats a measured test: the base of its experiment with the test's geometry, confining pressure or
/// normal stress and gauge, then the file's "set", then the test's own; mechanisms act as its specimens were prepared.
/// The closing rate stays the base's: a simulation is quasi-static at its own rate. Throws Error(config) with the
/// test's id before each pointer.
RunConfig virtual_test(const ConfrontationConfig& config, const MeasuredTest& test,
                       VirtualOutput output = VirtualOutput::least);

/// The run with parameters at `theta` (one for each of `parameters`), further mechanisms and a mesh. A parameter that
/// does not act in its experiment changes nothing. Throws Error(config).
RunConfig configured(const RunConfig& virtual_test, const std::vector<ConfrontationParameter>& parameters,
                     const std::vector<double>& theta, const std::vector<MechanismConfig>& mechanisms,
                     std::uint64_t seed);

/// The same; nothing where it is no legal run.
std::optional<RunConfig> configured_if_legal(const RunConfig& virtual_test,
                                             const std::vector<ConfrontationParameter>& parameters,
                                             const std::vector<double>& theta,
                                             const std::vector<MechanismConfig>& mechanisms, std::uint64_t seed);

/// Whether the mechanism of this id can be added to the run: it acts in its experiment and under its law.
bool can_act(const RunConfig& virtual_test, const std::string& mechanism);

/// The same of a measured test's run: it acts on specimens that were prepared so, too.
bool can_act(const MeasuredTest& test, const RunConfig& virtual_test, const std::string& mechanism);

}  // namespace asperity
