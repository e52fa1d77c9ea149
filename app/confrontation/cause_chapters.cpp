#include <fmt/format.h>

#include <cmath>

#include "app/confrontation/confrontation_chapters.hpp"
#include "app/confrontation/confrontation_pictures.hpp"
#include "app/confrontation/words.hpp"

namespace asperity::app {
namespace {

using html::ColumnKind;

std::string percent(double share) { return std::isfinite(share) ? fmt::format("{:.0f}", 100.0 * share) : "–"; }

std::string one_decimal(double value) { return std::isfinite(value) ? fmt::format("{:.1f}", value) : "–"; }

std::string convergence_words(const Value& candidate) {
  return candidate["converged"].exists() && !candidate["converged"].truth()
             ? "; the refit did not converge, a better fit may exist"
             : "";
}

/// A kept one that the best one would refute is kept since the two are known to be taken for one another, Eq. (N25).
std::string judged_words(const Value& candidate) {
  const double p_misfit = candidate["p_misfit"].number(), p_excess = candidate["p_excess"].number();
  const std::string words = hypothesis_words(p_misfit, p_excess);
  if (!candidate["kept"].truth()) return "refuted: " + words;
  if (p_excess >= kKeepingLevel) return "kept: " + words;
  return "kept, since it is known to be taken for one that fits better: " + words;
}

PlainTable candidates_table(const ConfrontationData& data) {
  PlainTable table{
      "Candidates that were refitted together with the microparameters, the likeliest first. Misfit: what is left, "
      "in squared standard deviations. Explained: what the fingerprint takes of it at the base's "
      "calibration. Absorbed: share of the fingerprint that calibration hides.",
      {{"Mechanism", "", ColumnKind::head},
       {"Strength", "", ColumnKind::prose},
       {"Misfit", ""},
       {"Explained", ""},
       {"Absorbed", "%"},
       {"Judged", "", ColumnKind::prose}},
      {}};
  for (const Value& c : data.verdict["candidates"].items()) {
    const bool kept = c["kept"].truth();
    const std::string id = c["id"].text();
    table.rows.push_back(
        {{mechanism_name(id) + (c["suspect"].truth() ? ", a setting of the solver" : ""),
          amplitude_words(id, c["amplitude"].number(), c["amplitude_error"].number()) + convergence_words(c),
          one_decimal(c["misfit"].number()), one_decimal(c["explained"].number()),
          percent(c["absorbed_share"].number()), judged_words(c)},
         kept ? html::RowTone::good : html::RowTone::quiet});
  }
  return table;
}

PlainTable pairs_table(const ConfrontationData& data) {
  PlainTable table{"Two causes together.",
                   {{"Mechanisms", "", ColumnKind::head},
                    {"Strengths", "", ColumnKind::prose},
                    {"Misfit", ""},
                    {"Judged", "", ColumnKind::prose}},
                   {}};
  for (const Value& p : data.verdict["pairs"].items()) {
    const std::vector<Value> ids = p["ids"].items();
    const std::vector<double> amplitudes = p["amplitudes"].numbers(), errors = p["amplitude_errors"].numbers();
    std::vector<std::string> strengths;
    for (std::size_t i = 0; i < ids.size() && i < amplitudes.size() && i < errors.size(); ++i)
      strengths.push_back(amplitude_words(ids[i].text(), amplitudes[i], errors[i]));
    const bool kept = p["kept"].truth();
    const std::string judged = hypothesis_words(p["p_misfit"].number(), p["p_excess"].number());
    table.rows.push_back({{causes_words(p["ids"]), joined(strengths), one_decimal(p["misfit"].number()),
                           kept                    ? "kept: " + judged
                           : p["both_act"].truth() ? "refuted: " + judged
                                                   : "no pair: one of the two need not act"},
                          kept ? html::RowTone::good : html::RowTone::quiet});
  }
  return table;
}

Bullets second_words(const ConfrontationData& data) {
  Bullets bullets;
  for (const Value& s : data.shown["seconds"].items()) {
    const double p = s["p"].number();
    bullets.items.push_back(fmt::format(
        "Beside {}, {} would explain most of what is left ({} of the squared length); were {} the only cause, as much "
        "would come {}: {}.",
        s["first"].text(), s["second"].text(), figures(s["explained"].number()), s["first"].text(), repetitions(p),
        p < 0.01 ? "a second cause was tried" : "no sign of a second cause"));
  }
  return bullets;
}

void add_pictures(const ConfrontationData& data, Chapter& chapter) {
  if (data.slots.empty()) return;
  chapter.blocks.emplace_back(
      draw_bars(data, fingerprint_bars(data),
                {"fingerprints", "",
                 "Bars of the projected residual beside the projected fingerprints of the leading mechanisms, feature "
                 "by feature.",
                 "A mechanism is a likely cause where its bars repeat those at the left in sign and size."}));
  if (const auto cosines = cosine_picture(data))
    chapter.blocks.emplace_back(
        draw_matrix(data, *cosines,
                    {"cosines", "", "Matrix of the cosines between the leading mechanisms' projected fingerprints.",
                     "The larger a cosine, the less these tests tell two mechanisms apart."}));
}

}  // namespace

Chapter cause_chapter(const ConfrontationData& data) {
  Chapter chapter{"The cause", {}};
  const bool sought = data.verdict["gate"]["discrepancy"].truth();
  if (!sought)
    chapter.blocks.emplace_back(Paragraph{
        "Nothing stands out of scatter, so no cause was sought. Which mechanism comes nearest to what is left "
        "is shown for completeness; it is no finding."});
  if (PlainTable table = candidates_table(data); !table.rows.empty()) chapter.blocks.emplace_back(std::move(table));
  add_pictures(data, chapter);
  if (Bullets seconds = second_words(data); !seconds.items.empty()) chapter.blocks.emplace_back(std::move(seconds));
  if (PlainTable pairs = pairs_table(data); !pairs.rows.empty()) chapter.blocks.emplace_back(std::move(pairs));
  return chapter;
}

}  // namespace asperity::app
