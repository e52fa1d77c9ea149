#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/confrontation/condition_tables.hpp"
#include "app/confrontation/confrontation_chapters.hpp"
#include "app/confrontation/words.hpp"
#include "core/measurement/features.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;

std::string misfit_words(const ConfrontationData& data) {
  const Value gate = data.verdict["gate"];
  return fmt::format(
      "what calibration cannot absorb amounts to {} in squared standard deviations, over {} features; were nothing "
      "wrong, as much would come {}, and as good an explanation by one mechanism {}",
      figures(gate["misfit"].number()), data.slots.size(), repetitions(gate["p_misfit"].number()),
      repetitions(gate["p_explained"].number()));
}

/// A cause with its strength, if it was refitted.
std::string cause_words(const ConfrontationData& data, const std::string& id) {
  for (const Value& single : data.verdict["candidates"].items()) {
    if (single["id"].text() == id)
      return mechanism_name(id) + ", " +
             amplitude_words(id, single["amplitude"].number(), single["amplitude_error"].number());
  }
  return mechanism_name(id);
}

/// The best kept pair of a verdict of two causes.
std::string pair_words(const ConfrontationData& data) {
  for (const Value& pair : data.verdict["pairs"].items()) {
    if (!pair["kept"].truth()) continue;
    const std::vector<double> amplitudes = pair["amplitudes"].numbers(), errors = pair["amplitude_errors"].numbers();
    std::vector<std::string> causes;
    const std::vector<Value> ids = pair["ids"].items();
    for (std::size_t i = 0; i < ids.size() && i < amplitudes.size() && i < errors.size(); ++i)
      causes.push_back(mechanism_name(ids[i].text()) + ", " + amplitude_words(ids[i].text(), amplitudes[i], errors[i]));
    return joined(causes);
  }
  std::vector<std::string> names;
  for (const std::string& id : causes_of(data)) names.push_back(mechanism_name(id));
  return joined(names);
}

/// How far the search went: what was refitted, what could act, what these data would not show.
std::string search_words(const ConfrontationData& data) {
  const std::size_t act = data.candidates.size(), refitted = data.verdict["candidates"].items().size();
  const auto hidden = std::count_if(data.candidates.begin(), data.candidates.end(),
                                    [](const ShownCandidate& c) { return !(c.detectable <= 1.0); });
  std::string text = fmt::format("Of {} candidates ", act);
  if (refitted == act)
    text = fmt::format("All {} candidates were refitted", act);
  else if (refitted == 0)
    text += "none explains any of it, so none was refitted";
  else if (refitted == 1)
    text += "the one that explains most was refitted";
  else
    text += fmt::format("the {} that explain most were refitted", refitted);
  if (hidden > 0) text += fmt::format("; {} would not be seen in these data even at the declared strong value", hidden);
  return text + ".";
}

std::vector<std::string> named_sentences(const ConfrontationData& data) {
  std::vector<std::string> sentences;
  const std::string status = data.verdict["status"].text();
  const std::vector<std::string> causes = causes_of(data);
  if (status == "two_causes") {
    sentences.push_back("No single mechanism of the library explains it, these two together do: " + pair_words(data) +
                        ".");
    return sentences;
  }
  if (status == "indistinguishable") {
    sentences.push_back(
        fmt::format("{} mechanisms explain it; these tests cannot tell which one acts. Any of them may be the cause:",
                    causes.size()));
    for (const std::string& id : causes) sentences.push_back("Possible: " + cause_words(data, id) + ".");
    return sentences;
  }
  const bool alone = data.verdict["candidates"].items().size() == 1;
  const std::string others =
      alone ? "no other explains nearly as much: " : "the others that were refitted are refuted: ";
  for (const std::string& id : causes)
    sentences.push_back("One mechanism of the library explains it, " + others + cause_words(data, id) + ".");
  return sentences;
}

std::string gain_sentence(const Value& gain) {
  if (gain["claimed"].truth())
    return "The model extended by " + causes_words(gain["causes"]) +
           " predicts the tests that were kept back better; the gain stands below.";
  if (refuted_by_kept_back(gain))
    return "The tests that were kept back refute the model extended by " + causes_words(gain["causes"]) +
           ": it predicts them worse than the base.";
  return "No gain on the tests that were kept back is claimed.";
}

Chapter titled(const std::string& title) { return {title, {}}; }

void add_notes(const ConfrontationData& data, Chapter& chapter) {
  std::vector<std::string> notes;
  for (const Value& note : data.verdict["notes"].items()) notes.push_back(note.text());
  if (!notes.empty()) chapter.blocks.emplace_back(Bullets{notes});
}

std::string tests_words(const ConfrontationData& data, bool kept_back) {
  std::vector<std::string> ids;
  for (const ShownTest& test : data.tests) {
    if (test.kept_back == kept_back) ids.push_back(test.id);
  }
  return ids.empty() ? "none" : joined(ids);
}

/// A parameter's value in the extension; empty where it is not refitted.
std::string extended_value(const Value& extended, const std::string& name) {
  for (const Value& p : extended.items()) {
    if (p["name"].text() == name) return figures_with_error(p["value"].number(), p["error"].number());
  }
  return {};
}

