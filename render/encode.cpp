#include "render/encode.hpp"

#include <png.h>
#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>

#include "core/base/error.hpp"

namespace asperity::render {
namespace {

constexpr int kJpegQuality = 64;  // of 100; README.md has what previews weigh

/// The pixels as VTK's image, which reads them in place.
vtkNew<vtkImageData> image_of(const Pixels& pixels) {
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(3);
  constexpr int kKeepsOwner = 1;
  values->SetArray(const_cast<unsigned char*>(pixels.rgb.data()), static_cast<vtkIdType>(pixels.rgb.size()),
                   kKeepsOwner);
  vtkNew<vtkImageData> image;
  image->SetDimensions(pixels.width, pixels.height, 1);
  image->GetPointData()->SetScalars(values);
  return image;
}

Pixels halved(const Pixels& whole) {
  Pixels half{whole.width / 2, whole.height / 2, {}};
  half.rgb.reserve(3 * static_cast<std::size_t>(half.width) * static_cast<std::size_t>(half.height));
  const std::size_t row = 3 * static_cast<std::size_t>(whole.width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(half.height); ++y) {
    const unsigned char* at = whole.rgb.data() + 2 * y * row;
    for (int x = 0; x < half.width; ++x, at += 6)
      for (std::size_t c = 0; c < 3; ++c)
        half.rgb.push_back(static_cast<unsigned char>((at[c] + at[c + 3] + at[row + c] + at[row + c + 3] + 2) / 4));
  }
  return half;
}

}  // namespace

std::string png_bytes(const Pixels& pixels) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(pixels.width);
  image.height = static_cast<png_uint_32>(pixels.height);
  image.format = PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;  // no filters: with flat colours they cost time and weight
  const png_int_32 lowest_row_first = -3 * pixels.width;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (!png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.rgb.data(), lowest_row_first, nullptr))
    throw Error(ErrorKind::unexpected, std::string("a picture cannot be encoded: ") + image.message);
  bytes.resize(size);
  return bytes;
}

std::string preview_bytes(const Pixels& pixels) {
  const Pixels half = halved(pixels);
  const vtkNew<vtkImageData> image = image_of(half);
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(kJpegQuality);
  writer->ProgressiveOff();
  writer->SetInputData(image);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

}  // namespace asperity::render
