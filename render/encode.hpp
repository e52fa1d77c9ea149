#pragma once
#include <string>
#include <vector>

namespace asperity::render {

/// A painted picture: 3 bytes (red, green, blue) a pixel, the lowest row first.
struct Pixels {
  int width = 0, height = 0;
  std::vector<unsigned char> rgb;
};

/// The picture as the bytes of a PNG file; nothing is lost.
std::string png_bytes(const Pixels& pixels);

/// The picture at half its size (means of 2 x 2 pixels) as the bytes of a JPEG file: what a page shows, about a tenth
/// of the PNG's weight. An odd last column or row is left out.
std::string preview_bytes(const Pixels& pixels);

}  // namespace asperity::render
