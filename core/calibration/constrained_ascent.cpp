#include "core/calibration/constrained_ascent.hpp"

#include <functional>
#include <openturns/Cobyla.hxx>
#include <openturns/EvaluationImplementation.hxx>
#include <openturns/Function.hxx>
#include <openturns/OptimizationProblem.hxx>

#include "core/calibration/silence.hpp"

namespace asperity {
namespace {

constexpr double kFirstStep = 0.1;  // coded
constexpr double kLastStep = 1e-7;  // coded: far below any scatter of a parameter
constexpr int kMostEvaluations = 2000;

/// A function of the coded factors as OpenTURNS takes it.
class Evaluation : public OT::EvaluationImplementation {
 public:
  Evaluation(std::size_t factors, std::function<double(const std::vector<double>&)> function)
      : factors_(factors), function_(std::move(function)) {
    setInputDescription(OT::Description::BuildDefault(factors, "x"));
    setOutputDescription(OT::Description::BuildDefault(1, "y"));
  }
  Evaluation* clone() const override { return new Evaluation(*this); }
  OT::Point operator()(const OT::Point& x) const override {
    return OT::Point(1, function_(std::vector<double>(x.begin(), x.end())));
  }
  OT::UnsignedInteger getInputDimension() const override { return factors_; }
  OT::UnsignedInteger getOutputDimension() const override { return 1; }

 private:
  std::size_t factors_;
  std::function<double(const std::vector<double>&)> function_;
};

OT::Function function_of(std::size_t factors, std::function<double(const std::vector<double>&)> function) {
  return OT::Function(Evaluation(factors, std::move(function)));
}

void constrain(OT::OptimizationProblem& problem, const SearchRegion& region, std::size_t factors) {
  if (region.shape == RegionShape::cube) {
    problem.setBounds(OT::Interval(OT::Point(factors, -region.alpha), OT::Point(factors, region.alpha)));
    return;
  }
  problem.setInequalityConstraint(function_of(factors, [alpha = region.alpha](const std::vector<double>& x) {
    double left = alpha * alpha;
    for (double v : x) left -= v * v;
    return left;
  }));
}

}  // namespace

std::vector<double> climb(const ResponseSystem& system, const SearchRegion& region, const std::vector<double>& start,
                          const DesirabilityOptions& options) {
  const std::size_t factors = system.factors();
  const auto height = [&](const std::vector<double>& x) { return merit(system, x, options); };
  OT::OptimizationProblem problem(function_of(factors, [&](const std::vector<double>& x) { return -height(x); }));
  constrain(problem, region, factors);
  OT::Cobyla solver(problem, kFirstStep);
  OT::Point first(factors);
  std::copy(start.begin(), start.end(), first.begin());
  solver.setStartingPoint(first);
  solver.setMaximumEvaluationNumber(kMostEvaluations);
  solver.setMaximumAbsoluteError(kLastStep);
  solver.setIgnoreFailure(true);  // out of evaluations is as good as done: the result is compared with the start
  const Silence silence;
  solver.run();
  const OT::Point end = solver.getResult().getOptimalPoint();
  std::vector<double> x = drawn_in(region, std::vector<double>(end.begin(), end.end()));
  return height(x) >= height(start) ? x : start;
}

}  // namespace asperity
