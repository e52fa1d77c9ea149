#include "render/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace asperity::render {
namespace {

constexpr Colour from_hex(unsigned rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8 & 0xFF),
          static_cast<std::uint8_t>(rgb & 0xFF)};
}

using Samples = std::array<Colour, 10>;

constexpr Samples sampled(std::array<unsigned, 10> hex) {
  Samples samples{};
  for (std::size_t i = 0; i < hex.size(); ++i) samples[i] = from_hex(hex[i]);
  return samples;
}

// Ten even samples of each map, as the R package viridisLite prints them.
constexpr Samples kViridis =
    sampled({0x440154, 0x482878, 0x3E4A89, 0x31688E, 0x26828E, 0x1F9E89, 0x35B779, 0x6DCD59, 0xB4DE2C, 0xFDE725});
constexpr Samples kCividis =
    sampled({0x00204D, 0x00336F, 0x39486B, 0x575C6D, 0x707173, 0x8A8779, 0xA69D75, 0xC4B56C, 0xE4CF5B, 0xFFEA46});
constexpr Samples kMagmaReversed =
    sampled({0xFCFDBF, 0xFEC98D, 0xFD9567, 0xF1605D, 0xCD4071, 0x9F2F7F, 0x721F81, 0x451077, 0x180F3E, 0x000004});
// ColorBrewer's RdBu in eleven classes, from blue to red.
constexpr std::array<Colour, 11> kRedBlue{from_hex(0x053061), from_hex(0x2166AC), from_hex(0x4393C3),
                                          from_hex(0x92C5DE), from_hex(0xD1E5F0), from_hex(0xF7F7F7),
                                          from_hex(0xFDDBC7), from_hex(0xF4A582), from_hex(0xD6604D),
                                          from_hex(0xB2182B), from_hex(0x67001F)};

// From white to a grey on which coloured lines still show: for a field under such lines.
constexpr std::array<Colour, 2> kGrey{from_hex(0xFFFFFF), from_hex(0x9A9A9A)};

std::span<const Colour> samples_of(ColourMap map) {
  switch (map) {
    case ColourMap::magma_light_to_dark:
      return kMagmaReversed;
    case ColourMap::viridis:
      return kViridis;
    case ColourMap::cividis:
      return kCividis;
    case ColourMap::red_blue:
      return kRedBlue;
    case ColourMap::grey:
      return kGrey;
  }
  return kViridis;
}

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + t * (static_cast<double>(b) - a)));
}

}  // namespace

Colour colour_at(ColourMap map, double fraction) {
  if (!std::isfinite(fraction)) return {0x80, 0x80, 0x80};
  const std::span<const Colour> samples = samples_of(map);
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), samples.size() - 2);
  const double t = place - static_cast<double>(i);
  const Colour a = samples[i], b = samples[i + 1];
  return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)};
}

double fraction_in(Range range, double value) {
  return range.high > range.low ? (value - range.low) / (range.high - range.low) : 0.5;
}

}  // namespace asperity::render
