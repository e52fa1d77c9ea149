#include "core/confrontation/fingerprint.hpp"

#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

/// 0 for fewer than two.
double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  const double mean = mean_of(values);
  double square = 0.0;
  for (const double v : values) square += (v - mean) * (v - mean);
  return std::sqrt(square / static_cast<double>(values.size() - 1));
}

FeatureChange change_of(const FeatureKind& kind, const std::vector<double>& base,
                        const std::vector<double>& differences) {
  FeatureChange c;
  c.kind = &kind;
  c.meshes = static_cast<int>(base.size());
  if (base.empty()) return c;
  c.base = mean_of(base);
  c.base_sd = deviation_of(base);
  c.change = mean_of(differences);
  c.change_error = deviation_of(differences) / std::sqrt(static_cast<double>(base.size()));
  const double scatter = std::hypot(c.base_sd, deviation_of(differences));
  c.scatter_ratio = scatter > 0.0 ? c.change / scatter : 0.0;
  return c;
}

}  // namespace

std::vector<FeatureChange> feature_changes(ExperimentType experiment, std::span<const std::vector<FeatureValue>> base,
                                           std::span<const std::vector<FeatureValue>> with) {
  std::vector<FeatureChange> changes;
  const std::span<const FeatureKind> kinds = feature_kinds(experiment);
  const std::size_t meshes = std::min(base.size(), with.size());
  for (std::size_t k = 0; k < kinds.size(); ++k) {
    std::vector<double> before, differences;
    for (std::size_t m = 0; m < meshes; ++m) {
      const std::optional<double>&b = base[m][k].value, &w = with[m][k].value;
      if (!b || !w) continue;
      before.push_back(*b);
      differences.push_back(*w - *b);
    }
    changes.push_back(change_of(kinds[k], before, differences));
  }
  return changes;
}

std::vector<FeatureChange> telling_changes(const std::vector<FeatureChange>& changes, std::size_t count, double least) {
  std::vector<FeatureChange> told;
  for (const FeatureChange& c : changes) {
    const bool sure = c.meshes >= 2 && std::abs(c.change) > 2.0 * c.change_error;
    const double size = std::max(std::abs(c.base), std::abs(c.base + c.change));
    if (sure && c.change != 0.0 && std::abs(c.change) >= least * size) told.push_back(c);
  }
  const auto stronger = [](const FeatureChange& a, const FeatureChange& b) {
    return std::abs(a.scatter_ratio) > std::abs(b.scatter_ratio);
  };
  std::stable_sort(told.begin(), told.end(), stronger);
  if (told.size() > count) told.resize(count);
  return told;
}

}  // namespace asperity
