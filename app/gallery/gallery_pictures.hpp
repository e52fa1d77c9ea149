#pragma once
#include <optional>

#include "app/gallery/gallery.hpp"

namespace asperity::app {

/// A picture beside the page: its path relative to the page, and what it shows.
struct GalleryPicture {
  std::filesystem::path path;
  std::string alternative_text;
};

/// Draws curves/MECHANISM.png and .svg: every experiment's curves on all meshes, with the mechanism and without.
/// Nothing where no run has finished.
std::optional<GalleryPicture> draw_curves(const Gallery& gallery, const MechanismDeclaration& mechanism,
                                          const std::filesystem::path& folder);

/// Draws patterns/EXPERIMENT_MECHANISM.png (of the base: EXPERIMENT.png): cracks at the end of the first mesh's run.
/// Nothing where that run has no frame.
std::optional<GalleryPicture> draw_pattern(const GalleryRuns& part, const std::filesystem::path& folder);

}  // namespace asperity::app
