#pragma once
#include <cstdint>

#include "core/confrontation/confront.hpp"
#include "core/confrontation/confrontation_config.hpp"
#include "core/confrontation/virtual_test.hpp"

namespace asperity {

/// A model that a confrontation ends with.
enum class FinalModel {
  base,      ///< At its calibrated parameters.
  extension  ///< The best kept one, at its own; the base where nothing is kept.
};

/// The model as the run of one measured test. Throws Error(config) as configured() does.
RunConfig final_run(const ConfrontationConfig& config, const Confrontation& confrontation, const MeasuredTest& test,
                    FinalModel model, VirtualOutput output, std::uint64_t seed);

}  // namespace asperity
