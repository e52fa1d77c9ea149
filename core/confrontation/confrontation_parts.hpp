#pragma once
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/confrontation/confrontation_config.hpp"

/// The parts of read_confrontation() that have files of their own. Internal to core/confrontation. Each fills its
/// members of the configuration from a document that holds to the schema, and notes what is wrong.
namespace asperity::confrontation_parts {

/// "bases": what each experiment of the tests is simulated with.
void read_bases(ConfrontationConfig& config, std::vector<Fault>& faults);

/// "assumed": sizes that the measured file leaves out.
void read_assumed(ConfrontationConfig& config, std::vector<Fault>& faults);

/// "set", "tests", "hold_out": what is laid over the virtual tests, and which tests are kept back.
void read_sets(ConfrontationConfig& config, std::vector<Fault>& faults);
void read_split(ConfrontationConfig& config, std::vector<Fault>& faults);

/// The virtual test of each measured one, as far as they can be made.
std::vector<RunConfig> check_virtual_tests(const ConfrontationConfig& config, std::vector<Fault>& faults);

/// "parameters", "calibrate"; the tests give the references.
void read_parameters(ConfrontationConfig& config, const std::vector<RunConfig>& tests, std::vector<Fault>& faults);

/// "features" of the experiments of the tests.
void read_compared_features(ConfrontationConfig& config, std::vector<Fault>& faults);

/// "mechanisms", "without".
void read_candidates(ConfrontationConfig& config, const std::vector<RunConfig>& tests, std::vector<Fault>& faults);

/// "did you mean NEAR?", or nothing.
std::string near_hint(const std::string& word, const std::vector<std::string>& known);

/// "a, b, c", cut after a dozen.
std::string list_text(const std::vector<std::string>& words);

/// The experiments of the tests, each once, in the enumeration's order.
std::vector<ExperimentType> experiments_of(const MeasuredData& data);

}  // namespace asperity::confrontation_parts
