#pragma once
#include <string>
#include <vector>

#include "app/compare/compared_run.hpp"

namespace asperity::app {

/// A key of the configurations that is not the same in all runs.
struct DifferingKey {
  std::string pointer;              ///< JSON pointer; "/mechanisms" as a whole.
  std::vector<std::string> values;  ///< One a run; "–" where the run has none.
};

/// What tells the runs apart, from their effective configurations: seed and mechanisms first, then in the
/// configuration's order. Names, descriptions and what is only output are left out.
std::vector<DifferingKey> differing_keys(const std::vector<ComparedRun>& runs);

/// What is special about run `index`: "seed 2, contact cohesion 4 MPa"; three keys at most, then how many more.
std::string label_of(const std::vector<DifferingKey>& keys, std::size_t index);

}  // namespace asperity::app
