#include "core/confrontation/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOverallWeight = 10.0;  // degrees of freedom by which a kind's ratio is drawn to that of all

std::vector<NoiseBlock> noise_blocks(const Comparison& comparison, const std::vector<MatrixXd>& meshes) {
  std::vector<NoiseBlock> blocks;
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const ComparedTest& part = comparison.tests[t];
    NoiseBlock block{meshes[t], {}, VectorXd(meshes[t].cols())};
    for (Index i = 0; i < meshes[t].cols(); ++i) {
      const auto at = static_cast<std::size_t>(part.first + i);
      block.group.push_back(comparison.group[at]);
      block.floor(i) = comparison.slots[at]->floor_sd;
    }
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<MatrixXd> meshes_of(const Comparison& comparison) {
  std::vector<MatrixXd> meshes;
  for (const ComparedTest& part : comparison.tests) meshes.push_back(part.meshes);
  return meshes;
}

/// Squares of specimens' deviations over what runs scatter, with their degrees of freedom.
struct Ratio {
  double squares = 0, freedom = 0;
  double value() const { return freedom > 0.0 ? squares / freedom : 1.0; }
  void add(double s, double f) {
    squares += s;
    freedom += f;
  }
};

Ratio ratio_of(const ComparedTest& part, Index i, const MatrixXd& run) {
  Ratio ratio;
  const VectorXd column = part.test->measured.col(part.columns[static_cast<std::size_t>(i)]);
  double sum = 0.0, n = 0.0;
  for (const double v : column) {
    if (!std::isfinite(v)) continue;
    sum += v;
    n += 1.0;
  }
  if (n < 2.0) return ratio;
  double squares = 0.0;
  for (const double v : column) {
    if (std::isfinite(v)) squares += (v - sum / n) * (v - sum / n);
  }
  ratio.add(squares / run(i, i), n - 1.0);
  return ratio;
}

/// Eq. (N9). A kind's ratio over all tests, drawn to that of all kinds; a test that stands for itself has its own.
VectorXd specimen_factors(const Comparison& comparison, const std::vector<MatrixXd>& run) {
  std::map<int, Ratio> kinds;
  Ratio all;
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const ComparedTest& part = comparison.tests[t];
    for (Index i = 0; i < run[t].rows(); ++i) {
      const Ratio ratio = ratio_of(part, i, run[t]);
      kinds[comparison.group[static_cast<std::size_t>(part.first + i)]].add(ratio.squares, ratio.freedom);
      all.add(ratio.squares, ratio.freedom);
    }
  }
  VectorXd factors(comparison.data.size());
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const ComparedTest& part = comparison.tests[t];
    for (Index i = 0; i < run[t].rows(); ++i) {
      const bool own = part.test->scatter == ScatterSource::specimens;
      Ratio ratio =
          own ? ratio_of(part, i, run[t]) : kinds.at(comparison.group[static_cast<std::size_t>(part.first + i)]);
      if (!own) ratio.add(kOverallWeight * all.value(), kOverallWeight);
      factors(part.first + i) = std::sqrt(std::max(1.0, ratio.value()));
    }
  }
  return factors;
}

/// Eq. (N10).
MatrixXd difference_covariance(const Comparison& comparison, const std::vector<MatrixXd>& run, const VectorXd& factor) {
  const Index size = comparison.data.size();
  MatrixXd covariance = MatrixXd::Zero(size, size);
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const Index first = comparison.tests[t].first, n = run[t].rows();
    const VectorXd specimens = factor.segment(first, n).array() / comparison.specimens.segment(first, n).array().sqrt();
    const VectorXd meshes = comparison.meshes.segment(first, n).array().rsqrt();
    covariance.block(first, first, n, n) = specimens.asDiagonal() * run[t] * specimens.asDiagonal();
    covariance.block(first, first, n, n) += meshes.asDiagonal() * run[t] * meshes.asDiagonal();
  }
  covariance.diagonal() += comparison.instrument_sd.array().square().matrix();
  return covariance;
}

