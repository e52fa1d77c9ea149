#include "tests/render/picture_file.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <fstream>
#include <iterator>

namespace asperity::test {

int PictureFile::count(render::Colour colour) const {
  const auto found = pixels.find({colour.r, colour.g, colour.b});
  return found == pixels.end() ? 0 : found->second;
}

PictureFile read_picture(const std::filesystem::path& png) {
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(png.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  PictureFile picture{image->GetDimensions()[0], image->GetDimensions()[1], {}};
  const auto* rgb = static_cast<const unsigned char*>(image->GetScalarPointer());
  const int components = image->GetNumberOfScalarComponents();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i, rgb += components)
    ++picture.pixels[{rgb[0], rgb[1], rgb[2]}];
  return picture;
}

std::string file_bytes(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::filesystem::path scratch(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace asperity::test
