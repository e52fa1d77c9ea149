#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/confrontation/confrontation_chapters.hpp"
#include "app/confrontation/words.hpp"
#include "core/experiment/summarise.hpp"

namespace asperity::app {
namespace {

constexpr double kRounding = 1e-9;

bool is_suspect(const ConfrontationData& data, const std::string& id) {
  const ShownCandidate* candidate = find_candidate(data, id);
  return candidate && candidate->suspect;
}

/// Fitted tests of which nothing is compared: the verdict does not rest on them.
std::vector<Note> silent_tests(const ConfrontationData& data) {
  std::vector<std::string> silent;
  for (const ShownTest& test : data.tests) {
    const auto speaks = [&](const ShownSlot& slot) { return slot.test == test.id; };
    if (!test.kept_back && std::none_of(data.slots.begin(), data.slots.end(), speaks)) silent.push_back(test.id);
  }
  if (silent.empty()) return {};
  return {{html::NoticeKind::warning,
           "No feature of " + joined(silent) + " could be compared, so the verdict does not rest on " +
               (silent.size() == 1 ? "this test" : "these tests") + "; why stands under \"What is wrong\"."}};
}

/// Where a parameter ended at its limit: what it would absorb beyond is left to the mechanisms.
std::vector<Note> limits(const ConfrontationData& data) {
  std::vector<std::string> names;
  for (const Value& p : data.verdict["parameters"].items()) {
    if (p["at_limit"].truth()) names.push_back(p["label"].text().empty() ? p["name"].text() : p["label"].text());
  }
  if (names.empty()) return {};
  const bool by_effects = data.shown["setting"]["linearised_at"].text() == "reference";
  const char* remedy = by_effects ? "Take a nearer base (effects hold within four steps of a parameter), or give it "
                                    "more room where its own limits end before."
                                  : "Give it more room, or take a nearer base.";
  double worst = 0.0;
  for (const ShownSlot& slot : data.slots) worst = std::max(worst, std::abs(slot.z_base));
  return {
      {html::NoticeKind::warning,
       fmt::format("Calibration ended at the limit of what is allowed for {}. Features are left as far as {} standard "
                   "deviations from the base, and what this parameter would absorb beyond its limit is among them: a "
                   "mechanism may be named for it. {}",
                   joined(names), figures(worst, 2), remedy)}};
}

/// Kept causes whose strength is the greatest that their parameters' ranges allow.
std::vector<Note> strengths_at_an_end(const ConfrontationData& data) {
  std::vector<Note> notes;
  for (const Value& single : data.verdict["candidates"].items()) {
    const ShownCandidate* candidate = find_candidate(data, single["id"].text());
    const double amplitude = single["amplitude"].number();
    if (!candidate || !single["kept"].truth() || candidate->whole ||
        std::abs(amplitude) < (1.0 - kRounding) * candidate->most)
      continue;
    notes.push_back(
        {html::NoticeKind::warning,
         fmt::format(
             "The strength of {} is the greatest that is sought, {} of the declared strong one (three times it, or "
             "where its parameters' ranges end). The true one may lie beyond.",
             mechanism_name(candidate->id), figures(amplitude))});
  }
  return notes;
}

/// Kept causes whose runs have no peak where the base's have one.
std::vector<Note> causes_without_peak(const ConfrontationData& data) {
  std::vector<std::string> order;
  std::map<std::string, std::vector<std::string>> tests;
  for (const Value& entry : data.verdict["short_runs"].items()) {
    const std::string causes = causes_words(entry["causes"]);
    if (tests[causes].empty()) order.push_back(causes);
    tests[causes].push_back(fmt::format("{} ({}: {} of {} runs, of the base's {})", entry["test"].text(),
                                        feature_words(entry["feature"].text()), entry["extension"].count(),
                                        entry["meshes"].count(), entry["base"].count()));
  }
  std::vector<Note> notes;
  for (const std::string& causes : order)
    notes.push_back(
        {html::NoticeKind::warning,
         fmt::format("With {} fewer runs pass a peak than with the base: {}. They flow, or end too early; what "
                     "they bear at their end, or the base's effects alone, stand for the peak. Let these "
                     "tests go further (\"tests\", \"set\": /experiment/stop and "
                     "/measurement/peak_strain_limit) before the cause is believed.",
                     causes, joined(tests[causes]))});
  return notes;
}

/// Tests in which a model's runs are too fast: their strengths hang on the rate.
std::vector<Note> not_quasi_static(const ConfrontationData& data, std::vector<ShownCurve> ShownTest::*runs,
                                   const char* whose) {
  std::vector<std::string> tests;
  for (const ShownTest& test : data.tests) {
    double most = 0.0;
    std::ptrdiff_t fast = 0;
    for (const ShownCurve& run : test.*runs) {
      most = std::max(most, run.kinetic);
      if (run.kinetic > kQuasiStaticKineticShare) ++fast;
    }
    if (fast > 0)
      tests.push_back(
          fmt::format("{} (up to {} in {} of {} runs)", test.id, figures(most, 2), fast, (test.*runs).size()));
  }
  if (tests.empty()) return {};
  return {{html::NoticeKind::warning,
           fmt::format("Not quasi-static: before the peak of the {} runs that are shown, kinetic energy exceeded {} "
                       "of the stored energy in {}. Their strengths may hang on the loading rate; load more slowly "
                       "before a cause is believed.",
                       whose, figures(kQuasiStaticKineticShare), joined(tests))}};
}

}  // namespace

std::vector<Note> verdict_alarms(const ConfrontationData& data) {
  std::vector<Note> notes;
  for (const Value& alarm : data.verdict["gate"]["alarms"].items())
    notes.push_back(
        {html::NoticeKind::warning,
         "Alarm: " + alarm.text() + ". Look for a fault in the data or in the scatter before anything else."});
  for (const std::string& id : causes_of(data)) {
    if (is_suspect(data, id))
      notes.push_back({html::NoticeKind::warning,
                       "The solver's own settings first: " + mechanism_name(id) +
                           " is among the possible causes. It says nothing of the rock; settle it before any mechanism "
                           "of the rock is believed."});
  }
  for (const Note& note : silent_tests(data)) notes.push_back(note);
  for (const Note& note : limits(data)) notes.push_back(note);
  for (const Note& note : strengths_at_an_end(data)) notes.push_back(note);
  for (const Note& note : causes_without_peak(data)) notes.push_back(note);
  for (const Note& note : not_quasi_static(data, &ShownTest::base, "base's")) notes.push_back(note);
  for (const Note& note : not_quasi_static(data, &ShownTest::extension, "extension's")) notes.push_back(note);
  return notes;
}

}  // namespace asperity::app
