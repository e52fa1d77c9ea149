#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/confrontation/confront.hpp"
#include "tests/support/toy_laboratory.hpp"

/// A simulator and a laboratory for the whole driver of a confrontation.
namespace asperity::toy {

/// How a toy's mechanisms act: by their amplitude; by more than that; or such that parameters lose their effect with
/// it.
enum class Toy { linear, curved, bent };

/// A simulator whose runs are numbers: four tests of eight features that are linear in two parameters and six
/// mechanisms, with a scatter that a mesh has in common between runs.
class ToySimulator {
 public:
  explicit ToySimulator(Toy kind = Toy::linear) : kind_(kind) {
    RandomStream random(11, "toy simulator");
    jacobian_ = 3.0 * toy::normals(kTests * kFeatures, kParameters, random);
    fingerprint_ = 4.0 * toy::normals(kTests * kFeatures, kMechanisms, random);
  }

  /// Samples of one specimen.
  VectorXd values(const VirtualSpecimen& s) const {
    RandomStream random(s.seed, "mesh of " + std::to_string(s.test));
    VectorXd v = jacobian_.middleRows(first(s.test), kFeatures) * s.coded;
    for (const MechanismAmplitude& m : s.mechanisms) {
      const double a = kind_ == Toy::curved ? m.amplitude * (1.0 + 0.5 * m.amplitude) : m.amplitude;
      if (kind_ == Toy::bent) v *= 1.0 / (1.0 + m.amplitude);
      v += a * fingerprint_.col(m.id.back() - '0').segment(first(s.test), kFeatures);
    }
    return v + toy::normals(kFeatures, 1, random).col(0);
  }

  RunConfig configure(const VirtualSpecimen& s) {
    specimens_.push_back(s);
    RunConfig config;
    config.particles.seed = specimens_.size() - 1;
    return config;
  }

  std::vector<RunFeatureValues> features(const std::vector<CampaignRun>& runs) {
    std::vector<RunFeatureValues> all;
    for (const CampaignRun& run : runs) {
      const VectorXd v = values(specimens_[run.config.particles.seed]);
      RunFeatureValues row(feature_kinds(ExperimentType::uniaxial).size());
      for (Index f = 0; f < v.size(); ++f) row[static_cast<std::size_t>(f)] = v(f);
      all.push_back(row);
    }
    runs_ += runs.size();
    return all;
  }

  std::size_t runs() const { return runs_; }

  static constexpr int kTests = 4, kFeatures = 8, kParameters = 2, kMechanisms = 6;

 private:
  static Index first(std::size_t test) { return static_cast<Index>(test) * kFeatures; }
  Toy kind_;
  Eigen::MatrixXd jacobian_, fingerprint_;
  std::vector<VirtualSpecimen> specimens_;
  std::size_t runs_ = 0;
};

/// Six specimens a test of a laboratory with these parameters and mechanisms; the last test is kept back.
inline ConfrontationTask task_of(ToySimulator& simulator, const VectorXd& truth,
                                 std::vector<MechanismAmplitude> hidden) {
  ConfrontationTask task;
  for (std::size_t t = 0; t < ToySimulator::kTests; ++t) {
    TestEvidence test;
    test.id = "T" + std::to_string(t);
    test.use = t + 1 == ToySimulator::kTests ? TestUse::hold_out : TestUse::fit;
    for (int f = 0; f < ToySimulator::kFeatures; ++f) test.slots.push_back({toy::kind(f), false, 0.01});
    test.instrument_sd = VectorXd::Zero(ToySimulator::kFeatures);
    test.measured.resize(6, ToySimulator::kFeatures);
    for (std::uint64_t s = 0; s < 6; ++s)
      test.measured.row(static_cast<Index>(s)) = simulator.values({t, truth, hidden, 9000 + s}).transpose();
    task.evidence.tests.push_back(std::move(test));
    task.plan.parameter_acts.emplace_back(ToySimulator::kParameters, true);
    task.plan.candidate_acts.emplace_back(ToySimulator::kMechanisms, true);
  }
  for (int p = 0; p < ToySimulator::kParameters; ++p)
    task.evidence.parameters.push_back({"p" + std::to_string(p), -8.0, 8.0});
  for (int k = 0; k < ToySimulator::kMechanisms; ++k)
    task.evidence.candidates.push_back({"m" + std::to_string(k), 0.6, false, false, 3.0});
  task.plan.candidate_meshes.assign(ToySimulator::kMechanisms, 8);
  task.plan.apart = task.common;
  task.options.draws.draws = 200;
  task.configure = [&](const VirtualSpecimen& s) { return simulator.configure(s); };
  task.features = [&](const std::string&, const std::vector<CampaignRun>& runs) { return simulator.features(runs); };
  return task;
}

inline VectorXd truth() { return (VectorXd(2) << 2.6, -1.7).finished(); }

}  // namespace asperity::toy
