#pragma once
#include <Eigen/Core>
#include <optional>

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
  using Vector = Eigen::Vector2d;

  Vector compliance(Elasticity material) const;
  Vector estimate() const;
  ElasticTrial trial_at(const Vector& x) const;
  void start(ElasticUnknowns unknowns, const Vector& x);
  void hold_poissons_ratio(double value);
  void hold_stiffness_ratio(double value);
  void propose(const Vector& x);
  void update_jacobian(const Vector& y);

  ElasticBounds bounds_;
  RatioPolicy policy_;
  PlaneCondition plane_;
  double edge_mm_, hardening_, tolerance_;
  Elasticity target_;
  double greatest_modulus_;
  ElasticUnknowns unknowns_ = ElasticUnknowns::particle;
  ElasticTrial trial_;
  bool at_greatest_modulus_ = false;
  Vector x_;
  Eigen::Matrix2d jacobian_;
  std::optional<Vector> last_x_, last_y_;
};

}  // namespace asperity
