#include "core/confrontation/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kSpecimenShare = 0.5, kBaseShare = 0.75, kCommonShare = 0.5;
constexpr double kCurvatureErrors = 5.0;  // standard errors: of 8 meshes one in 640 passes by scatter alone
constexpr Index kCurvatureMeshes = 6;     // fewer know their own error too badly for that

/// Finite values of a column with their rows' mean.
struct Column {
  std::vector<double> values;
  double mean = 0;
};

Column finite_values(const VectorXd& column) {
  Column c;
  for (const double v : column) {
    if (std::isfinite(v)) c.values.push_back(v);
  }
  for (const double v : c.values) c.mean += v / static_cast<double>(c.values.size());
  return c;
}

double share_of(const Column& column, Index rows) {
  return static_cast<double>(column.values.size()) / static_cast<double>(std::max<Index>(rows, 1));
}

bool enough_pairs(const VectorXd& differences) {
  const Column c = finite_values(differences);
  return c.values.size() >= 2 && share_of(c, differences.size()) >= kCommonShare;
}

VectorXd common_of(const TestEvidence& test, Index column, Index rows) { return test.base.col(column).head(rows); }

/// Why a slot is not compared; empty where it is.
std::string fault_of(const TestEvidence& test, Index column) {
  const Column measured = finite_values(test.measured.col(column)), base = finite_values(test.base.col(column));
  if (measured.values.empty()) return "not measured";
  if (share_of(measured, test.measured.rows()) < kSpecimenShare) return "measured on fewer than half of the specimens";
  if (base.values.size() < 3 || share_of(base, test.base.rows()) < kBaseShare)
    return "given by fewer than three quarters of the simulated runs";
  for (const std::vector<Samples>* side : {&test.low, &test.high}) {
    for (const Samples& runs : *side) {
      if (runs.rows() == 0) continue;
      if (!enough_pairs(runs.col(column) - common_of(test, column, runs.rows())))
        return "lost by half of the runs where a parameter is moved";
    }
  }
  const auto [least, most] = std::minmax_element(base.values.begin(), base.values.end());
  if (*least == *most && test.slots[static_cast<std::size_t>(column)].floor_sd <= 0.0) return "the same in every run";
  return "";
}

int group_number(std::vector<const FeatureKind*>& kinds, const FeatureKind* kind) {
  const auto same = [&](const FeatureKind* k) { return k->name == kind->name; };
  const auto found = std::find_if(kinds.begin(), kinds.end(), same);
  if (found != kinds.end()) return static_cast<int>(found - kinds.begin());
  kinds.push_back(kind);
  return static_cast<int>(kinds.size()) - 1;
}

void choose_slots(const Evidence& evidence, TestUse use, BaseMean mean, Comparison& comparison) {
  std::vector<const FeatureKind*> kinds;
  for (const TestEvidence& test : evidence.tests) {
    if (test.use != use) continue;
    const Index averaged = test.base.rows() - (mean == BaseMean::apart ? test.apart : 0);
    ComparedTest part{&test, {}, static_cast<Index>(comparison.slots.size()), {}, averaged};
    for (Index c = 0; c < static_cast<Index>(test.slots.size()); ++c) {
      const FeatureSlot& slot = test.slots[static_cast<std::size_t>(c)];
      const std::string fault = fault_of(test, c);
      if (!fault.empty()) {
        comparison.dropped.push_back({test.id, std::string(slot.kind->name), fault});
        continue;
      }
      part.columns.push_back(c);
      comparison.slots.push_back(&slot);
      comparison.group.push_back(group_number(kinds, slot.kind));
    }
    if (!part.columns.empty()) comparison.tests.push_back(std::move(part));
  }
}

void take_means(Comparison& comparison) {
  const auto size = static_cast<Index>(comparison.slots.size());
  for (VectorXd* v : {&comparison.data, &comparison.model, &comparison.specimens, &comparison.meshes,
                      &comparison.instrument_sd, &comparison.own_sd})
    v->setZero(size);
  for (ComparedTest& part : comparison.tests) {
    const TestEvidence& test = *part.test;
    part.meshes.resize(test.base.rows(), static_cast<Index>(part.columns.size()));
    for (Index i = 0; i < static_cast<Index>(part.columns.size()); ++i) {
      const Index column = part.columns[static_cast<std::size_t>(i)], at = part.first + i;
      const Column measured = finite_values(test.measured.col(column));
      const Column base = finite_values(test.base.col(column).tail(part.averaged));
      comparison.data(at) = measured.mean;
      comparison.model(at) = base.mean;
      comparison.specimens(at) = static_cast<double>(measured.values.size());
      comparison.meshes(at) = static_cast<double>(base.values.size());
      comparison.instrument_sd(at) = test.instrument_sd(column);
      if (test.own_sd.size() > 0) comparison.own_sd(at) = test.own_sd(column);
      part.meshes.col(i) = centred(test.base.col(column));
    }
  }
}

