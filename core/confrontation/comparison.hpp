#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/confrontation/evidence.hpp"

namespace asperity {

/// One test's part of a comparison: the slots [first, first + columns.size()).
struct ComparedTest {
  const TestEvidence* test = nullptr;
  std::vector<Eigen::Index> columns;  ///< Of the test's slots: those that are compared.
  Eigen::Index first = 0;
  Eigen::MatrixXd meshes;     ///< Runs of the base by slots, each column's mean taken off, with the spread of the runs.
  Eigen::Index averaged = 0;  ///< Number of runs of which the model's mean is.
};

/// A slot that is not compared, and why.
struct DroppedSlot {
  std::string test, feature, why;
};

/// Measured and simulated features side by side: vectors over all compared slots, test after test.
struct Comparison {
  std::vector<ComparedTest> tests;
  std::vector<DroppedSlot> dropped;
  std::vector<const FeatureSlot*> slots;
  std::vector<int> group;       ///< Slots of one kind of feature have one number.
  Eigen::VectorXd data, model;  ///< Means over specimens and over meshes.
  Eigen::VectorXd specimens;    ///< Number of measured values.
  Eigen::VectorXd meshes;       ///< Number of runs behind the model's mean.
  Eigen::VectorXd instrument_sd;
  Eigen::VectorXd own_sd;       ///< Of one specimen, by instruments' zeros and rows' noise.
  Eigen::MatrixXd jacobian;     ///< By coded parameter, central differences; Eq. (N7). One-sided at a limit.
  Eigen::MatrixXd curvature;    ///< By coded parameter, second differences that stand out of their error, else 0.
  Eigen::MatrixXd fingerprint;  ///< By candidate, a unit of amplitude; Eq. (N8).
  Eigen::MatrixXd beyond;       ///< By candidate, a unit of amplitude past its knee; Eq. (N21).
  Eigen::VectorXd first;        ///< By candidate: amplitude of its first runs ...
  Eigen::VectorXd reach;        ///< ... and of its second ones, below 0 on the other side of it; the first's: none.
  Eigen::VectorXd knee;  ///< By candidate: the first runs' amplitude, 0 where the second are below; infinite: none.
  std::vector<Eigen::MatrixXd> jacobian_rows;     ///< By parameter: common meshes by slots, less their mean.
  std::vector<Eigen::MatrixXd> fingerprint_rows;  ///< By candidate, likewise.
  std::vector<Eigen::MatrixXd> beyond_rows;       ///< By candidate, likewise.
};

/// What a candidate does at an amplitude, Eq. (N21); the rows are those of its error over common meshes.
Eigen::VectorXd effect_of(const Comparison& comparison, Eigen::Index candidate, double amplitude);
Eigen::MatrixXd effect_rows(const Comparison& comparison, Eigen::Index candidate, double amplitude);

/// What a further unit of amplitude does there, Eq. (N21).
Eigen::VectorXd slope_of(const Comparison& comparison, Eigen::Index candidate, double amplitude);

/// How far the parabola through a candidate's runs lies from the chords between them, by feature, Eq. (N22); zero
/// beyond the farthest runs, and where there are no second ones.
Eigen::VectorXd bend_of(const Comparison& comparison, Eigen::Index candidate, double amplitude);

/// A unit of amplitude on the way to the second runs.
Eigen::VectorXd secant_of(const Comparison& comparison, Eigen::Index candidate);

/// Rows less their mean; a missing value stands for none, and the others' spread is raised for it.
Eigen::VectorXd centred(const Eigen::VectorXd& column);

/// Of which runs the base's mean is: of all, or of those on other meshes than effects.
enum class BaseMean { all, apart };

/// Compares the tests of one use. A slot is left out where fewer than half of the specimens, or three quarters of the
/// base's runs, or half of a parameter's runs give a value, or where nothing scatters.
Comparison compare(const Evidence& evidence, TestUse use, BaseMean mean = BaseMean::all);

/// The model's mean at coded parameters: reference + J d + curvature d^2 / 2.
Eigen::VectorXd model_at(const Comparison& comparison, const Eigen::VectorXd& coded);

}  // namespace asperity
