#include "core/confrontation/extension_runs.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Those of the mechanisms that act in this test.
std::vector<MechanismAmplitude> acting(const ConfrontationTask& task, const Evidence& evidence, std::size_t test,
                                       const ExtensionPoint& point) {
  std::vector<MechanismAmplitude> mechanisms;
  for (std::size_t i = 0; i < point.causes.size(); ++i) {
    const auto k = static_cast<std::size_t>(point.causes[i]);
    const double amplitude = point.amplitude(static_cast<Index>(i));
    if (amplitude != 0.0 && task.plan.candidate_acts[test][k])
      mechanisms.push_back({evidence.candidates[k].id, amplitude});
  }
  return mechanisms;
}

/// Of the finite ones.
double finite_mean(const VectorXd& values) {
  double sum = 0.0, count = 0.0;
  for (const double v : values) {
    if (!std::isfinite(v)) continue;
    sum += v;
    count += 1.0;
  }
  return sum / count;
}

/// One standard error along each axis of the fit's covariance, as a point of a run; towards the other side where an end
/// of a range cuts it shorter there.
std::vector<ExtensionPoint> displaced_points(const Evidence& evidence, const ExtensionPoint& at,
                                             const MatrixXd& covariance) {
  constexpr double kSmall = 1e-12;
  const Index parameters = at.coded.size();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(covariance);
  const auto displaced = [&](const VectorXd& by) {
    return point_of_run(evidence,
                        {at.causes, at.coded + by.head(parameters), at.amplitude + by.tail(at.amplitude.size())});
  };
  const auto distance = [&](const ExtensionPoint& p) {
    return (p.coded - at.coded).squaredNorm() + (p.amplitude - at.amplitude).squaredNorm();
  };
  std::vector<ExtensionPoint> points;
  for (Index i = 0; i < covariance.rows(); ++i) {
    const VectorXd by = std::sqrt(std::max(0.0, axes.eigenvalues()(i))) * axes.eigenvectors().col(i);
    const ExtensionPoint up = displaced(by), down = displaced(-by);
    const ExtensionPoint& farther = distance(up) >= distance(down) ? up : down;
    if (distance(farther) > kSmall) points.push_back(farther);
  }
  return points;
}

}  // namespace

ExtensionPoint point_of_run(const Evidence& evidence, ExtensionPoint point) {
  for (Index p = 0; p < point.coded.size(); ++p) {
    const CalibratedParameter& parameter = evidence.parameters[static_cast<std::size_t>(p)];
    point.coded(p) = std::clamp(point.coded(p), parameter.lower, parameter.upper);
  }
  for (std::size_t i = 0; i < point.causes.size(); ++i) {
    double& a = point.amplitude(static_cast<Index>(i));
    a = amplitude_of_run(evidence.candidates[static_cast<std::size_t>(point.causes[i])], a);
  }
  return point;
}

std::vector<VirtualSpecimen> extension_specimens(const ConfrontationTask& task, const Confrontation& state,
                                                 std::size_t test, const ExtensionPoint& point, Index meshes) {
  std::vector<VirtualSpecimen> specimens;
  for (Index row = 0; row < meshes; ++row) {
    specimens.push_back({test, state.centre + point.coded, acting(task, state.evidence, test, point),
                         mesh_seed(task.plan, state.evidence.tests[test], static_cast<std::size_t>(row))});
  }
  return specimens;
}

RunChange change_by_runs(const ConfrontationTask& task, const Confrontation& state, const Comparison& comparison,
                         const ExtensionPoint& point, std::size_t meshes, const std::string& stage,
                         const VectorXd& otherwise) {
  RunChange change{otherwise, MatrixXd::Zero(static_cast<Index>(meshes), otherwise.size())};
  for (const ComparedTest& part : comparison.tests) {
    const auto t = static_cast<std::size_t>(part.test - state.evidence.tests.data());
    const Index rows = std::min<Index>(static_cast<Index>(meshes), part.test->base.rows());
    const Samples runs = simulate_specimens(*part.test, extension_specimens(task, state, t, point, rows), stage,
                                            task.configure, task.features);
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const Index column = part.columns[i], at = part.first + static_cast<Index>(i);
      const VectorXd differences = runs.col(column) - part.test->base.col(column).head(rows);
      if (differences.array().isFinite().count() < 2) continue;
      change.told = true;
      change.mean(at) = finite_mean(differences);
      change.rows.col(at).head(rows) = centred(differences);
    }
  }
  return change;
}

std::string extension_stage(const Evidence& evidence, const std::vector<Index>& causes) {
  std::string name = "extension";
  for (const Index c : causes) {
    name += name == "extension" ? " " : " + ";
    name += evidence.candidates[static_cast<std::size_t>(c)].id;
  }
  return name;
}

FeaturePrediction predict_by_runs(const ConfrontationTask& task, const Confrontation& state, const HypothesisFit& fit) {
  const Comparison& kept_back = state.kept_back;
  const ExtensionPoint at = point_of_run(state.evidence, {fit.causes, fit.coded, fit.amplitude});
  const std::string stage = extension_stage(state.evidence, fit.causes) + " on kept-back tests";
  const VectorXd linear = predict_extension(kept_back, state.kept_back_scatter, fit).mean - kept_back.model;
  const VectorXd change = change_by_runs(task, state, kept_back, at, task.plan.fresh, stage, linear).mean;
  const VectorXd common = change_by_runs(task, state, kept_back, at, task.common, stage, change).mean;
  FeaturePrediction prediction{kept_back.model + change, state.kept_back_scatter.covariance};
  for (const ExtensionPoint& point : displaced_points(state.evidence, at, fit.covariance)) {
    const VectorXd moved = change_by_runs(task, state, kept_back, point, task.common, stage, common).mean - common;
    prediction.covariance += moved * moved.transpose();
  }
  return prediction;
}

}  // namespace asperity