/// Differences of runs to the base on common meshes, for every slot; zero where a test has none.
struct Differences {
  VectorXd mean;
  MatrixXd rows;  ///< Less their mean.
};

using RunsOf = const Samples& (*)(const TestEvidence&, std::size_t);

Differences differences(const Comparison& comparison, std::size_t item, RunsOf runs_of) {
  const auto size = static_cast<Index>(comparison.slots.size());
  Index meshes = 0;
  for (const ComparedTest& part : comparison.tests) meshes = std::max(meshes, runs_of(*part.test, item).rows());
  Differences d{VectorXd::Zero(size), MatrixXd::Zero(meshes, size)};
  for (const ComparedTest& part : comparison.tests) {
    const Samples& runs = runs_of(*part.test, item);
    if (runs.rows() == 0) continue;
    for (std::size_t i = 0; i < part.columns.size(); ++i) {
      const Index column = part.columns[i], at = part.first + static_cast<Index>(i);
      const VectorXd change = runs.col(column) - common_of(*part.test, column, runs.rows());
      if (!enough_pairs(change)) continue;
      d.mean(at) = finite_values(change).mean;
      d.rows.col(at).head(runs.rows()) = centred(change);
    }
  }
  return d;
}

/// Second differences within five of their errors are scatter, and all of them where meshes are few.
VectorXd believed(const VectorXd& mean, const MatrixXd& rows) {
  VectorXd kept = VectorXd::Zero(mean.size());
  const double n = static_cast<double>(rows.rows());
  if (rows.rows() < kCurvatureMeshes) return kept;
  for (Index i = 0; i < mean.size(); ++i) {
    const double error = std::sqrt(rows.col(i).squaredNorm() / (n * std::max(n - 1.0, 1.0)));
    if (std::abs(mean(i)) > kCurvatureErrors * error) kept(i) = mean(i);
  }
  return kept;
}

void take_parameters(const Evidence& evidence, Comparison& comparison) {
  const auto size = static_cast<Index>(comparison.slots.size());
  const std::size_t count = evidence.parameters.size();
  comparison.jacobian = comparison.curvature = MatrixXd::Zero(size, static_cast<Index>(count));
  for (std::size_t p = 0; p < count; ++p) {
    const auto low_runs = [](const TestEvidence& t, std::size_t k) -> const Samples& { return t.low[k]; };
    const auto high_runs = [](const TestEvidence& t, std::size_t k) -> const Samples& { return t.high[k]; };
    const Differences low = differences(comparison, p, low_runs), high = differences(comparison, p, high_runs);
    if (low.rows.rows() != high.rows.rows()) {
      const double side = high.rows.rows() > 0 ? 1.0 : -1.0;
      const Differences& one = side > 0.0 ? high : low;
      comparison.jacobian.col(static_cast<Index>(p)) = side * one.mean;
      comparison.jacobian_rows.push_back(side * one.rows);
      continue;
    }
    comparison.jacobian.col(static_cast<Index>(p)) = 0.5 * (high.mean - low.mean);
    comparison.curvature.col(static_cast<Index>(p)) = believed(high.mean + low.mean, high.rows + low.rows);
    comparison.jacobian_rows.push_back(0.5 * (high.rows - low.rows));
  }
}

/// Changes past the knee by a unit of amplitude; where the second runs tell nothing, as on the way to the first.
void take_beyond(const TestEvidence& test, const ComparedTest& part, std::size_t k, const Candidate& candidate,
                 Comparison& comparison) {
  const bool other_side = candidate.far < 0.0;
  const Samples &near = other_side ? test.base : test.mechanism[k], &far = test.far[k];
  const Index meshes = std::min(near.rows(), far.rows());
  const double way = candidate.far - (other_side ? 0.0 : candidate.amplitude);
  for (std::size_t i = 0; i < part.columns.size(); ++i) {
    const Index column = part.columns[i], at = part.first + static_cast<Index>(i), of = static_cast<Index>(k);
    const VectorXd change = far.col(column).head(meshes) - near.col(column).head(meshes);
    if (!enough_pairs(change)) continue;
    comparison.beyond(at, of) = finite_values(change).mean / way;
    comparison.beyond_rows[k].col(at).head(meshes) = centred(change) / way;
  }
}

