#include <fmt/format.h>

#include <cassert>
#include <cstdint>

#include "core/output/html.hpp"

namespace asperity::html {
namespace {

bool stays(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
  }
  return out;
}

/// The picture, and itself in full size behind a click where it is a file.
std::string picture_html(const Picture& picture) {
  assert(!picture.alternative_text.empty());
  const std::string image =
      fmt::format("<img src=\"{}\" alt=\"{}\" loading=\"lazy\">", picture.source, escaped(picture.alternative_text));
  if (picture.source.starts_with("data:")) return image;
  return fmt::format("<a href=\"{}\">{}</a>", picture.source, image);
}

}  // namespace

std::string linked_source(const std::filesystem::path& path) {
  std::string out;
  for (const char c : path.generic_string())
    out += stays(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return out;
}

std::string embedded_source(std::string_view bytes, std::string_view media_type) {
  return fmt::format("data:{};base64,{}", media_type, base64(bytes));
}

Markup figure(const Figure& figure) {
  std::string out = "<figure>\n<div class=\"pictures\">";
  for (const Picture& picture : figure.pictures) out += picture_html(picture);
  out += "</div>\n<figcaption>" + figure.caption.html();
  for (const FileLink& file : figure.links) out += " " + link(file.target, file.text).html();
  return Markup::from_html(out + "</figcaption>\n</figure>\n");
}

}  // namespace asperity::html
