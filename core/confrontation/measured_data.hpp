#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/confrontation/preparation.hpp"
#include "core/measurement/curve.hpp"

namespace asperity {

/// Whether a test is fitted or kept back to judge the fit.
enum class TestUse { fit, hold_out };

/// Where the scatter of a test's features is taken from.
enum class ScatterSource {
  pooled,    ///< From like features of all tests.
  specimens  ///< From this test's own specimens, two or more.
};

/// Standard deviations of a laboratory's instruments. Those not given are these.
struct Instrument {
  double load_noise_percent = 0.5;          ///< Of the largest load, each row by itself.
  double displacement_noise_percent = 0.1;  ///< Of the largest displacement or strain, each row by itself.
  double transverse_noise_percent = 0.5;    ///< The same of lateral strain and dilation.
  double load_scale_percent = 1.0;          ///< Of the load, the whole curve alike.
  double displacement_scale_percent = 1.0;  ///< Of displacement and strain, the whole curve alike.
  double load_zero_percent = 0.2;           ///< Of the largest load, the whole curve alike.
  double displacement_zero_mm = 0.02;       ///< The whole curve alike.
  bool operator==(const Instrument&) const = default;
};

/// The curve of one specimen and where it stands.
struct SpecimenCurve {
  std::string specimen;
  Curve curve;
  std::vector<std::size_t> lines;  ///< Of each row in the file, from 1.
};

/// One laboratory test: curves, numbers or both, of one or more specimens.
struct MeasuredTest {
  std::string id;
  std::string note;
  ExperimentType experiment = ExperimentType::uniaxial;
  std::optional<double> width_mm, height_mm, diameter_mm, thickness_mm;
  std::optional<double> confining_pressure_mpa;  ///< Triaxial.
  std::optional<double> normal_stress_mpa;       ///< Direct shear.
  std::vector<ToothConfig> profile;              ///< Direct shear.
  std::optional<double> end_gap_mm;              ///< Direct shear: flat part behind the last tooth.
  std::optional<double> closing_rate_mm_per_s, shear_rate_mm_per_s;
  std::optional<double> axial_gauge_mm;  ///< Length of the gauge whose strain axial_strain (or gauge_axial_strain) is.
  std::optional<PlaneCondition> plane;   ///< Compression: the specimen's; unset: free all round.
  std::optional<TestUse> use;            ///< Unset: the user leaves it to the split.
  ScatterSource scatter = ScatterSource::pooled;
  Preparation preparation;
  bool ends_before_peak = false;  ///< The specimen was not taken to its peak, so the curve's end is no fault.
  Instrument instrument;
  std::vector<SpecimenCurve> curves;
  std::map<std::string, std::vector<double>> results;  ///< By feature, one value a specimen; NaN where not measured.
  std::filesystem::path curve_file;                    ///< Empty without curves.
};

/// A laboratory's file.
struct MeasuredData {
  std::string name, material, source, licence, description;
  std::vector<MeasuredTest> tests;
};

/// Whether axial_strain of the test's curves is that of a gauge on the specimen.
bool path_is_gauge(const MeasuredTest& test);

/// How the curves of a test are read, by its loading and its instruments.
CurveReading reading_of(const MeasuredTest& test);

/// Specimens of a test: those of its curves, or as many as its results have values.
std::vector<std::string> specimens_of(const MeasuredTest& test);

}  // namespace asperity
