#include "core/confrontation/scatter.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kOverallWeight = 10.0;  // degrees of freedom by which a kind's ratio is drawn to the kinds' median

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

/// Without what the instruments' zeros and the rows' noise add, which N10 counts by itself.
Ratio ratio_of(const Comparison& comparison, const ComparedTest& part, Index i, const MatrixXd& run) {
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
  const double own = comparison.own_sd(part.first + i);
  ratio.add(std::max(0.0, squares - (n - 1.0) * own * own) / run(i, i), n - 1.0);
  return ratio;
}

double usual_ratio(const std::map<int, Ratio>& kinds) {
  std::vector<double> values;
  for (const auto& [kind, ratio] : kinds) {
    if (ratio.freedom > 0.0) values.push_back(ratio.value());
  }
  return values.empty() ? 1.0 : median(std::move(values));
}

/// Eq. (N9). A kind's ratio over all tests, drawn to the kinds' median, which a few kinds that specimens scatter much
/// more than runs do not move; a test that stands for itself has its own.
VectorXd specimen_factors(const Comparison& comparison, const std::vector<MatrixXd>& run) {
  std::map<int, Ratio> kinds;
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const ComparedTest& part = comparison.tests[t];
    for (Index i = 0; i < run[t].rows(); ++i) {
      const Ratio ratio = ratio_of(comparison, part, i, run[t]);
      kinds[comparison.group[static_cast<std::size_t>(part.first + i)]].add(ratio.squares, ratio.freedom);
    }
  }
  const double usual = usual_ratio(kinds);
  VectorXd factors(comparison.data.size());
  for (std::size_t t = 0; t < comparison.tests.size(); ++t) {
    const ComparedTest& part = comparison.tests[t];
    for (Index i = 0; i < run[t].rows(); ++i) {
      const bool own = part.test->scatter == ScatterSource::specimens;
      Ratio ratio = own ? ratio_of(comparison, part, i, run[t])
                        : kinds.at(comparison.group[static_cast<std::size_t>(part.first + i)]);
      if (!own) ratio.add(kOverallWeight * usual, kOverallWeight);
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

/// Eq. (N20).
MatrixXd effects_covariance(const Comparison& comparison, const VectorXd& coded) {
  const Index size = comparison.data.size();
  MatrixXd covariance = MatrixXd::Zero(size, size);
  for (Index p = 0; p < coded.size(); ++p) {
    const MatrixXd& rows = comparison.jacobian_rows[static_cast<std::size_t>(p)];
    const double n = static_cast<double>(rows.rows());
    if (rows.rows() < 2) continue;
    for (const ComparedTest& part : comparison.tests) {
      const Index columns = static_cast<Index>(part.columns.size());
      const MatrixXd own = rows.middleCols(part.first, columns);
      covariance.block(part.first, part.first, columns, columns) +=
          coded(p) * coded(p) / (n * (n - 1.0)) * own.transpose() * own;
    }
  }
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
  scatter.effects = MatrixXd::Zero(comparison.data.size(), comparison.data.size());
  scatter.covariance = difference_covariance(comparison, scatter.run, scatter.specimen_factor);
  return scatter;
}

Scatter scatter_at(const Comparison& comparison, const VectorXd& coded, const NoiseOptions& options) {
  Scatter scatter = scatter_of(comparison, options);
  scatter.effects = effects_covariance(comparison, coded);
  scatter.covariance += scatter.effects;
  return scatter;
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
    const VectorXd mean = again.topRows(part.averaged).colwise().mean();
    again.rowwise() -= again.colwise().mean().eval();
    meshes.push_back(again);
    repetition.difference.segment(part.first, n) = data - mean;
    repetition.least_difference.segment(part.first, n) = least - mean;
  }
  for (Index i = 0; i < repetition.difference.size(); ++i)
    repetition.difference(i) += comparison.instrument_sd(i) * random.normal();
  repetition.covariance = difference_covariance(comparison, run_covariances(noise_blocks(comparison, meshes), options),
                                                scatter.specimen_factor);
  repetition.covariance += scatter.effects;
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
