#pragma once
#include <span>
#include <vector>

#include "core/measurement/features.hpp"

namespace asperity {

/// What a mechanism does to one feature, on meshes that both series have; Eqs. (N2), (N3).
struct FeatureChange {
  const FeatureKind* kind = nullptr;
  int meshes = 0;                ///< On which both runs give a value.
  double base = 0, base_sd = 0;  ///< Mean without it and scatter over those meshes.
  double change = 0;             ///< Mean of the differences mesh by mesh.
  double change_error = 0;       ///< Its standard error; 0 for one mesh.
  double scatter_ratio = 0;      ///< Change over the scatter of a single mesh, Eq. (N3); 0 where that is 0.
};

/// Changes in the order of feature_kinds. `base` and `with` hold the features of one run each, mesh by mesh in the same
/// order; a feature that no mesh has in both stays with 0 meshes.
std::vector<FeatureChange> feature_changes(ExperimentType experiment, std::span<const std::vector<FeatureValue>> base,
                                           std::span<const std::vector<FeatureValue>> with);

/// The changes that tell most, the strongest first: on two meshes or more, beyond two standard errors, and not below
/// `least` of the feature's size; at most `count`.
std::vector<FeatureChange> telling_changes(const std::vector<FeatureChange>& changes, std::size_t count, double least);

}  // namespace asperity
