#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/calibration/analysis.hpp"
#include "core/calibration/elastic_compensation.hpp"
#include "core/calibration/refinement.hpp"
#include "core/calibration/test_suite.hpp"

/// A calibration that simulates the laboratory's tests (configs/schema/calibration.schema.json).
namespace asperity {

/// A further parameter set to be verified beside the chosen one: what is set differently, and why it is shown.
struct TradeOffSet {
  std::string name, why;
  std::vector<std::string> overrides;       ///< Laid over every test, below the microparameters.
  std::vector<std::string> disc_overrides;  ///< Laid over the Brazilian test only.
  Settings parameters;                      ///< Over the chosen microparameters.
};

/// Meshes that nothing was fitted to.
struct VerificationMeshes {
  std::size_t meshes = 5, trade_off_meshes = 3;
  std::uint64_t first_seed = 1001;
};

struct SimulatedCalibration {
  std::string name, description;
  std::string config_hash;  ///< Of the file with its overrides, but for where runs are computed.
  std::vector<Target> targets;
  std::vector<Factor> factors;
  StarDistance star = StarDistance::rotatable;
  std::size_t centre_points = 6;
  std::uint64_t first_seed = 1;
  std::size_t most_rounds = 3;  ///< Designs, the first included.
  AnalysisOptions analysis;
  TestSuite suite;
  ElasticTask elastic;  ///< Without its configuration, which the suite's uniaxial test gives.
  RefinementOptions refinement;
  VerificationMeshes verification;
  std::vector<TradeOffSet> trade_off;
  SlurmConfig slurm;
};

/// Whether the file is a calibration on data that are already there ("data"), not a simulated one.
bool is_data_calibration(const std::filesystem::path& path, const std::vector<std::string>& overrides);

/// Reads the file with the overrides ("/json/pointer=value", of its own keys). Throws one Error(config) with every
/// fault at its pointer: keys, ranges, missing targets, targets that exclude one another, a factor the model does not
/// have.
SimulatedCalibration read_simulated_calibration(const std::filesystem::path& path,
                                                const std::vector<std::string>& overrides = {});

/// The target of a property; nullptr where there is none.
const Target* find_target(const std::vector<Target>& targets, const std::string& property);

/// The targets that the factors are to meet: all strengths but the uniaxial one where C and phi, which imply it, are
/// given; E and nu are the elastic compensation's.
std::vector<Target> strength_targets(const std::vector<Target>& targets);

/// Uniaxial strength (MPa) of a Mohr-Coulomb material, Eq. (V1).
double mohr_coulomb_strength(double cohesion_mpa, double friction_angle_deg);

/// 2P/(pi D t) (MPa) at which the centre of a point-loaded elastic disc reaches the Mohr-Coulomb line, Eq. (V4).
double mohr_coulomb_disc_strength(double uniaxial_strength_mpa, double friction_angle_deg);

}  // namespace asperity