void add_parameters(const ConfrontationData& data, Chapter& chapter) {
  const Value extended = data.verdict["extended_parameters"];
  const bool refitted = !extended.items().empty();
  PlainTable table{"Microparameters after calibration on the fitted tests.",
                   {{"Parameter", "", ColumnKind::head}, {refitted ? "Base" : "Value", "", ColumnKind::text}},
                   {}};
  if (refitted) table.columns.push_back({"With " + causes_words(data.verdict["gain"]["causes"]), "", ColumnKind::text});
  table.columns.push_back({"Unit", "", ColumnKind::text});
  table.columns.push_back({"Remark", "", ColumnKind::prose});
  for (const Value& p : data.verdict["parameters"].items()) {
    const double error = p["error"].number();
    std::string remark = error > 0.0 ? "" : "not calibrated";
    if (!p["determined"].truth()) remark = "these tests do not determine it: left at its reference";
    if (p["at_limit"].truth()) remark = "at the end of what was allowed";
    const std::string label = p["label"].text().empty() ? p["name"].text() : p["label"].text();
    std::vector<std::string> cells{label, figures_with_error(p["value"].number(), error)};
    if (refitted) cells.push_back(extended_value(extended, p["name"].text()));
    cells.insert(cells.end(), {p["unit"].text(), remark});
    table.rows.push_back({std::move(cells), p["at_limit"].truth() ? html::RowTone::bad : html::RowTone::plain});
  }
  if (!table.rows.empty()) chapter.blocks.emplace_back(std::move(table));
}

std::string assumed_sizes(const Value& assumed) {
  std::vector<std::string> sizes;
  for (const auto& [key, name] :
       {std::pair{"width_mm", "width"}, {"height_mm", "height"}, {"diameter_mm", "diameter"}}) {
    if (assumed[key].exists()) sizes.push_back(fmt::format("{} {} mm", name, figures(assumed[key].number(), 4)));
  }
  if (assumed["teeth"].count() > 0) sizes.push_back(fmt::format("a joint of {} teeth", assumed["teeth"].count()));
  return joined(sizes);
}

}  // namespace

std::string feature_with_unit(const ConfrontationData& data, const std::string& test, const std::string& feature) {
  for (const ShownTest& t : data.tests) {
    if (t.id != test) continue;
    const FeatureKind* kind = find_feature_kind(t.experiment, feature);
    if (kind && kind->unit != "1") return feature_words(feature) + " [" + std::string(kind->unit) + "]";
  }
  return feature_words(feature);
}

std::vector<std::string> causes_of(const ConfrontationData& data) {
  std::vector<std::string> ids;
  for (const Value& id : data.verdict["causes"].items()) ids.push_back(id.text());
  return ids;
}

std::string causes_words(const Value& ids) {
  std::string text;
  for (const Value& id : ids.items()) text += (text.empty() ? "" : " + ") + id.text();
  return text;
}

bool refuted_by_kept_back(const Value& gain) {
  const std::vector<double> interval = gain["elpd_interval_90"].numbers();
  return interval.size() == 2 && interval[1] < 0.0;
}

std::vector<std::string> verdict_sentences(const ConfrontationData& data) {
  const std::string status = data.verdict["status"].text();
  if (status == "nothing_found")
    return {
        "Nothing found: the calibrated model agrees with the fitted tests within scatter; " + misfit_words(data) + ".",
        "This does not prove the model: how strong each mechanism could be without being seen stands under \"What "
        "these data could not have shown\"."};
  std::vector<std::string> sentences{"The calibrated model is wrong beyond scatter: " + misfit_words(data) + "."};
  if (status == "unexplained") {
    sentences.emplace_back(
        "Unexplained: no mechanism that was refitted, alone or with a second one, makes what is left. The cause lies "
        "outside the library, in a mechanism that was not refitted, or in the data.");
  } else {
    for (std::string& sentence : named_sentences(data)) sentences.push_back(std::move(sentence));
  }
  sentences.push_back(search_words(data));
  return sentences;
}

Chapter verdict_chapter(const ConfrontationData& data) {
  Chapter chapter = titled("Verdict");
  for (const std::string& sentence : verdict_sentences(data)) chapter.blocks.emplace_back(Paragraph{sentence});
  const Value gain = data.verdict["gain"];
  if (gain["elpd_change"].exists()) chapter.blocks.emplace_back(Paragraph{gain_sentence(gain)});
  chapter.blocks.emplace_back(Entries{{{"Fitted tests", tests_words(data, false)},
                                       {"Tests kept back", tests_words(data, true)},
                                       {"Candidates", std::to_string(data.candidates.size()) + " mechanisms"}}});
  add_notes(data, chapter);
  add_parameters(data, chapter);
  return chapter;
}

Chapter assumptions_chapter(const ConfrontationData& data) {
  Chapter chapter = titled("What was declared or assumed");
  const Value setting = data.shown["setting"];
  PlainTable table{"In place of what was not measured.",
                   {{"What", "", ColumnKind::head}, {"Value", "", ColumnKind::prose}, {"Why", "", ColumnKind::prose}},
                   {}};
  for (const Value& d : setting["declared"].items())
    table.rows.push_back({{d["what"].text(), d["value"].text(), d["why"].text()}, html::RowTone::plain});
  if (const std::string sizes = assumed_sizes(setting["assumed"]); !sizes.empty())
    table.rows.push_back({{"sizes of specimens", sizes, setting["assumed"]["why"].text()}, html::RowTone::plain});
  for (PlainTable& part : std::vector<PlainTable>{std::move(table), conditions_table(data), instruments_table(data)}) {
    if (!part.rows.empty()) chapter.blocks.emplace_back(std::move(part));
  }
  if (setting["split_proposed"].truth())
    chapter.blocks.emplace_back(
        Paragraph{"Which tests are fitted and which are kept back was proposed by Asperity, by kind of test."});
  return chapter;
}

}  // namespace asperity::app
