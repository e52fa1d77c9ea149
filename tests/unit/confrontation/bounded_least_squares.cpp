#include "core/confrontation/bounded_least_squares.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "tests/support/toy_laboratory.hpp"

using namespace asperity;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr double kFar = 1e6;

VectorXd all(double value) { return VectorXd::Constant(4, value); }

}  // namespace

TEST_CASE("bounded least squares: within wide bounds it solves the normal equations, ridge and all") {
  RandomStream random(2, "bounded");
  const MatrixXd columns = toy::normals(12, 4, random);
  const VectorXd residual = 5.0 * toy::normals(12, 1, random).col(0);
  const MatrixXd normal = columns.transpose() * columns + 0.3 * MatrixXd::Identity(4, 4);
  const VectorXd exact = normal.ldlt().solve(columns.transpose() * residual);
  CHECK((bounded_least_squares(columns, residual, all(-kFar), all(kFar), 0.3) - exact).norm() < 1e-8);
}

TEST_CASE("bounded least squares: at a bound the misfit falls outwards alone, and no point within fits better") {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    RandomStream random(seed, "bounded");
    const MatrixXd columns = toy::normals(12, 4, random);
    const VectorXd residual = 5.0 * toy::normals(12, 1, random).col(0);
    const VectorXd x = bounded_least_squares(columns, residual, all(-0.4), all(0.7), 0.0);
    const VectorXd downhill = columns.transpose() * (residual - columns * x);
    for (Index i = 0; i < 4; ++i) {
      CAPTURE(seed, i, x(i));
      if (x(i) == -0.4) CHECK(downhill(i) <= 1e-7);
      if (x(i) == 0.7) CHECK(downhill(i) >= -1e-7);
      if (x(i) > -0.4 && x(i) < 0.7) CHECK(std::abs(downhill(i)) < 1e-7);
    }
  }
}

TEST_CASE("bounded least squares: a column without effect stays at zero") {
  MatrixXd columns = MatrixXd::Zero(3, 2);
  columns.col(1) << 1.0, 2.0, 2.0;
  const VectorXd x = bounded_least_squares(columns, (VectorXd(3) << 9.0, 0.0, 0.0).finished(),
                                           VectorXd::Constant(2, -kFar), VectorXd::Constant(2, kFar), 0.0);
  CHECK(x(0) == 0.0);
  CHECK(x(1) == Approx(1.0));
}
