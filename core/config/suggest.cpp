#include "core/config/suggest.hpp"

#include <algorithm>

namespace asperity {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t cost = a[i - 1] == b[j - 1] ? 0 : 1;
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + cost});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::size_t typing_distance(std::string_view word, std::string_view candidate) {
  constexpr std::size_t kLongestKey = 100;
  if (word.size() > kLongestKey) return word.size();
  const bool unit_left_out = word.size() >= 3 && candidate.starts_with(std::string(word) + "_");
  return unit_left_out ? 1 : edit_distance(word, candidate);
}

std::string closest(std::string_view word, const std::vector<std::string>& candidates) {
  const std::size_t tolerance = std::clamp<std::size_t>(word.size() / 3, 1, 3);
  std::string best;
  std::size_t best_distance = tolerance + 1;
  for (const std::string& candidate : candidates) {
    const std::size_t distance = typing_distance(word, candidate);
    const bool nearer = distance < best_distance;
    const bool shorter = distance == best_distance && candidate.size() < best.size();
    if (nearer || shorter) best = candidate;
    best_distance = std::min(distance, best_distance);
  }
  return best;
}

}  // namespace asperity
