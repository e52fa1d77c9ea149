#include "core/calibration/read_published.hpp"

#include <algorithm>

#include "core/calibration/paper_audit.hpp"
#include "core/calibration/terms.hpp"

namespace asperity {
namespace {

bool is_term(const std::string& name, std::size_t factors) {
  const std::vector<Term> terms = quadratic_terms(factors);
  return std::any_of(terms.begin(), terms.end(), [&](Term term) { return term_name(term) == name; });
}

PublishedTerm read_term(const Section& section, std::size_t factors) {
  const nlohmann::ordered_json& json = *section.json();
  const bool two_texts = json.is_array() && json.size() == 2 && json[0].is_string() && json[1].is_string();
  if (!two_texts || !is_term(json[0], factors) || !is_printed_number(json[1].get<std::string>())) {
    section.fault("", "is no printed term", "a term and its coefficient as texts, e.g. [\"x1x2\", \"0.11\"]");
    return {};
  }
  return {json[0], json[1]};
}

PublishedEquation read_equation(const std::string& property, const Section& section, std::size_t factors) {
  PublishedEquation equation{property, section.text("label", property), {}};
  section.section("terms").for_each(
      [&](const std::string&, const Section& term) { equation.terms.push_back(read_term(term, factors)); });
  return equation;
}

}  // namespace

std::optional<Published> read_published(const Section& section, std::size_t factors) {
  if (!section.json()) return std::nullopt;
  Published published;
  published.source = section.text("source");
  section.section("equations").for_each([&](const std::string& property, const Section& equation) {
    published.equations.push_back(read_equation(property, equation, factors));
  });
  const Section solution = section.section("solution");
  published.coded = solution.numbers("coded");
  published.parameters = solution.texts("parameters");
  if (published.coded.size() != factors) solution.fault("coded", "has not one value a factor", "");
  if (published.parameters.size() != factors) solution.fault("parameters", "has not one value a factor", "");
  section.section("scatter").for_each([&](const std::string& property, const Section& entry) {
    published.scatter.emplace_back(property, entry.number("sd") / entry.number("mean"));
  });
  return published;
}

}  // namespace asperity
