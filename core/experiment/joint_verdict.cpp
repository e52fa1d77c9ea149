#include "core/experiment/joint_verdict.hpp"

#include <algorithm>

namespace asperity {
namespace {

/// A tooth is sheared off once less than this share of it hangs together with the lower half.
constexpr double kShearedOff = 0.5;
/// Forces on a flank are means over this many samples to either side: single ones are of an instant.
constexpr std::size_t kBeside = 2;
/// A tooth that bears less than this share of its own most when the first one fails, has yet to be loaded.
constexpr double kLoaded = 0.5;

std::optional<std::size_t> sheared_off_at(const std::vector<Sample>& samples, std::size_t tooth) {
  const auto found = std::find_if(samples.begin(), samples.end(),
                                  [&](const Sample& s) { return s.joint.teeth[tooth].attached_share < kShearedOff; });
  if (found == samples.end()) return std::nullopt;
  return static_cast<std::size_t>(found - samples.begin());
}

/// Eq. (E16): what the leading flank bears around a sample, N per mm of thickness.
double leading_force(const std::vector<Sample>& samples, std::size_t tooth, std::size_t at) {
  const std::size_t from = at < kBeside ? 0 : at - kBeside, to = std::min(at + kBeside, samples.size() - 1);
  double sum = 0.0;
  for (std::size_t i = from; i <= to; ++i) sum += samples[i].joint.teeth[tooth].leading.x;
  return sum / static_cast<double>(to - from + 1);
}

/// The sample at which the leading flank bears most, up to the tooth's failure.
std::size_t most_loaded(const std::vector<Sample>& samples, std::size_t tooth, std::size_t last) {
  std::size_t most = 0;
  double largest = leading_force(samples, tooth, 0);
  for (std::size_t i = 1; i <= last; ++i) {
    const double force = leading_force(samples, tooth, i);
    if (force <= largest) continue;
    largest = force;
    most = i;
  }
  return most;
}

std::optional<std::size_t> first_to_fail(const std::vector<ToothHistory>& teeth) {
  std::optional<std::size_t> first;
  for (std::size_t k = 0; k < teeth.size(); ++k) {
    if (!teeth[k].sheared_off) continue;
    const bool earlier = !first || *teeth[k].sheared_off < *teeth[*first].sheared_off;
    const bool with_more = first && *teeth[k].sheared_off == *teeth[*first].sheared_off &&
                           teeth[k].largest_mpa > teeth[*first].largest_mpa;
    if (earlier || with_more) first = k;
  }
  return first;
}

/// Eq. (E17).
TeethFailure failure_of(const std::vector<ToothHistory>& teeth) {
  const auto off = [](const ToothHistory& t) { return t.sheared_off.has_value(); };
  if (std::none_of(teeth.begin(), teeth.end(), off)) return TeethFailure::none;
  if (!std::all_of(teeth.begin(), teeth.end(), off)) return TeethFailure::some;
  if (teeth.size() == 1) return TeethFailure::the_only_one;
  const bool staggered =
      std::any_of(teeth.begin(), teeth.end(), [](const ToothHistory& t) { return t.share_with_first < kLoaded; });
  return staggered ? TeethFailure::one_after_the_other : TeethFailure::together;
}

}  // namespace

std::string teeth_failure_name(TeethFailure failure) {
  switch (failure) {
    case TeethFailure::none:
      return "none";
    case TeethFailure::some:
      return "some";
    case TeethFailure::the_only_one:
      return "the_only_one";
    case TeethFailure::one_after_the_other:
      return "one_after_the_other";
    case TeethFailure::together:
      return "together";
  }
  return "";
}

TeethVerdict judge_teeth(const std::vector<Sample>& samples, std::size_t teeth, double length_mm) {
  TeethVerdict verdict;
  std::vector<std::size_t> most(teeth);
  for (std::size_t k = 0; k < teeth; ++k) {
    ToothHistory tooth;
    tooth.sheared_off = sheared_off_at(samples, k);
    most[k] = most_loaded(samples, k, tooth.sheared_off.value_or(samples.size() - 1));
    tooth.largest_mpa = leading_force(samples, k, most[k]) / length_mm;
    tooth.largest_at_mm = samples[most[k]].closure_mm;
    verdict.teeth.push_back(tooth);
  }
  verdict.first = first_to_fail(verdict.teeth);
  for (std::size_t k = 0; verdict.first && k < teeth; ++k) {
    const double then = leading_force(samples, k, most[*verdict.first]) / length_mm;
    ToothHistory& tooth = verdict.teeth[k];
    tooth.share_with_first = tooth.largest_mpa > 0.0 ? then / tooth.largest_mpa : 0.0;
  }
  verdict.failure = failure_of(verdict.teeth);
  return verdict;
}

}  // namespace asperity
