#pragma once
#include <optional>

#include "core/calibration/config_sections.hpp"
#include "core/calibration/published.hpp"

namespace asperity {

/// Reads the section; nothing where it is not there. Notes terms that a quadratic in so many factors does not have,
/// coefficients that are no numbers, and a solution of another length.
std::optional<Published> read_published(const Section& section, std::size_t factors);

}  // namespace asperity
