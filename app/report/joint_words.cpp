#include "app/report/joint_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/units.hpp"

namespace asperity::app {
namespace {

/// A flank that bears less than this share of the joint's normal force does not bear.
constexpr double kBears = 0.02;

double tangent(double angle_deg) { return std::tan(angle_deg * units::kRadPerDeg); }

std::size_t steepest_tooth(const JointNumbers& n) {
  return static_cast<std::size_t>(
      std::max_element(n.teeth.begin(), n.teeth.end(),
                       [](const ToothNumbers& a, const ToothNumbers& b) { return a.angle_deg < b.angle_deg; }) -
      n.teeth.begin());
}

std::string verdict(const JointNumbers& n) {
  if (n.teeth_failed == "none") return fmt::format("No tooth was sheared off up to {}.", mm(n.end_mm));
  const std::string loads = capital(unequal_loads(n)) + ".";
  if (n.teeth_failed == "one_after_the_other") return "The teeth failed one after the other. " + loads;
  if (n.teeth_failed == "together") return "The teeth failed together. " + loads;
  return fmt::format("Only some teeth were sheared off, {} first. {}", tooth_name(n, *n.first), loads);
}

std::string tooth_course(const JointNumbers& n, std::size_t k) {
  const ToothNumbers& t = n.teeth[k];
  return fmt::format("{}: its leading flank bore its most, {} of the shear stress, at {}; {}.",
                     capital(tooth_name(n, k)), mpa(t.most_mpa), mm(t.most_at_mm),
                     t.sheared_off_mm ? "sheared off at " + mm(*t.sheared_off_mm)
                                      : fmt::format("{:.0f} % of it is attached at the end", 100 * t.attached_at_end));
}

struct CurvePoint {
  double displacement = 0, dilation = 0, front = 0, rear = 0;
};

CurvePoint point_at(const CsvData& curves, double displacement) {
  const std::vector<double> u = curves.numbers("shear_displacement_mm");
  const auto found = std::lower_bound(u.begin(), u.end(), displacement);
  const std::size_t row = std::min(static_cast<std::size_t>(found - u.begin()), u.size() - 1);
  return {u[row], curves.numbers("dilation_mm")[row], curves.numbers("dilation_front_mm")[row],
          curves.numbers("dilation_rear_mm")[row]};
}

/// Rigid halves: the flatter flanks stay in touch as long as the rise is no more than u tan i of them.
std::string gap_of_flatter(const JointNumbers& n, std::size_t flat, const CurvePoint& p) {
  const double steep_angle = n.teeth[steepest_tooth(n)].angle_deg, flat_angle = n.teeth[flat].angle_deg;
  const double rigid = p.displacement * tangent(steep_angle), needed = p.displacement * tangent(flat_angle);
  const double slip = p.displacement - p.dilation / tangent(steep_angle);
  const double least_slip = p.displacement * (1 - tangent(flat_angle) / tangent(steep_angle));
  std::string text = fmt::format(
      "At {} the upper half had risen by {}. Rigid halves on the {} flanks would have risen by {}; the {} flanks of {} "
      "part where it is more than {}. ",
      mm(p.displacement), mm(p.dilation), degrees(steep_angle), mm(rigid), degrees(flat_angle), tooth_name(n, flat),
      mm(needed));
  text += fmt::format(
      "{} of the displacement did not lift the half: slip on the joint's spring, and what the flanks and the halves "
      "give "
      "way; from {} on that keeps the flatter flanks closed. ",
      mm(slip), mm(least_slip));
  return text + (p.dilation > needed ? fmt::format("They stood {} open.", mm(p.dilation - needed))
                                     : fmt::format("They were pressed together by {}.", mm(needed - p.dilation)));
}

/// When the flank's load comes and goes, by its force across the joint.
std::string bearing_of_flatter(const JointNumbers& n, std::size_t flat, const CsvData& curves) {
  const std::vector<double> u = curves.numbers("shear_displacement_mm");
  const std::vector<double> force = curves.numbers(fmt::format("tooth{}_leading_y_n_per_mm", flat + 1));
  const double least = kBears * n.normal_mpa * n.length_mm;
  std::size_t bearing = 0;
  for (const double f : force) bearing += f > least ? 1 : 0;
  const auto last = std::find_if(force.rbegin(), force.rend(), [&](double f) { return f > least; });
  if (last == force.rend())
    return fmt::format("Its leading flank never bore {:.0f} % of the normal force.", 100 * kBears);
  const auto first = std::find_if(force.begin(), force.end(), [&](double f) { return f > least; });
  return fmt::format(
      "Its leading flank bore more than {:.0f} % of the normal force in {:.0f} % of all samples, first at {}, last at "
      "{}.",
      100 * kBears, 100.0 * static_cast<double>(bearing) / static_cast<double>(force.size()),
      mm(u[static_cast<std::size_t>(first - force.begin())]), mm(u[static_cast<std::size_t>(force.rend() - last) - 1]));
}

}  // namespace

std::string decimals(double value, int count) {
  if (!std::isfinite(value)) return "–";
  const std::string text = fmt::format("{:.{}f}", std::abs(value), count);
  const bool zero = text.find_first_of("123456789") == std::string::npos;
  return value < 0 && !zero ? "−" + text : text;
}

std::string mm(double value) { return decimals(value, 2) + " mm"; }
std::string mpa(double value) { return decimals(value, 2) + " MPa"; }
std::string degrees(double value) { return decimals(value, 1) + "°"; }

std::string percent_apart(double value, double reference) {
  const double apart = 100 * (value / reference - 1);
  return fmt::format("{:.{}f} % {}", std::abs(apart), std::abs(apart) < 10 ? 1 : 0, apart < 0 ? "less" : "more");
}

std::string tooth_name(const JointNumbers& n, std::size_t index) {
  if (n.teeth.size() == 1) return "the tooth";
  return fmt::format("tooth {} ({:.0f}°)", index + 1, n.teeth[index].angle_deg);
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
  return text;
}

std::string unequal_loads(const JointNumbers& n) {
  std::string text = fmt::format("when {} bore its most", tooth_name(n, *n.first));
  bool others = false;
  for (std::size_t k = 0; k < n.teeth.size(); ++k) {
    if (k == *n.first) continue;
    text += fmt::format("{} {} bore {:.0f} % of its own", others ? " and" : ",", tooth_name(n, k),
                        100 * n.teeth[k].share_with_first);
    others = true;
  }
  return text;
}

std::vector<std::string> teeth_story(const JointNumbers& n, const CsvData& curves) {
  std::vector<std::string> story{verdict(n)};
  for (std::size_t k = 0; k < n.teeth.size(); ++k) story.push_back(tooth_course(n, k));
  const std::size_t steep = steepest_tooth(n);
  const CurvePoint at = point_at(curves, n.teeth[steep].most_at_mm);
  for (std::size_t k = 0; k < n.teeth.size(); ++k) {
    if (n.teeth[k].angle_deg > n.teeth[steep].angle_deg - 0.01) continue;
    story.push_back(gap_of_flatter(n, k, at) + " " + bearing_of_flatter(n, k, curves));
  }
  story.push_back(
      fmt::format("The upper half's block cannot rotate, so that rotation neither opens nor closes a flank; its front "
                  "end stood at {}, "
                  "its rear end at {} then, which is the half's own bending.",
                  mm(at.front), mm(at.rear)));
  return story;
}

}  // namespace asperity::app