/// Mean of as many rows drawn with replacement.
VectorXd drawn_mean(const MatrixXd& rows, Index count, RandomStream& random) {
  VectorXd sum = VectorXd::Zero(rows.cols());
  for (Index i = 0; i < count; ++i)
    sum += rows.row(static_cast<Index>(random.below(static_cast<std::uint64_t>(rows.rows())))).transpose();
  return sum / static_cast<double>(count);
}

MatrixXd drawn_rows(const MatrixXd& rows, RandomStream& random) {
  MatrixXd drawn(rows.rows(), rows.cols());
  for (Index i = 0; i < rows.rows(); ++i)
    drawn.row(i) = rows.row(static_cast<Index>(random.below(static_cast<std::uint64_t>(rows.rows()))));
  return drawn;
}

/// The runs' rows with the standard deviations that are believed.
MatrixXd believed_rows(const MatrixXd& rows, const MatrixXd& run) {
  MatrixXd scaled = rows;
  for (Index i = 0; i < rows.cols(); ++i) {
    const double sd = std::sqrt(rows.col(i).squaredNorm() / static_cast<double>(rows.rows()));
    if (sd > 0.0) scaled.col(i) *= std::sqrt(run(i, i)) / sd;
  }
  return scaled;
}

}  // namespace

Scatter scatter_of(const Comparison& comparison, const NoiseOptions& options) {
  Scatter scatter;
  scatter.run = run_covariances(noise_blocks(comparison, meshes_of(comparison)), options);
  scatter.specimen_factor = specimen_factors(comparison, scatter.run);
  scatter.covariance = difference_covariance(comparison, scatter.run, scatter.specimen_factor);
  return scatter;
}

MatrixXd covariance_from(const Comparison& comparison, const std::vector<MatrixXd>& meshes,
                         const VectorXd& specimen_factor, const NoiseOptions& options) {
  return difference_covariance(comparison, run_covariances(noise_blocks(comparison, meshes), options), specimen_factor);
}

Repetition repeat(const Comparison& comparison, const Scatter& scatter, const NoiseOptions& options,
                  RandomStream& random) {
  Repetition repetition{VectorXd(comparison.data.size()), VectorXd(comparison.data.size()), {}};
  std::vector<MatrixXd> meshes;
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const ComparedTest& part = comparison.tests[t];
    const Index n = part.meshes.cols();
    MatrixXd rows(part.meshes.rows(), 2 * n);
    rows << believed_rows(part.meshes, scatter.run[t]), part.meshes;
    const auto specimens = static_cast<Index>(comparison.specimens.segment(part.first, n).maxCoeff());
    const VectorXd fewer =
        (static_cast<double>(specimens) / comparison.specimens.segment(part.first, n).array()).sqrt();
    const VectorXd both = drawn_mean(rows, specimens, random);
    const VectorXd least = both.tail(n).array() * fewer.array();
    const VectorXd data = both.head(n).array() * fewer.array() * scatter.specimen_factor.segment(part.first, n).array();
    MatrixXd again = drawn_rows(part.meshes, random);
    const VectorXd mean = again.colwise().mean();
    again.rowwise() -= mean.transpose();
    meshes.push_back(again);
    repetition.difference.segment(part.first, n) = data - mean;
    repetition.least_difference.segment(part.first, n) = least - mean;
  }
  for (Index i = 0; i < repetition.difference.size(); ++i)
    repetition.difference(i) += comparison.instrument_sd(i) * random.normal();
  repetition.covariance = covariance_from(comparison, meshes, scatter.specimen_factor, options);
  return repetition;
}

VectorXd drawn_error(const Comparison& comparison, const MatrixXd& rows, RandomStream& random) {
  VectorXd error = VectorXd::Zero(comparison.data.size());
  if (rows.rows() < 2) return error;
  const double n = static_cast<double>(rows.rows());
  for (const ComparedTest& part : comparison.tests) {
    const Index size = static_cast<Index>(part.columns.size());
    error.segment(part.first, size) =
        std::sqrt(n / (n - 1.0)) * drawn_mean(rows.middleCols(part.first, size), rows.rows(), random);
  }
  return error;
}

}  // namespace asperity
