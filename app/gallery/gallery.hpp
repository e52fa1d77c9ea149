#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/campaign/campaign.hpp"
#include "core/config/mechanism_declaration.hpp"
#include "core/confrontation/fingerprint.hpp"

/// The gallery of mechanisms: each experiment with and without each mechanism, on common meshes.
namespace asperity::app {

/// One experiment of the gallery, with one mechanism or none, on its meshes.
struct GalleryRuns {
  ExperimentType experiment = ExperimentType::uniaxial;
  std::string mechanism;                  ///< Empty: the base.
  std::vector<CampaignRun> runs;          ///< One a mesh, in the order of the seeds.
  std::vector<CampaignOutcome> outcomes;  ///< Of these.
  std::vector<FeatureChange> changes;     ///< Against the base, on the meshes where both finished.
};

struct Gallery {
  std::vector<std::uint64_t> seeds;
  std::vector<MechanismDeclaration> mechanisms;
  std::vector<GalleryRuns> parts;  ///< Bases first, then by mechanism.
};

/// The runs of these bases and mechanisms, every mechanism where it acts, at its declared strong amplitude.
Gallery plan_gallery(const std::vector<std::filesystem::path>& bases,
                     const std::vector<MechanismDeclaration>& mechanisms, const std::vector<std::uint64_t>& seeds);

/// The base of an experiment; nullptr where the gallery has none.
const GalleryRuns* base_of(const Gallery& gallery, ExperimentType experiment);

/// Reads the finished runs' curves and compares them.
void compare_features(Gallery& gallery);

/// Draws curves/ and patterns/ and writes gallery.html, gallery.md and gallery.json into the folder; returns the page.
/// Throws Error(output).
std::filesystem::path write_gallery(const Gallery& gallery, const std::filesystem::path& folder);

}  // namespace asperity::app
