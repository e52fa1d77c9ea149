#include "core/measurement/telling_rows.hpp"

#include <algorithm>

namespace asperity {

std::vector<std::size_t> telling_rows(const std::vector<double>& values, std::size_t stretches) {
  std::vector<std::size_t> rows;
  if (values.empty()) return rows;
  rows.push_back(0);
  const std::size_t width = std::max<std::size_t>(1, values.size() / std::max<std::size_t>(1, stretches));
  for (std::size_t from = 0; from < values.size(); from += width) {
    const auto begin = values.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(std::min(from + width, values.size()));
    const auto [low, high] = std::minmax_element(begin, end);
    for (const auto at : {std::min(low, high), std::max(low, high)})
      rows.push_back(static_cast<std::size_t>(at - values.begin()));
  }
  rows.push_back(values.size() - 1);
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

}  // namespace asperity
