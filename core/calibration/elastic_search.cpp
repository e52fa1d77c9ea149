#include "core/calibration/elastic_search.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity {
namespace {

/// Eq. (K27) for the task's window and law.
double hardening(const ElasticTask& task) {
  if (task.reading == ElasticReading::initial) return 1.0;
  const ContactConfig& c = task.config.contacts;
  const bool pressed = c.law.reading == LawReading::consistent || c.law.shear_peak == ShearPeak::coulomb;
  return shear_hardening(modulus_window(task.config, task.target.uniaxial_strength_mpa), c.cohesion_mpa,
                         pressed ? std::tan(c.friction_angle_deg * units::kRadPerDeg) : 0.0);
}

}  // namespace

ElasticSearch::ElasticSearch(const ElasticTask& task)
    : bounds_(task.bounds),
      policy_(task.ratio),
      plane_(task.config.experiment.plane),
      edge_mm_(task.config.particles.edge_mm),
      hardening_(hardening(task)),
      tolerance_(task.tolerance),
      target_{task.target.youngs_modulus_gpa * units::kMpaPerGpa, task.target.poissons_ratio},
      greatest_modulus_(bounds_.greatest_modulus_factor * target_.youngs_modulus) {
  trial_.contacts = stiffness_by_rule(task.stiffness, target_material(task), edge_mm_, plane_);
  start(ElasticUnknowns::particle, estimate());
}

/// 1/E' and nu'/E', 1/MPa.
ElasticSearch::Vector ElasticSearch::compliance(Elasticity material) const {
  const Elasticity e = plane_elasticity(material, plane_);
  return {1.0 / e.youngs_modulus, e.poissons_ratio / e.youngs_modulus};
}

/// What the particles need by the closed form with the present contacts; the first is not positive where those alone
/// are too compliant.
ElasticSearch::Vector ElasticSearch::estimate() const {
  const ContactStiffness hardened{trial_.contacts.k_t, trial_.contacts.ratio / hardening_};
  return compliance(estimate_particle(target_, hardened, edge_mm_, plane_));
}

ElasticTrial ElasticSearch::trial_at(const Vector& x) const {
  ElasticTrial next = trial_;
  const double in_plane = unknowns_ == ElasticUnknowns::particle
                              ? x[1] / x[0]
                              : plane_elasticity({1.0, trial_.particle.poissons_ratio}, plane_).poissons_ratio;
  next.particle = material_elasticity({1.0 / x[0], in_plane}, plane_);
  if (unknowns_ == ElasticUnknowns::ratio) {
    next.contacts.ratio = contact_share(edge_mm_) * hardening_ / (x[1] * trial_.contacts.k_t);
  }
  return next;
}

/// With the closed form's slopes.
void ElasticSearch::start(ElasticUnknowns unknowns, const Vector& x) {
  unknowns_ = unknowns;
  jacobian_.setIdentity();
  if (unknowns == ElasticUnknowns::ratio) {
    jacobian_ << 1.0, 1.0, plane_elasticity({1.0, trial_.particle.poissons_ratio}, plane_).poissons_ratio, 1.0;
  }
  last_x_.reset();
  propose(x);
}

void ElasticSearch::hold_poissons_ratio(double value) {
  trial_.particle.poissons_ratio = value;
  if (policy_ == RatioPolicy::fixed) return start(ElasticUnknowns::modulus, {estimate()[0], 0.0});
  const double ratio = hardening_ * estimate_stiffness_ratio(target_, value, trial_.contacts.k_t, edge_mm_, plane_);
  const double low = bounds_.least_stiffness_ratio, high = bounds_.greatest_stiffness_ratio;
  if (ratio <= 0.0 || ratio > high) return hold_stiffness_ratio(high);
  if (ratio < low) return hold_stiffness_ratio(low);
  trial_.contacts.ratio = ratio;
  start(ElasticUnknowns::ratio, {estimate()[0], contact_share(edge_mm_) * hardening_ / (ratio * trial_.contacts.k_t)});
}

void ElasticSearch::hold_stiffness_ratio(double value) {
  trial_.contacts.ratio = value;
  start(ElasticUnknowns::modulus, {estimate()[0], 0.0});
}

/// Makes x the next trial, or what its bounds leave of it.
void ElasticSearch::propose(const Vector& x) {
  const ElasticTrial next = trial_at(x);
  const bool real = x[0] > 0.0;
  if (unknowns_ == ElasticUnknowns::particle) {
    // In the plane, where the order of Poisson's ratios holds below -1 too.
    const double low = bounds_.least_poissons_ratio, high = bounds_.greatest_poissons_ratio;
    if (!real || x[1] / x[0] < plane_elasticity({1.0, low}, plane_).poissons_ratio) return hold_poissons_ratio(low);
    if (x[1] / x[0] > plane_elasticity({1.0, high}, plane_).poissons_ratio) return hold_poissons_ratio(high);
  }
  if (unknowns_ == ElasticUnknowns::ratio) {
    const double ratio = next.contacts.ratio;
    if (x[1] <= 0.0 || ratio > bounds_.greatest_stiffness_ratio)
      return hold_stiffness_ratio(bounds_.greatest_stiffness_ratio);
    if (ratio < bounds_.least_stiffness_ratio) return hold_stiffness_ratio(bounds_.least_stiffness_ratio);
  }
  x_ = x;
  trial_ = next;
  at_greatest_modulus_ = !real || next.particle.youngs_modulus > greatest_modulus_;
  if (at_greatest_modulus_) trial_.particle.youngs_modulus = greatest_modulus_;
}

/// Broyden's update: the least change that explains what the last step did.
void ElasticSearch::update_jacobian(const Vector& y) {
  if (last_x_) {
    const Vector dx = x_ - *last_x_;
    jacobian_ += (y - *last_y_ - jacobian_ * dx) * dx.transpose() / dx.squaredNorm();
  }
  last_x_ = x_;
  last_y_ = y;
}

bool ElasticSearch::advance(Elasticity assembly) {
  if (at_greatest_modulus_) return false;
  Vector y = compliance(assembly), wanted = compliance(target_);
  if (unknowns_ == ElasticUnknowns::modulus) {
    y[1] = wanted[1] = 0.0;
    if (std::abs(y[0] / wanted[0] - 1.0) < kStopShare * tolerance_) return false;
  }
  update_jacobian(y);
  const Vector x = x_ + jacobian_.partialPivLu().solve(wanted - y);
  if (!x.allFinite()) return false;
  propose(x);
  return true;
}

}  // namespace asperity
