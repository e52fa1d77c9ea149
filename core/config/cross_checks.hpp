#pragma once
#include <set>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/config/run_config.hpp"

namespace asperity {

/// What the reader knows of a file beyond the values in RunConfig.
struct KeyNotes {
  std::set<std::string> given;   ///< Pointers of the keys that the file or an override sets.
  std::set<std::string> faulty;  ///< Pointers that have a fault already; checks that need them are left out.
};

/// Contradictions between keys that are each in range. Without notes, a key counts as given if it differs from its
/// default.
///
/// A time step is refused here only if it is above twice the estimate of Eq. (K3), hence certainly unstable. The exact
/// check, by power iteration on the mesh, comes after meshing and uses the same pointer, /integration/time_step_s.
std::vector<Fault> cross_check(const RunConfig& config, const KeyNotes& notes = {});

/// True if the pointers are equal or one lies inside the other.
bool pointers_overlap(std::string_view a, std::string_view b);

}  // namespace asperity
