#include "core/calibration/analysis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.hpp"
#include "core/config/suggest.hpp"

namespace asperity {
namespace {

const Response* find_response(const Responses& responses, const std::string& name) {
  for (const Response& response : responses.list) {
    if (response.name == name) return &response;
  }
  return nullptr;
}

std::string names_of(const Responses& responses) {
  std::string names;
  for (const Response& response : responses.list) names += (names.empty() ? "" : ", ") + response.name;
  return names;
}

Fault unknown_target(const Target& target, const Responses& responses) {
  std::vector<std::string> names;
  for (const Response& response : responses.list) names.push_back(response.name);
  const std::string near = closest(target.property, names);
  return {"/targets/" + target.property, "no response has this name", "", names_of(responses),
          near.empty() ? "" : "did you mean " + near + "?"};
}

void check_targets(const std::vector<Target>& targets, const Responses& responses) {
  std::vector<Fault> faults;
  if (targets.empty()) faults.push_back({"/targets", "is empty", "", "one target or more", ""});
  for (const Target& target : targets) {
    const std::string place = "/targets/" + target.property;
    if (!find_response(responses, target.property)) faults.push_back(unknown_target(target, responses));
    if (!(std::abs(target.value) > 0.0) || !std::isfinite(target.value)) {
      faults.push_back({place + "/value", "cannot be met within a relative tolerance", fmt::format("{}", target.value),
                        "a number that is not 0", ""});
    }
    if (!(target.tolerance > 0.0)) {
      faults.push_back({place + "/tolerance", "is no tolerance", fmt::format("{}", target.tolerance), "above 0", ""});
    }
  }
  if (!faults.empty()) throw Error(ErrorKind::config, faults);
}

bool is_target(const std::vector<Target>& targets, const std::string& name) {
  return std::any_of(targets.begin(), targets.end(), [&](const Target& t) { return t.property == name; });
}

void fit_others(Analysis& analysis, const Design& design, const Responses& responses,
                const std::vector<Target>& targets, const ModelOptions& options) {
  for (const Response& response : responses.list) {
    if (is_target(targets, response.name)) continue;
    try {
      analysis.models.push_back(fit_response(design, response, options));
    } catch (const Error& failure) {
      analysis.warnings.push_back(fmt::format("no model: {}", failure.what()));
    }
  }
}

/// What Analysis::solutions and its compromise are made with.
class Judge {
 public:
  Judge(const Design& design, const ResponseSystem& system, const AnalysisOptions& options)
      : design_(design), system_(system), options_(options) {}

  Solution operator()(const Optimum& point) const {
    Solution solution;
    solution.point = point;
    solution.real = decode(design_.factors, point.x);
    for (const ResponseModel& model : system_.models()) {
      solution.predicted.push_back(predict(model, point.x, options_.level));
    }
    solution.region = confidence_region(system_, point.x, options_.level, design_.alpha);
    if (options_.bootstrap_draws > 0) {
      solution.bootstrap =
          bootstrap_region(system_, point.x, options_.level, design_.alpha, {options_.bootstrap_draws, options_.seed});
    }
    return solution;
  }

 private:
  const Design& design_;
  const ResponseSystem& system_;
  const AnalysisOptions& options_;
};

void warn_of_lack_of_fit(Analysis& analysis, std::size_t targeted, double level) {
  for (std::size_t r = 0; r < targeted; ++r) {
    const ResponseModel& model = analysis.models[r];
    if (!model.anova.lack_of_fit || model.anova.lack_of_fit->p > 1.0 - level) continue;
    analysis.warnings.push_back(
        fmt::format("{}: a quadratic does not follow it over this design (lack of fit p = {:.2g}): its misses exceed "
                    "the mesh scatter",
                    model.name, model.anova.lack_of_fit->p));
  }
}

void warn_of_bad_runs(Analysis& analysis, const Responses& responses) {
  if (responses.bad_runs.empty()) return;
  std::string rows;
  for (const BadRun& run : responses.bad_runs) rows += fmt::format("{}{}", rows.empty() ? "" : ", ", run.row + 1);
  analysis.warnings.push_back(fmt::format("bad runs in design rows {}: see bad_runs", rows));
}

}  // namespace

ResponseSystem system_of(const std::vector<ResponseModel>& models, const std::vector<Target>& targets) {
  return {{models.begin(), models.begin() + static_cast<std::ptrdiff_t>(targets.size())}, targets};
}

Analysis analyse(const Design& design, const Responses& responses, const std::vector<Target>& targets,
                 const AnalysisOptions& options) {
  check_targets(targets, responses);
  Analysis analysis;
  for (const Target& target : targets) {
    analysis.models.push_back(fit_response(design, *find_response(responses, target.property), options.model));
  }
  const ResponseSystem system = system_of(analysis.models, targets);
  const Optima optima = find_optima(system, {options.region, design.alpha}, options.search);
  const Judge judged(design, system, options);
  for (const Optimum& point : optima.solutions) analysis.solutions.push_back(judged(point));
  analysis.compromise = judged(optima.compromise);
  if (optima.solutions.empty()) {
    analysis.move = next_centre(design, system, {options.search.desirability, options.most_move});
  }
  warn_of_lack_of_fit(analysis, targets.size(), options.level);
  warn_of_bad_runs(analysis, responses);
  fit_others(analysis, design, responses, targets, options.model);
  return analysis;
}

}  // namespace asperity
