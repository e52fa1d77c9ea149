#include "render/paint.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>
#include <vtk_glew.h>

#include <cmath>
#include <mutex>

#include "core/base/atomic_file.hpp"
#include "render/offscreen/gl_context.hpp"
#include "render/tessellate.hpp"
#include "render/text_metrics.hpp"
#include "render/text_runs.hpp"

namespace asperity::render {
namespace {

constexpr int kSamples = 4;  // more is not given by llvmpipe

vtkNew<vtkPolyData> to_poly_data(const std::vector<Triangle>& triangles, int height) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkUnsignedCharArray> colours;
  vtkNew<vtkIdTypeArray> connectivity, offsets;
  const vtkIdType n = static_cast<vtkIdType>(triangles.size());
  points->SetNumberOfPoints(3 * n);
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(3 * n);
  connectivity->SetNumberOfValues(3 * n);
  offsets->SetNumberOfValues(n + 1);
  for (vtkIdType i = 0; i < 3 * n; ++i) {
    const Triangle& triangle = triangles[static_cast<std::size_t>(i / 3)];
    const Vec2 corner = triangle.corners[static_cast<std::size_t>(i % 3)];
    points->SetPoint(i, corner.x, height - corner.y, 0);
    const unsigned char rgb[3] = {triangle.fill.r, triangle.fill.g, triangle.fill.b};
    colours->SetTypedTuple(i, rgb);
    connectivity->SetValue(i, i);
  }
  for (vtkIdType i = 0; i <= n; ++i) offsets->SetValue(i, 3 * i);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetPointData()->SetScalars(colours);
  return data;
}

vtkNew<vtkActor> to_actor(vtkPolyData* data) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

void style_text(vtkTextProperty* property, const Text& text) {
  property->SetFontFamily(VTK_FONT_FILE);
  property->SetFontFile(font_file(text.weight).c_str());
  property->SetFontSize(static_cast<int>(std::lround(text.size)));
  property->SetColor(text.colour.r / 255.0, text.colour.g / 255.0, text.colour.b / 255.0);
  property->SetOrientation(text.direction == Direction::upwards ? 90 : 0);
  property->SetVerticalJustificationToBottom();
  property->SetJustification(text.anchor == Anchor::left    ? VTK_TEXT_LEFT
                             : text.anchor == Anchor::right ? VTK_TEXT_RIGHT
                                                            : VTK_TEXT_CENTERED);
}

/// VTK places the line's bottom, we place its baseline.
Vec2 line_bottom(const Text& text) {
  const double descent = text_descent(text.size);
  return text.at + (text.direction == Direction::upwards ? Vec2{descent, 0} : Vec2{0, descent});
}

vtkNew<vtkTextActor> to_actor(const Text& text, int height) {
  vtkNew<vtkTextActor> actor;
  actor->SetInput(text.text.c_str());
  actor->SetTextScaleModeToNone();
  style_text(actor->GetTextProperty(), text);
  const Vec2 at = line_bottom(text);
  actor->SetDisplayPosition(static_cast<int>(std::lround(at.x)), height - static_cast<int>(std::lround(at.y)));
  return actor;
}

/// A line of several runs as lines of one run each, all anchored at their left.
std::vector<Text> split(const Text& text) {
  const std::vector<TextRun> runs = runs_of(text.text, text.size, text.weight);
  if (runs.size() == 1 && runs.front().below == 0) return {text};
  const double width = text_width(text.text, text.size, text.weight);
  const double before = text.anchor == Anchor::left ? 0 : text.anchor == Anchor::right ? width : 0.5 * width;
  const bool upwards = text.direction == Direction::upwards;
  std::vector<Text> parts;
  for (const TextRun& run : runs) {
    const double along = run.along - before;
    Text part = text;
    part.at = text.at + (upwards ? Vec2{run.below, -along} : Vec2{along, run.below});
    part.text = run.text;
    part.size = run.size;
    part.anchor = Anchor::left;
    parts.push_back(part);
  }
  return parts;
}

/// The one window of the process. Its context is made before it and destroyed after it.
class Painter {
 public:
  Painter() {
    context_.make_current();
    window_ = vtkSmartPointer<vtkGenericOpenGLRenderWindow>::New();
    window_->SetIsCurrent(true);
    window_->SetSupportsOpenGL(1);
    window_->SetFrameBlitModeToNoBlit();
    window_->SetOffScreenRendering(1);
    window_->SetMultiSamples(kSamples);
    window_->SetDPI(72);
    window_->SwapBuffersOff();
    context_.release();
  }

  ~Painter() {
    context_.make_current();
    window_ = nullptr;
  }

  Pixels pixels(const Drawing& drawing) {
    context_.make_current();
    const auto renderer = scene(drawing);
    window_->SetSize(drawing.width, drawing.height);
    window_->AddRenderer(renderer);
    window_->Render();
    resolve(drawing.width, drawing.height);
    Pixels pixels = grab();
    window_->RemoveRenderer(renderer);
    renderer->ReleaseGraphicsResources(window_);
    context_.release();
    return pixels;
  }

 private:
  static vtkNew<vtkRenderer> scene(const Drawing& drawing) {
    vtkNew<vtkRenderer> renderer;
    renderer->SetBackground(1, 1, 1);
    renderer->AddActor(to_actor(to_poly_data(tessellate(drawing), drawing.height)));
    for (const Shape& shape : drawing.shapes)
      if (const Text* text = std::get_if<Text>(&shape); text && !text->text.empty())
        for (const Text& part : split(*text)) renderer->AddActor2D(to_actor(part, drawing.height));
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(0.5 * drawing.width, 0.5 * drawing.height, 0);
    camera->SetPosition(0.5 * drawing.width, 0.5 * drawing.height, 1);
    camera->SetParallelScale(0.5 * drawing.height);
    camera->SetClippingRange(0.5, 1.5);
    return renderer;
  }

  /// Colours alone: VTK's own end of a frame would resolve every sample's depth too, half of a picture's time.
  void resolve(int width, int height) {
    vtkOpenGLState* state = window_->GetState();
    state->PushFramebufferBindings();
    window_->GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    window_->GetRenderFramebuffer()->ActivateReadBuffer(0);
    window_->GetDisplayFramebuffer()->Bind(GL_DRAW_FRAMEBUFFER);
    window_->GetDisplayFramebuffer()->ActivateDrawBuffer(0);
    state->vtkglBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    state->PopFramebufferBindings();
  }

  Pixels grab() {
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(window_);
    filter->SetInputBufferTypeToRGB();
    filter->ReadFrontBufferOff();
    filter->ShouldRerenderOff();
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
    const int width = image->GetDimensions()[0], height = image->GetDimensions()[1];
    return {width, height, {bytes, bytes + 3 * image->GetNumberOfPoints()}};
  }

  GlContext context_;
  vtkSmartPointer<vtkGenericOpenGLRenderWindow> window_;
};

}  // namespace

Pixels paint(const Drawing& drawing) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  static Painter painter;
  return painter.pixels(drawing);
}

void write_png(const Drawing& drawing, const std::filesystem::path& path) {
  write_file_atomically(path, png_bytes(paint(drawing)));
}

}  // namespace asperity::render
