#pragma once
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/base/random.hpp"
#include "core/calibration/analysis.hpp"
#include "core/calibration/data_calibration.hpp"

/// Designs and responses that the tests of the calibration share.
namespace asperity::examples {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

inline const std::filesystem::path kTable4 =
    std::filesystem::path(ASPERITY_SOURCE_DIR) / "configs/calibration/paper_table4.json";

/// Factors of centre 10, 20, ... and step 1, 2, ...
inline std::vector<Factor> plain_factors(std::size_t k) {
  std::vector<Factor> factors;
  for (std::size_t j = 0; j < k; ++j) {
    Factor factor;
    factor.name = "x" + std::to_string(j + 1);
    factor.pointer = "/factor/" + std::to_string(j + 1);
    factor.centre = 10.0 * static_cast<double>(j + 1);
    factor.step = static_cast<double>(j + 1);
    factors.push_back(factor);
  }
  return factors;
}

inline Design plain_design(std::size_t k) { return central_composite(plain_factors(k), StarDistance::rotatable); }

/// The function at every design point, plus scatter of this relative standard deviation.
inline Response response_of(const std::string& name, const Design& design, const Function& function,
                            double relative_scatter = 0.0, std::uint64_t seed = 1) {
  RandomStream random(seed, name);
  Response response{name, {}, Transform::none};
  for (const Point& x : design.coded) {
    response.values.push_back(function(x) * (1.0 + relative_scatter * random.normal()));
  }
  return response;
}

inline Target target_of(const std::string& name, double value) {
  Target target;
  target.property = name;
  target.value = value;
  return target;
}

/// Models without elimination, so that exact data come back.
inline ResponseSystem full_system(const Design& design, const std::vector<Response>& responses,
                                  const std::vector<double>& targets) {
  std::vector<ResponseModel> models;
  std::vector<Target> wanted;
  for (std::size_t r = 0; r < responses.size(); ++r) {
    models.push_back(fit_response(design, responses[r], {1.0, Hierarchy::hierarchical}));
    wanted.push_back(target_of(responses[r].name, targets[r]));
  }
  return {models, wanted};
}

}  // namespace asperity::examples
