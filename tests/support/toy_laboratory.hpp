#pragma once
#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/confrontation/evidence.hpp"

/// A linear world with known scatter, parameters and causes, from which evidence of any confrontation can be drawn.
namespace asperity::toy {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct World {
  int tests = 4, features = 8, parameters = 3, candidates = 8;
  int meshes = 16, common = 8, specimens = 6;
  double strength = 8.0;       ///< Length of a fingerprint at amplitude 1, in deviations of one run.
  double correlation = 0.4;    ///< Between features of a test.
  double common_share = 0.85;  ///< Of a run's scatter that common meshes take out of differences.
  std::uint64_t seed = 1;
};

/// What is hidden in a laboratory.
struct Hidden {
  VectorXd parameters, amplitudes;
  VectorXd outside;      ///< A change of the features that no candidate makes; may be empty.
  double scatter = 1.0;  ///< Of specimens, over that of runs.
};

struct Directions {
  MatrixXd jacobian, fingerprint;
};

inline MatrixXd normals(Index rows, Index columns, RandomStream& random) {
  MatrixXd m(rows, columns);
  for (Index i = 0; i < rows; ++i) {
    for (Index j = 0; j < columns; ++j) m(i, j) = random.normal();
  }
  return m;
}

inline Directions directions(const World& world) {
  RandomStream random(world.seed, "directions");
  const Index size = world.tests * world.features;
  Directions d{normals(size, world.parameters, random), normals(size, world.candidates, random)};
  d.jacobian *= 1.5 / std::sqrt(static_cast<double>(size)) * 3.0;
  for (Index k = 0; k < d.fingerprint.cols(); ++k) d.fingerprint.col(k) *= world.strength / d.fingerprint.col(k).norm();
  return d;
}

/// Scatter of runs: one common part of a test and one of each feature; deviations of 1.
inline MatrixXd scatter(const World& world, Index rows, RandomStream& random) {
  const MatrixXd common = normals(rows, 1, random), own = normals(rows, world.features, random);
  MatrixXd sum = std::sqrt(1.0 - world.correlation) * own;
  sum.colwise() += std::sqrt(world.correlation) * common.col(0);
  return sum;
}

inline const FeatureKind* kind(int number) {
  return &feature_kinds(ExperimentType::uniaxial)[static_cast<std::size_t>(number)];
}

inline TestEvidence test_evidence(const World& world, const Directions& d, const Hidden& hidden, int number,
                                  RandomStream& random) {
  const Index first = number * world.features, n = world.features;
  TestEvidence test;
  test.id = "T" + std::to_string(number);
  for (int f = 0; f < world.features; ++f) test.slots.push_back({kind(f), false, 0.01});
  test.instrument_sd = VectorXd::Zero(n);
  test.base = scatter(world, world.meshes, random);
  const auto on_common = [&](const VectorXd& change) {
    Samples runs =
        test.base.topRows(world.common) + std::sqrt(1.0 - world.common_share) * scatter(world, world.common, random);
    runs.rowwise() += change.segment(first, n).transpose();
    return runs;
  };
  for (Index p = 0; p < world.parameters; ++p) {
    test.low.push_back(on_common(-d.jacobian.col(p)));
    test.high.push_back(on_common(d.jacobian.col(p)));
  }
  for (Index k = 0; k < world.candidates; ++k) test.mechanism.push_back(on_common(0.6 * d.fingerprint.col(k)));
  VectorXd truth = d.jacobian * hidden.parameters + d.fingerprint * hidden.amplitudes;
  if (hidden.outside.size() > 0) truth += hidden.outside;
  test.measured = hidden.scatter * scatter(world, world.specimens, random);
  test.measured.rowwise() += truth.segment(first, n).transpose();
  return test;
}

/// Evidence of one laboratory; `draw` numbers it.
inline Evidence evidence(const World& world, const Hidden& hidden, std::uint64_t draw) {
  const Directions d = directions(world);
  RandomStream random(world.seed + 1000 * draw, "laboratory");
  Evidence evidence;
  for (int p = 0; p < world.parameters; ++p) evidence.parameters.push_back({"p" + std::to_string(p)});
  for (int k = 0; k < world.candidates; ++k) evidence.candidates.push_back({"m" + std::to_string(k), 0.6});
  for (int t = 0; t < world.tests; ++t) evidence.tests.push_back(test_evidence(world, d, hidden, t, random));
  return evidence;
}

inline Hidden nothing(const World& world) {
  return {VectorXd::Zero(world.parameters), VectorXd::Zero(world.candidates), {}, 1.0};
}

}  // namespace asperity::toy
