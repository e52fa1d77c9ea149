#pragma once
#include <string>
#include <vector>

#include "core/calibration/elastic_compensation.hpp"

namespace asperity {

/// Another way to choose the elastic microparameters, and what the assembly shows with it.
struct ElasticAlternative {
  std::string name;
  double edge_mm = 0;
  ElasticStep step;
  bool reached = false;
};

/// What the report shows beside the answer: Eqs 12, 13 with the target's own E and nu for the particles, and
/// with E_p and nu_p compensated but their ratio kept, both at the task's edge and at half of it; and the other
/// stiffness rule compensated in full at the task's edge. Read on the task's first seed alone.
std::vector<ElasticAlternative> elastic_alternatives(const ElasticTask& task);

}  // namespace asperity
