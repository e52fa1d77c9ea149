#include "core/confrontation/noise_model.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "core/base/random.hpp"

using namespace asperity;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

/// Two features with correlation 0.8 and deviations 1 and 3.
MatrixXd correlated(int runs, std::uint64_t seed) {
  RandomStream random(seed, "noise");
  MatrixXd rows(runs, 2);
  for (int r = 0; r < runs; ++r) {
    const double a = random.normal(), b = random.normal();
    rows(r, 0) = a;
    rows(r, 1) = 3.0 * (0.8 * a + 0.6 * b);
  }
  const Eigen::RowVectorXd mean = rows.colwise().mean();
  rows.rowwise() -= mean;
  return rows;
}

NoiseBlock block(MatrixXd rows, double floor = 0.0) { return {std::move(rows), {0, 1}, VectorXd::Constant(2, floor)}; }

}  // namespace

TEST_CASE("of many runs the covariance is the sample's") {
  const MatrixXd v = run_covariances({block(correlated(20000, 1))}, {0.0}).front();
  CHECK(v(0, 0) == Approx(1.0).epsilon(0.03));
  CHECK(v(1, 1) == Approx(9.0).epsilon(0.03));
  CHECK(v(0, 1) == Approx(2.4).epsilon(0.05));
}

TEST_CASE("correlations are drawn to zero by the least share, and more for few runs") {
  const MatrixXd many = run_covariances({block(correlated(20000, 1))}, {0.25}).front();
  CHECK(many(0, 1) / std::sqrt(many(0, 0) * many(1, 1)) == Approx(0.75 * 0.8).epsilon(0.02));
  CHECK(correlation_shrinkage(correlated(6, 2)) > correlation_shrinkage(correlated(600, 2)));
}

TEST_CASE("variances of one kind are drawn together, and of few runs more") {
  const auto spread = [](int runs) {
    std::vector<NoiseBlock> blocks;
    for (std::uint64_t s = 1; s <= 6; ++s) blocks.push_back(block(correlated(runs, s)));
    double raw_low = 1e9, raw_high = 0, low = 1e9, high = 0;
    for (const NoiseBlock& b : blocks) {
      const double v = b.rows.col(0).squaredNorm() / (runs - 1);
      raw_low = std::min(raw_low, v);
      raw_high = std::max(raw_high, v);
    }
    for (const MatrixXd& v : run_covariances(blocks, {})) {
      low = std::min(low, v(0, 0));
      high = std::max(high, v(0, 0));
    }
    return (high - low) / (raw_high - raw_low);
  };
  CHECK(spread(8) < 0.6);
}

TEST_CASE("a floor is the least deviation") {
  const MatrixXd v = run_covariances({block(correlated(50, 1), 2.0)}, {}).front();
  CHECK(v(0, 0) == Approx(4.0));
  CHECK(v(1, 1) > 4.0);
}
