#pragma once
#include <array>
#include <vector>

#include "render/drawing.hpp"

/// Every colour and line style of the pictures stands here; README.md says why each was chosen. Widths and sizes are in
/// pixels of a picture 1200 pixels high, and grow with the picture.
namespace asperity::render::style {

inline constexpr Colour kInk{0x1A, 0x1A, 0x1A};      ///< Titles, axes, labels.
inline constexpr Colour kSoftInk{0x50, 0x50, 0x50};  ///< Second line of the title, notes.
inline constexpr Colour kGrid{0xE2, 0xE2, 0xE2};     ///< Grid of plots.
inline constexpr Colour kPaper{0xFF, 0xFF, 0xFF};    ///< Background.
inline constexpr Colour kPlaten{0x8E, 0x95, 0x9C};   ///< Loading platens.
inline constexpr Colour kPlatenEdge{0x3C, 0x42, 0x48};

inline constexpr Colour kSpecimen{0xE9, 0xE9, 0xE6};      ///< Intact rock under the crack network.
inline constexpr Colour kSpecimenEdge{0xF6, 0xF6, 0xF4};  ///< Outlines of particles, everywhere.
inline constexpr Colour kOutline{0x6E, 0x6E, 0x6E};       ///< The specimen's own surface.
inline constexpr double kOutlineWidth = 2;
inline constexpr Colour kLargestFragment{0xE4, 0xE4, 0xE0};

/// Okabe and Ito's palette (jfly.uni-koeln.de/color), which colour-blind readers tell apart.
inline constexpr Colour kBlue{0x00, 0x72, 0xB2}, kVermilion{0xD5, 0x5E, 0x00}, kGreen{0x00, 0x9E, 0x73},
    kPurple{0xCC, 0x79, 0xA7}, kSky{0x56, 0xB4, 0xE9}, kOrange{0xE6, 0x9F, 0x00}, kYellow{0xF0, 0xE4, 0x42},
    kBlack{0x00, 0x00, 0x00};

/// Tension: one thick blue line. Shear: a wider vermilion line with a white core, so it is told apart in grey too.
inline constexpr Colour kTension = kBlue, kShear = kVermilion, kShearCore = kPaper, kSoftening{0x9B, 0x86, 0xA9};
inline constexpr double kTensionWidth = 5, kShearWidth = 8, kShearCoreWidth = 2.6, kSofteningWidth = 2;
inline constexpr Colour kDefect = kOutline;  ///< Open before the test: no crack of it.
inline constexpr double kDefectWidth = 1;
/// Broken contacts over a coloured field: dark with a white casing, so they show on dark and on light.
inline constexpr Colour kBroken = kInk, kBrokenCasing = kPaper;
inline constexpr double kBrokenWidth = 2, kBrokenCasingWidth = 4.5;

/// Contact forces; those without a bond lie over the others.
inline constexpr Colour kCompressiveForce = kBlue, kTensileForce = kVermilion, kBrokenForce = kInk,
                        kGeneralForce = kGreen;
/// Broken contacts under the forces.
inline constexpr Colour kBrokenUnder{0xA8, 0xA8, 0xA8};
inline constexpr double kBrokenUnderWidth = 1.5;

inline constexpr std::array<Colour, 7> kFragments{kOrange, kSky, kGreen, kYellow, kBlue, kVermilion, kPurple};
/// All smaller fragments: muted, of differing lightness, none like those above.
inline constexpr std::array<Colour, 6> kSmallFragments{Colour{0x3F, 0x3F, 0x3F}, {0xB0, 0x89, 0x68},
                                                       {0x3E, 0x5C, 0x76},       {0x8A, 0x8A, 0x8A},
                                                       {0x6B, 0x44, 0x23},       {0x6A, 0x7F, 0x3A}};
inline constexpr double kFragmentEdgeWidth = 1.6;  ///< Broken contacts over fragments, in ink.
inline constexpr std::array<Colour, 7> kLines{kBlue, kVermilion, kGreen, kPurple, kOrange, kSky, kBlack};
inline constexpr double kLineWidth = 4, kMarkerRadius = 7, kPresentPointRadius = 11;

/// Dash patterns that go with kLines, in the same order, so that lines are told apart without colour.
inline const std::array<std::vector<double>, 7> kDashes{std::vector<double>{}, {22, 10}, {5, 8}, {24, 8, 5, 8}, {12, 8},
                                                        {30, 8, 5, 8, 5, 8},   {3, 6}};

inline constexpr double kTitleSize = 38, kSubtitleSize = 30, kLabelSize = 28, kTickSize = 26;

}  // namespace asperity::render::style
