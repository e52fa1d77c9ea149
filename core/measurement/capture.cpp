#include "core/measurement/capture.hpp"

#include "core/measurement/contact_forces.hpp"
#include "core/measurement/crack_network.hpp"
#include "core/measurement/fragments.hpp"

namespace asperity {
namespace {

/// Mean damage of the contact edges around each triangle; Eq. (M10).
std::vector<double> triangle_damage(const System& system) {
  std::vector<double> sum(system.particles.triangle_count(), 0.0);
  std::vector<int> count(sum.size(), 0);
  for (std::size_t c = 0; c < system.contacts.size(); ++c) {
    const ContactEdge& e = system.contacts.edges[c];
    for (int t : {e.left_triangle(), e.right_triangle()}) {
      sum[t] += edge_damage(system.contacts.points(c));
      ++count[t];
    }
  }
  for (std::size_t t = 0; t < sum.size(); ++t) sum[t] = count[t] > 0 ? sum[t] / count[t] : 0.0;
  return sum;
}

}  // namespace

const char* experiment_name(ExperimentType type) {
  switch (type) {
    case ExperimentType::uniaxial:
      return "uniaxial";
    case ExperimentType::triaxial:
      return "triaxial";
    case ExperimentType::brazilian:
      return "brazilian";
    case ExperimentType::direct_shear:
      return "direct_shear";
  }
  return "";
}

Frame capture_frame(const System& system, const RunConfig& config, std::span<const Sample> samples, int index) {
  const Particles& p = system.particles;
  Frame frame;
  frame.index = index;
  frame.time_s = system.time;
  frame.experiment = experiment_name(config.experiment.type);
  frame.name = config.name;
  if (!samples.empty()) {
    frame.axial_strain = samples.back().axial_strain;
    frame.stress_mpa = samples.back().stress_mpa;
  }
  frame.confining_pressure_mpa = system.flank.pressure;
  frame.position = p.position;
  frame.velocity = p.velocity;
  for (std::size_t i = 0; i < p.node_count(); ++i) frame.displacement.push_back(p.position[i] - p.reference(i));
  frame.triangles = p.triangles;
  for (std::size_t t = 0; t < p.triangle_count(); ++t) frame.stress.push_back(triangle_stress(p, t));
  frame.damage = triangle_damage(system);
  frame.grain = p.grain;
  frame.fragment = find_fragments(system.contacts, p).of_triangle;
  frame.cracks = crack_segments(system.contacts, p);
  const double thickness = strip_thickness(config);
  for (CrackSegment& crack : frame.cracks) crack.energy_n_mm *= thickness;
  frame.contacts = bonded_contact_forces(system.contacts, p, thickness);
  const std::vector<ContactForce> general = general_contact_forces(system.general, p, thickness);
  frame.contacts.insert(frame.contacts.end(), general.begin(), general.end());
  frame.platen_y = system.platens.y;
  const JawFace& jaw = system.platens.jaw;
  frame.jaws = {jaw.radius, jaw.centre_x, jaw.half_width};
  for (const Sample& s : samples) {
    frame.curve.axial_strain.push_back(s.axial_strain);
    frame.curve.lateral_strain.push_back(s.lateral_strain);
    frame.curve.stress_mpa.push_back(s.stress_mpa);
  }
  return frame;
}

}  // namespace asperity
