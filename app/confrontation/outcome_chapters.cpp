#include <fmt/format.h>

#include <cmath>

#include "app/confrontation/confrontation_chapters.hpp"
#include "app/confrontation/confrontation_pictures.hpp"
#include "app/confrontation/words.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;

/// Draws never make a sure thing of it.
std::string percent_right(double probability) {
  constexpr double kMost = 0.999;
  return probability > kMost ? "> 99.9" : figures(100.0 * probability);
}

std::string interval_words(const Value& gain) {
  const std::vector<double> interval = gain["elpd_interval_90"].numbers();
  if (interval.size() != 2) return "–";
  return figures(interval[0]) + " to " + figures(interval[1]);
}

std::string gain_words(const ConfrontationData& data) {
  const Value gain = data.verdict["gain"];
  const std::string numbers = fmt::format(
      "the logarithm of the predicted density of the kept-back measurements changes by {} (90 % of repetitions: {}), "
      "the root mean square deviation from {} to {} standard deviations",
      figures(gain["elpd_change"].number()), interval_words(gain), figures(gain["rms_z_before"].number(), 2),
      figures(gain["rms_z_after"].number(), 2));
  if (gain["claimed"].truth())
    return "A gain is claimed: with " + causes_words(gain["causes"]) +
           ", refitted on the fitted tests alone, against the recalibrated base, " + numbers +
           ". The whole interval lies above zero.";
  const std::string where = refuted_by_kept_back(gain)
                                ? ". The whole interval lies below zero: the kept-back tests refute this extension."
                                : ". The interval does not lie above zero.";
  return "No gain is claimed: with " + causes_words(gain["causes"]) + ", " + numbers + where;
}

std::string place_of_interval(const Value& gain) {
  if (gain["claimed"].truth()) return "above zero";
  return refuted_by_kept_back(gain) ? "below zero" : "not above zero";
}

void add_rival(const Value& gain, const std::string& what, PlainTable& table) {
  const bool claimed = gain["claimed"].truth();
  table.rows.push_back(
      {{causes_words(gain["causes"]), what, figures(gain["elpd_change"].number()), interval_words(gain),
        figures(gain["rms_z_before"].number(), 2), figures(gain["rms_z_after"].number(), 2), place_of_interval(gain)},
       claimed ? html::RowTone::good : html::RowTone::quiet});
}

PlainTable rivals_table(const Value& gain) {
  PlainTable table{
      "The extension beside others that were kept and beside decoys: the next best mechanisms, which were not kept.",
      {{"Mechanism", "", ColumnKind::head},
       {"Role", "", ColumnKind::text},
       {"Change of log density", ""},
       {"90 % of repetitions", "", ColumnKind::text},
       {"Deviation before", "sd"},
       {"Deviation after", "sd"},
       {"Interval", "", ColumnKind::text}},
      {}};
  add_rival(gain, "extension", table);
  for (const Value& other : gain["others"].items()) add_rival(other, "also kept", table);
  for (const Value& decoy : gain["decoys"].items()) add_rival(decoy, "decoy", table);
  return table;
}

PlainTable kept_back_table(const ConfrontationData& data) {
  PlainTable table{"Kept-back features before and after; z over the scatter of the difference, the same for both.",
                   {{"Test", "", ColumnKind::head},
                    {"Feature", "", ColumnKind::text},
                    {"Measured", ""},
                    {"Base", ""},
                    {"Extension", ""},
                    {"z, base", ""},
                    {"z, extension", ""}},
                   {}};
  for (const Value& f : data.verdict["gain"]["features"].items()) {
    const double before = f["z_before"].number(), after = f["z_after"].number();
    table.rows.push_back({{f["test"].text(), feature_with_unit(data, f["test"].text(), f["feature"].text()),
                           figures(f["measured"].number(), 4), figures(f["before"].number(), 4),
                           figures(f["after"].number(), 4), figures(before, 2), figures(after, 2)},
                          html::RowTone::plain});
  }
  return table;
}

std::string names(const Value& ids) {
  std::vector<std::string> all;
  for (const Value& id : ids.items()) all.push_back(id.text());
  return joined(all);
}

std::string runs_words(const Value& cost) {
  return fmt::format("{} asked for: {} from the bank, {} from the store, {} computed ({} min), {} failed, {} checked",
                     cost["runs"].count(), cost["from_bank"].count(), cost["from_store"].count(),
                     cost["computed"].count(), figures(cost["compute_s"].number() / 60.0, 2), cost["failed"].count(),
                     cost["checked"].count());
}

std::string meshes_words(const Value& meshes) {
  return fmt::format(
      "{} a test for the mean that the gate compares (with those for effects: for the scatter), {} for effects, {} for "
      "a first look at a mechanism, {} fresh ones of "
      "kept-back tests",
      meshes["noise"].count(), meshes["common"].count(), meshes["screen"].count(), meshes["fresh"].count());
}

std::string no_next_words(const ConfrontationData& data) {
  if (data.shown["setting"]["linearised_at"].text() == "reference")
    return "No further test that would tell these causes apart stands here: with --next-tests those are simulated that "
           "can be made of these.";
  return "None of the further tests that Asperity knows can be made of these.";
}

}  // namespace

