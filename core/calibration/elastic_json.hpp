#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "core/calibration/elastic_alternatives.hpp"
#include "core/calibration/elastic_compensation.hpp"

namespace asperity {

/// The object "elastic" of calibration.json: rule, microparameters with the contacts' stiffness in both plane
/// conditions, what the assembly shows (mean over the seeds and scatter), every step, and the alternatives.
nlohmann::ordered_json elastic_json(const ElasticTask& task, const ElasticCompensation& found,
                                    const std::vector<ElasticAlternative>& alternatives);

/// The answer's contacts in a plane condition: its k_s / k_t, with k_t by the rule there; MPa/mm.
ContactStiffness answer_in_plane(const ElasticTask& task, const ElasticCompensation& found, PlaneCondition plane);

}  // namespace asperity