void take_candidates(const Evidence& evidence, Comparison& comparison) {
  const auto size = static_cast<Index>(comparison.slots.size());
  const std::size_t count = evidence.candidates.size();
  comparison.fingerprint = MatrixXd::Zero(size, static_cast<Index>(count));
  comparison.knee = VectorXd::Constant(static_cast<Index>(count), std::numeric_limits<double>::infinity());
  comparison.first = comparison.reach = VectorXd::Zero(static_cast<Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    const auto runs = [](const TestEvidence& t, std::size_t item) -> const Samples& { return t.mechanism[item]; };
    const Differences d = differences(comparison, k, runs);
    const double amplitude = evidence.candidates[k].amplitude;
    comparison.fingerprint.col(static_cast<Index>(k)) = d.mean / amplitude;
    comparison.fingerprint_rows.push_back(d.rows / amplitude);
    comparison.first(static_cast<Index>(k)) = comparison.reach(static_cast<Index>(k)) = amplitude;
  }
  comparison.beyond = comparison.fingerprint;
  comparison.beyond_rows = comparison.fingerprint_rows;
  for (const ComparedTest& part : comparison.tests) {
    for (std::size_t k = 0; k < part.test->far.size(); ++k) {
      if (part.test->far[k].rows() == 0) continue;
      const Candidate& candidate = evidence.candidates[k];
      comparison.knee(static_cast<Index>(k)) = candidate.far < 0.0 ? 0.0 : candidate.amplitude;
      comparison.reach(static_cast<Index>(k)) = candidate.far;
      take_beyond(*part.test, part, k, candidate, comparison);
    }
  }
}

bool past_knee(const Comparison& comparison, Index k, double amplitude) {
  return comparison.reach(k) < 0.0 ? amplitude < comparison.knee(k) : amplitude > comparison.knee(k);
}

}  // namespace

VectorXd centred(const VectorXd& column) {
  const Column c = finite_values(column);
  VectorXd rows = VectorXd::Zero(column.size());
  if (c.values.empty()) return rows;
  const double raise = std::sqrt(1.0 / share_of(c, column.size()));
  for (Index r = 0; r < column.size(); ++r) {
    if (std::isfinite(column(r))) rows(r) = raise * (column(r) - c.mean);
  }
  return rows;
}

Comparison compare(const Evidence& evidence, TestUse use, BaseMean mean) {
  Comparison comparison;
  choose_slots(evidence, use, mean, comparison);
  take_means(comparison);
  take_parameters(evidence, comparison);
  take_candidates(evidence, comparison);
  return comparison;
}

VectorXd effect_of(const Comparison& comparison, Index k, double amplitude) {
  const double near = past_knee(comparison, k, amplitude) ? comparison.knee(k) : amplitude;
  return near * comparison.fingerprint.col(k) + (amplitude - near) * comparison.beyond.col(k);
}

MatrixXd effect_rows(const Comparison& comparison, Index k, double amplitude) {
  const double near = past_knee(comparison, k, amplitude) ? comparison.knee(k) : amplitude;
  const auto at = static_cast<std::size_t>(k);
  return near * comparison.fingerprint_rows[at] + (amplitude - near) * comparison.beyond_rows[at];
}

VectorXd bend_of(const Comparison& comparison, Index k, double amplitude) {
  const double knee = comparison.knee(k);
  const double least = std::min(comparison.reach(k), 0.0), most = std::max(comparison.reach(k), comparison.first(k));
  if (!std::isfinite(knee) || amplitude <= least || amplitude >= most) return VectorXd::Zero(comparison.data.size());
  const double end = amplitude <= knee ? least : most;
  const double way = (amplitude - knee) * (amplitude - end) / (most - least);
  return way * (slope_of(comparison, k, most) - slope_of(comparison, k, least));
}

VectorXd slope_of(const Comparison& comparison, Index k, double amplitude) {
  return past_knee(comparison, k, amplitude) ? comparison.beyond.col(k) : comparison.fingerprint.col(k);
}

VectorXd secant_of(const Comparison& comparison, Index k) {
  return effect_of(comparison, k, comparison.reach(k)) / comparison.reach(k);
}

VectorXd model_at(const Comparison& comparison, const VectorXd& coded) {
  return comparison.model + comparison.jacobian * coded +
         0.5 * (comparison.curvature * coded.array().square().matrix());
}

}  // namespace asperity
