#pragma once
#include <cstdint>
#include <vector>

#include "core/confrontation/confront.hpp"
#include "core/confrontation/confrontation_config.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity {

/// A model that a confrontation ends with.
enum class FinalModel {
  base,      ///< At its calibrated parameters.
  extension  ///< The best kept one, at its own; the base where nothing is kept.
};

/// Values of all of the file's parameters in that model, transformed, within their limits.
std::vector<double> final_theta(const ConfrontationConfig& config, const Confrontation& confrontation,
                                FinalModel model);

/// The model as the run of one measured test. Throws Error(config) as configured() does.
RunConfig final_run(const ConfrontationConfig& config, const Confrontation& confrontation, const MeasuredTest& test,
                    FinalModel model, VirtualOutput output, std::uint64_t seed);

}  // namespace asperity
