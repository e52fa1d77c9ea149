#pragma once
#include <optional>

#include "core/base/vec2.hpp"
#include "core/calibration/elastic_compensation.hpp"

namespace asperity {

/// Particles and contacts to be tried.
struct ElasticTrial {
  Elasticity particle;
  ContactStiffness contacts;
};

/// The search for a target in compliances, Eq. (K32), in which the closed form is linear with slopes of one. What would
/// leave its bounds is held there, and the search starts anew with fewer unknowns.
class ElasticSearch {
 public:
  explicit ElasticSearch(const ElasticTask& task);

  const ElasticTrial& trial() const { return trial_; }
  ElasticUnknowns unknowns() const { return unknowns_; }

  /// Takes what the assembly showed at trial() (MPa) and moves on. False where nothing is left to try.
  bool advance(Elasticity assembly);

 private:
  /// Slopes of what the assembly shows over the unknowns, row by row.
  struct Slopes {
    Vec2 first, second;
    Vec2 times(Vec2 v) const { return {dot(first, v), dot(second, v)}; }
    Vec2 solve(Vec2 v) const;
  };

  Vec2 compliance(Elasticity material) const;
  Vec2 estimate() const;
  ElasticTrial trial_at(Vec2 x) const;
  void start(ElasticUnknowns unknowns, Vec2 x);
  void hold_poissons_ratio(double value);
  void hold_stiffness_ratio(double value);
  void propose(Vec2 x);
  void update_slopes(Vec2 y);

  ElasticBounds bounds_;
  RatioPolicy policy_;
  PlaneCondition plane_;
  double edge_mm_, hardening_, tolerance_;
  Elasticity target_;
  double greatest_modulus_;
  ElasticUnknowns unknowns_ = ElasticUnknowns::particle;
  ElasticTrial trial_;
  bool at_greatest_modulus_ = false;
  Vec2 x_;  ///< 1/E' of the particles; their nu'/E' or the contacts' share of compliance in shear. Eq. (K32)
  Slopes slopes_;
  std::optional<Vec2> last_x_, last_y_;
};

}  // namespace asperity
