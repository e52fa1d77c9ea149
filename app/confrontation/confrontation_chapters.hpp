#pragma once
#include <string>
#include <vector>

#include "app/confrontation/chapters.hpp"
#include "app/confrontation/confrontation_data.hpp"

/// The chapters of a confrontation's report, in their order on the page. One without blocks has nothing to say.
namespace asperity::app {

/// What must not be missed: alarms, and settings of the solver that may be the cause.
std::vector<Note> verdict_alarms(const ConfrontationData& data);

/// The verdict in one or a few sentences.
std::vector<std::string> verdict_sentences(const ConfrontationData& data);

Chapter verdict_chapter(const ConfrontationData& data);
Chapter wrong_chapter(const ConfrontationData& data);   ///< Draws its figures.
Chapter curves_chapter(const ConfrontationData& data);  ///< Draws its figures.
Chapter cause_chapter(const ConfrontationData& data);   ///< Draws its figures.
Chapter gain_chapter(const ConfrontationData& data);
Chapter patterns_chapter(const ConfrontationData& data);  ///< Draws its figures.
Chapter limits_chapter(const ConfrontationData& data);
Chapter next_chapter(const ConfrontationData& data);
Chapter assumptions_chapter(const ConfrontationData& data);
Chapter provenance_chapter(const ConfrontationData& data);

/// Ids of the causes that the verdict names.
std::vector<std::string> causes_of(const ConfrontationData& data);

/// Ids of a list in the verdict as "a + b".
std::string causes_words(const Value& ids);

/// Whether the whole interval of a gain lies below zero.
bool refuted_by_kept_back(const Value& gain);

/// "peak axial stress [MPa]" of a feature in this test's experiment.
std::string feature_with_unit(const ConfrontationData& data, const std::string& test, const std::string& feature);

}  // namespace asperity::app
