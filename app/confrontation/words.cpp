#include "app/confrontation/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/config/mechanism_declaration.hpp"
#include "render/axes.hpp"

namespace asperity::app {
namespace {

std::string with_true_minus(std::string text) {
  if (const auto at = text.find('e'); at != std::string::npos)
    text = text.substr(0, at) + "×" + render::power_of_ten(std::stoi(text.substr(at + 1)));
  if (!text.empty() && text.front() == '-') text = "−" + text.substr(1);
  return text;
}

/// A parameter at an amplitude, and what an error of the amplitude does to it.
struct ParameterAt {
  double value = 0, error = 0;
};

ParameterAt parameter_at(const MechanismParameter& p, double amplitude, double error) {
  if (p.reciprocal) return {p.strong / amplitude, std::abs(p.strong / amplitude * error / amplitude)};
  return {*p.neutral + amplitude * (p.strong - *p.neutral), std::abs(error * (p.strong - *p.neutral))};
}

/// "0.17 ± 0.03 MPa", or that the range of the library does not reach so far.
std::string value_words(const MechanismParameter& p, const ParameterAt& at) {
  const std::string unit = p.unit == "1" ? "" : " " + p.unit;
  if (at.value < p.lowest || at.value > p.highest)
    return "beyond its range of " + figures(p.lowest) + " to " + figures(p.highest) + unit;
  return figures_with_error(at.value, at.error) + unit;
}

bool follows(const MechanismParameter& p, double amplitude) { return p.neutral || (p.reciprocal && amplitude != 0.0); }

}  // namespace

std::string feature_words(std::string_view name) {
  std::string text(name);
  for (const std::string_view unit : {"_n_per_mm2", "_mpa_per_mm", "_n_per_mm", "_mpa", "_gpa", "_mm", "_deg"}) {
    if (text.ends_with(unit)) {
      text.resize(text.size() - unit.size());
      break;
    }
  }
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string figures(double value, int digits) {
  constexpr double kLongestWhole = 1e5;
  if (!std::isfinite(value)) return "–";
  const bool whole = std::abs(value) >= std::pow(10.0, digits) - 0.5 && std::abs(value) < kLongestWhole;
  return with_true_minus(whole ? fmt::format("{:.0f}", value) : fmt::format("{:.{}g}", value, digits));
}

std::string figures_with_error(double value, double error) {
  if (!std::isfinite(value)) return "–";
  if (!std::isfinite(error) || error <= 0.0) return figures(value);
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(error))));
  return with_true_minus(fmt::format("{:.{}f}", value, decimals)) + fmt::format(" ± {:.{}f}", error, decimals);
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

std::string mechanism_title(const std::string& id) {
  const MechanismDeclaration* declaration = find_mechanism(id);
  return declaration ? declaration->title : id;
}

std::string mechanism_name(const std::string& id) {
  const std::string title = mechanism_title(id);
  return title == id ? id : title + " (" + id + ")";
}

std::string parameter_words(const std::string& id, double amplitude, double error) {
  const MechanismDeclaration* declaration = find_mechanism(id);
  if (!declaration || !std::isfinite(amplitude)) return "";
  std::vector<std::string> all;
  for (const MechanismParameter& p : declaration->parameters) {
    if (!follows(p, amplitude)) continue;
    all.push_back(feature_words(p.key) + " " + value_words(p, parameter_at(p, amplitude, error)));
  }
  return joined(all);
}

std::string amplitude_words(const std::string& id, double amplitude, double error) {
  if (!std::isfinite(amplitude)) return "–";
  const std::string share = figures_with_error(amplitude, error) + " of the declared strong one";
  const std::string parameters = parameter_words(id, amplitude, error);
  return parameters.empty() ? share : parameters + " (" + share + ")";
}

std::string repetitions(double p) {
  if (!std::isfinite(p)) return "in an unknown share of repetitions";
  if (p < 0.01) return "in fewer than 1 of 100 repetitions";
  return fmt::format("in {:.0f} of 100 repetitions", 100.0 * p);
}

std::string hypothesis_words(double p_misfit, double p_excess) {
  const std::string fits = p_misfit < kKeepingLevel ? "does not fit: were it the cause, it would fit as badly only "
                                                    : "fits: were it the cause, it would fit no better ";
  const std::string behind = p_excess < kKeepingLevel
                                 ? "; the best one fits better than chance allows, as far behind it only "
                                 : "; it would lie as far behind the best one ";
  return fits + repetitions(p_misfit) + behind + repetitions(p_excess);
}

std::string detection_words(const std::string& id, double detectable, double absorbed_share) {
  const std::string absorbed =
      std::isfinite(absorbed_share) ? fmt::format("calibration absorbs {:.0f} % of it", 100.0 * absorbed_share) : "";
  if (!std::isfinite(detectable))
    return "not visible at any strength" + (absorbed.empty() ? std::string() : "; " + absorbed);
  const std::string parameters = parameter_words(id, detectable, 0.0);
  const std::string from = parameters.empty() ? figures(detectable, 2) + " of the declared strong one"
                                              : parameters + " (" + figures(detectable, 2) + " of the strong one)";
  return "seen from " + from + " on" + (absorbed.empty() ? "" : "; " + absorbed);
}

}  // namespace asperity::app
