#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/error.hpp"
#include "core/calibration/design.hpp"
#include "core/config/schema_lookup.hpp"

namespace asperity {
namespace {

constexpr std::size_t kMostFactors = 10;  // 2^10 corners, each of four runs, are beyond what anybody would wait for

class Faults {
 public:
  void add(const std::string& key, const std::string& what, double value, const std::string& allowed) {
    list.push_back({place + key, what, number_text(value), allowed, ""});
  }
  std::string place;
  std::vector<Fault> list;
};

void check_step(const Factor& factor, Faults& faults) {
  const bool logarithmic = factor.scale == FactorScale::logarithmic;
  const double least = logarithmic ? 1.0 : 0.0;
  if (!std::isfinite(factor.step) || !(factor.step > least)) {
    faults.add("/step", logarithmic ? "is no ratio" : "is no step", factor.step, logarithmic ? "above 1" : "above 0");
  }
  if (!std::isfinite(factor.centre) || (logarithmic && !(factor.centre > 0.0))) {
    faults.add("/centre", "is no centre", factor.centre, logarithmic ? "above 0" : "a number");
  }
}

void check_limits(const Factor& factor, double alpha, Faults& faults) {
  if (factor.lower && factor.upper && !(*factor.lower < *factor.upper)) {
    faults.add("/lower", "is not below the upper limit", *factor.lower, "below " + number_text(*factor.upper));
    return;
  }
  const double low = decode(factor, -alpha), high = decode(factor, alpha);
  if (factor.lower && low < *factor.lower) {
    faults.add("/step", "puts the lower star point beyond the limit, at", low,
               number_text(*factor.lower) + " and above " + factor.unit);
  }
  if (factor.upper && high > *factor.upper) {
    faults.add("/step", "puts the upper star point beyond the limit, at", high,
               number_text(*factor.upper) + " and below " + factor.unit);
  }
}

}  // namespace

void check_design(const Design& design) {
  Faults faults;
  const std::vector<Factor>& factors = design.factors;
  if (factors.empty() || factors.size() > kMostFactors) {
    faults.place = "/factors";
    faults.add("", "has the wrong number of factors", static_cast<double>(factors.size()), "1 to 10");
  }
  for (std::size_t j = 0; j < factors.size(); ++j) {
    faults.place = "/factors/" + std::to_string(j);
    const std::size_t before = faults.list.size();
    check_step(factors[j], faults);
    if (faults.list.size() == before) check_limits(factors[j], design.alpha, faults);
    const bool twice = std::any_of(factors.begin(), factors.begin() + static_cast<std::ptrdiff_t>(j),
                                   [&](const Factor& other) { return other.pointer == factors[j].pointer; });
    if (twice) faults.list.push_back({faults.place + "/pointer", "names a factor twice", factors[j].pointer, "", ""});
  }
  if (!faults.list.empty()) throw Error(ErrorKind::config, faults.list);
}

}  // namespace asperity
