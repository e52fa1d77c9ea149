#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// Damerau-Levenshtein distance (optimal string alignment): insertions, deletions, substitutions, and swaps of
/// neighbours.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Distance of a mistyped word from a candidate: the edit distance, or 1 if the candidate is the word with more
/// appended after an underscore, as with a unit left out ("diameter", "diameter_mm").
std::size_t typing_distance(std::string_view word, std::string_view candidate);

/// The candidate at the smallest typing distance, of equals the shortest, then the first; empty if none is within a
/// third of the word's length (at least 1, at most 3).
std::string closest(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace asperity
