#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/measurement/sample.hpp"

namespace asperity {

/// How the teeth of a joint failed; Eq. (E17).
enum class TeethFailure { none, some, the_only_one, one_after_the_other, together };

/// The enumerator's name, as in summary.json: "one_after_the_other".
std::string teeth_failure_name(TeethFailure failure);

/// One tooth through the whole test. Stresses are shares of the joint's shear stress, MPa on the plan area.
struct ToothHistory {
  std::optional<std::size_t> sheared_off;  ///< Sample at which it was, Eq. (E15).
  double largest_mpa = 0;                  ///< The most its leading flank bore until then, Eq. (E16)...
  double largest_at_mm = 0;                ///< ...and at which shear displacement.
  double share_with_first = 1;             ///< Of largest_mpa: what it bore when the first tooth to fail bore its own.
};

struct TeethVerdict {
  TeethFailure failure = TeethFailure::none;
  std::optional<std::size_t> first;  ///< Tooth that was sheared off first; unset: none was.
  std::vector<ToothHistory> teeth;
};

/// Whether the first `teeth` teeth were sheared off, and together or one after the other; by their leading flanks'
/// forces and by what of them is attached. `length_mm` is the joint's.
TeethVerdict judge_teeth(const std::vector<Sample>& samples, std::size_t teeth, double length_mm);

}  // namespace asperity
