#pragma once
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "render/text_metrics.hpp"

namespace asperity::test {

inline constexpr double kSmallestText = 20;  // pixels at 1600 x 1200: 10 at half size can still be read

inline std::vector<render::Text> texts_of(const render::Drawing& drawing) {
  std::vector<render::Text> texts;
  for (const render::Shape& shape : drawing.shapes)
    if (const auto* text = std::get_if<render::Text>(&shape); text && !text->text.empty()) texts.push_back(*text);
  return texts;
}

inline bool has_text(const render::Drawing& drawing, const std::string& wanted) {
  for (const render::Text& text : texts_of(drawing))
    if (text.text == wanted) return true;
  return false;
}

inline bool overlap(const render::Box& a, const render::Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// Every text is inside the picture, as large as asked and clear of all others.
inline void check_texts(const render::Drawing& drawing, double smallest) {
  const std::vector<render::Text> texts = texts_of(drawing);
  CHECK(texts.size() > 8);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const render::Box box = text_box(texts[i]);
    CAPTURE(texts[i].text);
    CHECK(box.left >= 0);
    CHECK(box.top >= 0);
    CHECK(box.right <= drawing.width);
    CHECK(box.bottom <= drawing.height);
    CHECK(texts[i].size >= smallest);
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(texts[j].text);
      CHECK_FALSE(overlap(box, text_box(texts[j])));
    }
  }
}

}  // namespace asperity::test
