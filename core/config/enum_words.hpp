#pragma once
#include <array>
#include <cassert>
#include <string_view>
#include <utility>

#include "core/config/run_config.hpp"

/// The words by which the enumerations of run_config.hpp stand in JSON, in the schema's order.
namespace asperity {

template <class Enum, std::size_t N>
using EnumWords = std::array<std::pair<Enum, std::string_view>, N>;

constexpr EnumWords<ExperimentType, 4> words_of(ExperimentType) {
  using enum ExperimentType;
  return {
      {{uniaxial, "uniaxial"}, {triaxial, "triaxial"}, {brazilian, "brazilian"}, {direct_shear, "direct_shear"}}};
}
constexpr EnumWords<PlaneCondition, 2> words_of(PlaneCondition) {
  return {{{PlaneCondition::stress, "stress"}, {PlaneCondition::strain, "strain"}}};
}
constexpr EnumWords<PlatenShape, 2> words_of(PlatenShape) {
  return {{{PlatenShape::flat, "flat"}, {PlatenShape::curved, "curved"}}};
}
constexpr EnumWords<ParticleKind, 2> words_of(ParticleKind) {
  return {{{ParticleKind::triangle, "triangle"}, {ParticleKind::voronoi, "voronoi"}}};
}
constexpr EnumWords<LoadingMode, 2> words_of(LoadingMode) {
  return {{{LoadingMode::continuous, "continuous"}, {LoadingMode::staged, "staged"}}};
}
constexpr EnumWords<LawReading, 2> words_of(LawReading) {
  return {{{LawReading::literal, "literal"}, {LawReading::consistent, "default"}}};
}
constexpr EnumWords<LawForm, 2> words_of(LawForm) {
  return {{{LawForm::damage_slip, "damage_slip"}, {LawForm::cohesive_frictional, "cohesive_frictional"}}};
}
constexpr EnumWords<ShearPeak, 2> words_of(ShearPeak) {
  return {{{ShearPeak::cohesion, "cohesion"}, {ShearPeak::coulomb, "coulomb"}}};
}
constexpr EnumWords<OpeningShearStiffness, 2> words_of(OpeningShearStiffness) {
  return {{{OpeningShearStiffness::k_t, "k_t"}, {OpeningShearStiffness::k_s, "k_s"}}};
}

/// An enumeration of the configuration.
template <class Enum>
concept ConfigEnum = requires(Enum e) {
  words_of(e);
};

/// The JSON word of a value, e.g. "default" for LawReading::consistent.
template <ConfigEnum Enum>
constexpr std::string_view word(Enum value) {
  for (const auto& [candidate, text] : words_of(value))
    if (candidate == value) return text;
  assert(false && "enumerator without a word");
  return {};
}

/// The value of a JSON word that the schema has already accepted.
template <ConfigEnum Enum>
constexpr Enum from_word(std::string_view text) {
  for (const auto& [value, candidate] : words_of(Enum{}))
    if (candidate == text) return value;
  assert(false && "word that the schema should have refused");
  return {};
}

}  // namespace asperity
