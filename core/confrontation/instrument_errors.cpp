#include "core/confrontation/instrument_errors.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kPercent = 0.01;
constexpr Index kScales = 2;  // load and path

/// A strength that is the laboratory's own number has its load cell's scale.
std::vector<double> scales_of(const SpecimenValue& specimen, const FeatureSlot& slot, const MeasuredTest& test) {
  const bool stress = slot.kind->unit == "MPa" || slot.kind->unit == "N/mm";
  if (!specimen.from_results || !stress) return specimen.errors.scales;
  return {kPercent * test.instrument.load_scale_percent * std::abs(*specimen.value)};
}

std::vector<double> own_errors(const SpecimenValue& specimen) {
  std::vector<double> own = specimen.errors.zeros;
  own.insert(own.end(), specimen.errors.noise.begin(), specimen.errors.noise.end());
  return own;
}

Index most_own_errors(const std::vector<const TestFeature*>& features) {
  std::size_t most = 0;
  for (const TestFeature* feature : features) {
    for (const SpecimenValue& s : feature->specimens)
      most = std::max(most, s.errors.zeros.size() + s.errors.noise.size());
  }
  return static_cast<Index>(most);
}

/// Whether the specimen gives a number to be compared.
bool compared(const SpecimenValue& specimen, const FeatureSlot& slot) {
  return specimen.value && (!slot.logarithmic || *specimen.value > 0.0);
}

double count_of(const TestFeature& feature, const FeatureSlot& slot) {
  const auto& all = feature.specimens;
  const auto count = std::count_if(all.begin(), all.end(), [&](const SpecimenValue& s) { return compared(s, slot); });
  return static_cast<double>(count);
}

void add(const std::vector<double>& errors, double factor, Index first, Eigen::Ref<VectorXd> column) {
  for (std::size_t r = 0; r < errors.size(); ++r) column(first + static_cast<Index>(r)) += factor * errors[r];
}

/// The same covariance by as few rows as there are columns.
MatrixXd fewest_rows(const MatrixXd& rows) {
  if (rows.rows() <= rows.cols()) return rows;
  return Eigen::HouseholderQR<MatrixXd>(rows).matrixQR().topRows(rows.cols()).triangularView<Eigen::Upper>();
}

}  // namespace

MeasuredErrors measured_errors(const std::vector<FeatureSlot>& slots, const std::vector<const TestFeature*>& features,
                               const MeasuredTest& test) {
  const auto specimens = static_cast<Index>(features.front()->specimens.size()),
             size = static_cast<Index>(slots.size());
  const Index own = most_own_errors(features);
  MatrixXd rows = MatrixXd::Zero(kScales + specimens * own, size);
  MeasuredErrors errors{{}, VectorXd::Zero(size)};
  for (Index column = 0; column < size; ++column) {
    const FeatureSlot& slot = slots[static_cast<std::size_t>(column)];
    const TestFeature& feature = *features[static_cast<std::size_t>(column)];
    const double count = count_of(feature, slot);
    for (Index i = 0; i < specimens; ++i) {
      const SpecimenValue& specimen = feature.specimens[static_cast<std::size_t>(i)];
      if (!compared(specimen, slot)) continue;
      const double share = (slot.logarithmic ? 1.0 / *specimen.value : 1.0) / count;
      add(scales_of(specimen, slot, test), share, 0, rows.col(column));
      add(own_errors(specimen), share, kScales + i * own, rows.col(column));
    }
    errors.own_sd(column) = std::sqrt(count) * rows.col(column).tail(specimens * own).norm();
  }
  errors.of_mean = fewest_rows(rows);
  return errors;
}

}  // namespace asperity
