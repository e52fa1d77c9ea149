#include "core/output/html_viewer.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace asperity;

namespace {

html::FrameViewer two_frames() {
  html::FrameViewer viewer;
  viewer.kinds = {{"cracks & more", {"frames/a%201.jpg", "frames/b.jpg"}, {"frames/a%201.png", "frames/b.png"}},
                  {"damage", {"", "frames/c.jpg"}, {"", "frames/c.png"}}};
  viewer.frames = {{0, 0, "Frame 1 of 2: 0 mm"}, {1, 2, "Frame 2 of 2: 1 mm"}};
  viewer.shown = 1;
  viewer.curve = {{"u [mm]", 0, 1, {{0, "0"}, {1, "1"}}},
                  {"τ [MPa]", 0, 2, {{0, "0"}, {2, "2"}}},
                  {0, 0.5, 1},
                  {0, NAN, 2},
                  "The curve."};
  return viewer;
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("A viewer shows its frame without a script, and says which") {
  const std::string page = html::frame_viewer(two_frames()).html();
  CHECK_THAT(page, Catch::Contains("<a href=\"frames/b.png\"><img src=\"frames/b.jpg\" alt=\"cracks &amp; more, Frame 2 of 2: 1 mm\">"));
  CHECK_THAT(page, Catch::Contains("<div class=\"controls\" hidden>"));
  CHECK_THAT(page, Catch::Contains("aria-live=\"polite\">Frame 2 of 2: 1 mm</p>"));
  CHECK_THAT(page, Catch::Contains("<noscript>"));
}

TEST_CASE("Kinds are radio buttons and frames a slider, each with a name") {
  const std::string page = html::frame_viewer(two_frames()).html();
  CHECK(count(page, "type=\"radio\"") == 2);
  CHECK(count(page, " checked>") == 1);
  CHECK_THAT(page, Catch::Contains("type=\"range\" min=\"0\" max=\"1\" step=\"1\" value=\"1\" aria-label=\"Frame\" "
                                   "aria-valuetext=\"Frame 2 of 2: 1 mm\""));
  CHECK(count(page, "aria-label=\"Next frame\"") == 1);
}

TEST_CASE("What the script reads is in the page, escaped, with the point's place on the drawing") {
  const std::string page = html::frame_viewer(two_frames()).html();
  CHECK_THAT(page, Catch::Contains("&quot;cracks &amp; more&quot;") && Catch::Contains("&quot;frames/a%201.png&quot;") &&
                       Catch::Contains("&quot;frames/a%201.jpg&quot;"));
  // The second frame stands in the drawing's upper right corner, the first in the lower left one.
  CHECK_THAT(page, Catch::Contains("{&quot;x&quot;:466.0,&quot;y&quot;:14.0,") &&
                       Catch::Contains("{&quot;x&quot;:62.0,&quot;y&quot;:278.0,"));
  CHECK_THAT(page, Catch::Contains("cx=\"466.0\" cy=\"14.0\""));
}

TEST_CASE("A value that is not finite breaks the small curve") {
  CHECK_THAT(html::frame_viewer(two_frames()).html(), Catch::Contains("d=\"M62.0 278.0M466.0 14.0\""));
}

TEST_CASE("A page has a script only where it is given one") {
  html::Page page{"T", "s", {}, {}, "f", {}};
  CHECK_THAT(html::document(page), !Catch::Contains("<script"));
  page.script = html::frame_viewer_script();
  CHECK_THAT(html::document(page), Catch::Contains("<script>\n\"use strict\";"));
  CHECK_THAT(std::string(html::frame_viewer_script()), !Catch::Contains("http") && !Catch::Contains("</script"));
}
