#pragma once
#include "core/measurement/frame.hpp"
#include "render/scene.hpp"
#include "render/specimen.hpp"

namespace asperity::render {

/// How an experiment is called in a picture; symbols and units as UTF-8.
struct ExperimentTexts {
  std::string title, strain, stress;
  std::string strain_unit = "%";
  double strain_factor = 100;  ///< From Frame::axial_strain to that unit.
};
ExperimentTexts experiment_texts(const Frame& frame);

/// Colour bar or legend from the top of `room`; returns where it ends (pixels).
double draw_key(Drawing& drawing, const Frame& frame, const PictureOptions& options, const View& view, const Box& room,
                double unit);

/// Stress against strain so far, with the present point, filling `room`.
void draw_inset(Drawing& drawing, const Frame& frame, const PictureOptions& options, const Box& room, double unit);

}  // namespace asperity::render
