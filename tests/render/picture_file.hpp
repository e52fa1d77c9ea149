#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <tuple>

#include "render/drawing.hpp"

namespace asperity::test {

/// A PNG file's size and how many pixels have each colour.
struct PictureFile {
  int width = 0, height = 0;
  std::map<std::tuple<int, int, int>, int> pixels;
  int count(render::Colour colour) const;
};

PictureFile read_picture(const std::filesystem::path& png);

std::string file_bytes(const std::filesystem::path& path);

/// A fresh folder below the build's test_scratch.
std::filesystem::path scratch(const std::string& name);

}  // namespace asperity::test
