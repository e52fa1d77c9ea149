#include "render/encode.hpp"

#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <cstddef>

namespace asperity::render {
namespace {

constexpr int kPngCompression = 1;  // 9 takes eight times as long for 3 % less
constexpr int kJpegQuality = 64;    // of 100; README.md has what previews weigh

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

template <class Writer>
std::string written(Writer& writer, const Pixels& pixels) {
  const vtkNew<vtkImageData> image = image_of(pixels);
  writer.SetInputData(image);
  writer.WriteToMemoryOn();
  writer.Write();
  vtkUnsignedCharArray* bytes = writer.GetResult();
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)), static_cast<std::size_t>(bytes->GetNumberOfValues())};
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
  vtkNew<vtkPNGWriter> writer;
  writer->SetCompressionLevel(kPngCompression);
  return written(*writer.GetPointer(), pixels);
}

std::string preview_bytes(const Pixels& pixels) {
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(kJpegQuality);
  writer->ProgressiveOff();
  return written(*writer.GetPointer(), halved(pixels));
}

}  // namespace asperity::render