Chapter gain_chapter(const ConfrontationData& data) {
  Chapter chapter{"The gain", {}};
  const Value gain = data.verdict["gain"];
  if (!gain["elpd_change"].exists()) {
    const bool extended = !data.extension.empty();
    chapter.blocks.emplace_back(
        Paragraph{extended ? "No test was kept back that could be compared, so no gain is measured and none is claimed."
                           : "There is no extension, so there is no gain to measure."});
    return chapter;
  }
  chapter.blocks.emplace_back(Paragraph{gain_words(data)});
  chapter.blocks.emplace_back(rivals_table(gain));
  chapter.blocks.emplace_back(kept_back_table(data));
  return chapter;
}

Chapter patterns_chapter(const ConfrontationData& data) {
  Chapter chapter{"Failure patterns", {}};
  for (PlainFigure& figure : pattern_figures(data)) chapter.blocks.emplace_back(std::move(figure));
  return chapter;
}

Chapter limits_chapter(const ConfrontationData& data) {
  Chapter chapter{"What these data could not have shown", {}};
  if (data.candidates.empty()) return chapter;
  chapter.blocks.emplace_back(
      Paragraph{"A mechanism weaker than the strength given here would most likely not have been noticed: its mark on "
                "the features drowns in the scatter, or calibration of the microparameters absorbs it."});
  PlainTable table{"Least strength that stands out, in the mechanism's own parameters.",
                   {{"Mechanism", "", ColumnKind::head},
                    {"Seen from", "of the declared strong one"},
                    {"In its parameters", "", ColumnKind::prose},
                    {"Absorbed by calibration", "%"},
                    {"Remark", "", ColumnKind::text}},
                   {}};
  for (const ShownCandidate& c : data.candidates) {
    const bool hidden = !std::isfinite(c.detectable), weak = !hidden && c.detectable > 1.0;
    table.rows.push_back({{mechanism_name(c.id), figures(c.detectable, 2), parameter_words(c.id, c.detectable, 0.0),
                           std::isfinite(c.absorbed_share) ? figures(100.0 * c.absorbed_share) : "–",
                           hidden ? "not visible at any strength"
                           : weak ? "even the declared strong one would go unseen"
                                  : ""},
                          hidden || weak ? html::RowTone::bad : html::RowTone::plain});
  }
  chapter.blocks.emplace_back(std::move(table));
  return chapter;
}

Chapter next_chapter(const ConfrontationData& data) {
  Chapter chapter{"Next tests", {}};
  PlainTable table{"Which further test would tell the causes apart.",
                   {{"Test", "", ColumnKind::head},
                    {"What", "", ColumnKind::prose},
                    {"Otherwise as", "", ColumnKind::text},
                    {"Tells apart", "", ColumnKind::text},
                    {"Distance", "sd"},
                    {"Right answer", "%"}},
                   {}};
  for (const Value& n : data.verdict["next_tests"].items())
    table.rows.push_back({{n["id"].text(), n["description"].text(), n["changes"].text(), names(n["separates"]),
                           figures(n["distance"].number(), 2), percent_right(n["probability_correct"].number())},
                          html::RowTone::plain});
  if (!table.rows.empty()) chapter.blocks.emplace_back(std::move(table));
  if (chapter.blocks.empty() && data.verdict["status"].text() == "indistinguishable")
    chapter.blocks.emplace_back(Paragraph{no_next_words(data)});
  return chapter;
}

Chapter provenance_chapter(const ConfrontationData& data) {
  Chapter chapter{"Provenance", {}};
  const Value setting = data.shown["setting"], &manifest = data.manifest;
  const std::string dirty = manifest["dirty"].truth() ? ", with changed files" : "";
  Entries entries{
      {{"Measured", setting["measured"].text() + ": " + setting["material"].text()},
       {"Source",
        setting["source"].text() + (setting["licence"].text().empty() ? "" : "; licence " + setting["licence"].text())},
       {"Measured numbers, SHA-256", data.verdict["data_sha256"].text()},
       {"Features, library, levels and split, SHA-256", data.verdict["frozen_sha256"].text()},
       {"Code", "Asperity " + manifest["version"].text() + ", revision " + manifest["revision"].text() + dirty},
       {"Started", manifest["started_utc"].text()},
       {"Runs", runs_words(data.shown["cost"])},
       {"Meshes", meshes_words(setting["meshes"])},
       {"Draws", std::to_string(setting["draws"].count())},
       {"Alarm level of the gate", figures(setting["alarm_level"].number())},
       {"Effects taken at", setting["linearised_at"].text() == "reference" ? "the configuration's parameters"
                                                                           : "the calibrated parameters"}}};
  if (setting["bank"].exists()) entries.all.emplace_back("Bank", setting["bank"].text());
  std::erase_if(entries.all, [](const auto& entry) { return entry.second.empty() || entry.second == ": "; });
  chapter.blocks.emplace_back(std::move(entries));
  Files files{{{"verdict.json", "the verdict's numbers"},
               {"frozen.json", "what was decided before a measured value was compared"},
               {"shown.json", "curves, residuals and fingerprints of this page"},
               {"config.original.json", "the confrontation as it was given"}}};
  if (const std::string extended = data.verdict["extended_config"].text(); !extended.empty())
    files.all.emplace_back(extended,
                           std::string(data.extension.empty() ? "the calibrated base's" : "the extended model's") +
                               " first test, ready to run; the others lie beside it");
  std::erase_if(files.all, [&](const auto& file) { return !std::filesystem::exists(data.folder / file.first); });
  chapter.blocks.emplace_back(std::move(files));
  return chapter;
}

}  // namespace asperity::app
