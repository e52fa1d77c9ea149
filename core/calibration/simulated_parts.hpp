#pragma once
#include "core/calibration/simulated_procedure.hpp"

/// The stages of calibrate() that have files of their own. Internal to core/calibration.
namespace asperity {

/// Seeds of the second route's meshes start so far above the design's first.
inline constexpr std::uint64_t kRefinementSeeds = 500;

/// Strengths and elastic microparameters together.
ParameterSet parameter_set(const ElasticPart& elastic, const std::vector<Factor>& factors,
                           const std::vector<double>& real);

/// The elastic compensation at given strengths, factor by factor.
ElasticPart compensate(const SimulatedCalibration& calibration, const std::vector<double>& real);

/// The best of a design's solutions, or its compromise.
const Solution& solution_of(const Analysis& analysis);

/// Real runs at the first route's point and then at the second's; Eq. (V2) chooses between them.
void refine(const SimulatedCalibration& calibration, const Simulator& simulate, SimulatedResult& result);

/// The chosen parameters on fresh meshes.
void verify_chosen(const SimulatedCalibration& calibration, const Simulator& simulate, SimulatedResult& result);

/// The trade-off's parameter sets on the same meshes.
void verify_trade_off(const SimulatedCalibration& calibration, const Simulator& simulate, SimulatedResult& result);

/// A property's values over cases, without those that have none.
std::vector<double> values_of(const std::vector<CaseResult>& results, const std::string& property);

}  // namespace asperity
