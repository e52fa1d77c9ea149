#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "core/base/units.hpp"
#include "core/config/read_config.hpp"
#include "core/contact/closed_forms.hpp"
#include "core/mechanism/mechanism.hpp"

namespace asperity::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFirstM = 8, kLastM = 12, kFirstN = 13, kLastN = 18;  // Table 7

Json json_of(const DerivedParameters& d) {
  return {{"tensile_stiffness_gpa_per_mm", d.k_t / units::kMpaPerGpa},
          {"shear_stiffness_gpa_per_mm", d.k_s / units::kMpaPerGpa},
          {"fracture_energy_n_per_mm", d.g_f},
          {"mixed_mode_energy_n_per_mm", d.g_mixed},
          {"cohesive_zone_thickness_sliding_mm", d.w_sliding},
          {"cohesive_zone_thickness_mm", d.w},
          {"critical_tensile_displacement_mm", d.delta_ct},
          {"critical_shear_displacement_mm", d.delta_cs},
          {"ultimate_tensile_displacement_mm", d.delta_ut}};
}

Json beta_table() {
  Json rows = Json::array();
  for (int m = kFirstM; m <= kLastM; ++m) {
    for (int n = kFirstN; n <= kLastN; ++n) rows.push_back({{"m", m}, {"n", n}, {"beta", closed_forms::beta(m, n)}});
  }
  return rows;
}

void print_row(const char* name, const char* equation, double stress, double strain) {
  std::cout << fmt::format("{:<46}{:<14}{:>14.6g}{:>14.6g}\n", name, equation, stress, strain);
}

void print_parameters(const DerivedParameters& a, const DerivedParameters& b) {
  std::cout << fmt::format("{:<46}{:<14}{:>14}{:>14}\n", "", "equation", "plane stress", "plane strain");
  print_row("k_t [GPa/mm]", "12, 13", a.k_t / units::kMpaPerGpa, b.k_t / units::kMpaPerGpa);
  print_row("k_s [GPa/mm]", "12, 13", a.k_s / units::kMpaPerGpa, b.k_s / units::kMpaPerGpa);
  print_row("G_f = K_IC^2 / E~ [N/mm]", "34 (mode I)", a.g_f, b.g_f);
  print_row("G_f of both modes [N/mm]", "34", a.g_mixed, b.g_mixed);
  print_row("w, cohesive zone, pure tension [mm]", "32, 35", a.w, b.w);
  print_row("w, cohesive zone, pure sliding [mm]", "32, 36", a.w_sliding, b.w_sliding);
  print_row("delta_ct [mm]", "4", a.delta_ct, b.delta_ct);
  print_row("delta_cs [mm]", "7", a.delta_cs, b.delta_cs);
  print_row("delta_ut [mm]", "10", a.delta_ut, b.delta_ut);
}

void print_elastic(const RunConfig& config) {
  const MaterialConfig& m = config.material;
  std::cout << fmt::format(
      "\nE_p = E = {:g} GPa, nu_p = nu = {:g} (15); this config uses E_p = {:g} GPa, nu_p = {:g}\n",
      m.youngs_modulus_gpa, m.poissons_ratio, config.particles.youngs_modulus_gpa, config.particles.poissons_ratio);
  std::cout << fmt::format(
      "k_s / k_t from Eqs 12, 13: {:.4f}; Eq 14 as printed gives {:.4f}: its toughness ratio is inverted\n",
      closed_forms::stiffness_ratio(m), closed_forms::stiffness_ratio_as_printed(m));
}

void print_beta_table() {
  std::cout << "\nbeta(m, n), Eq 33 (the paper's Table 7)\n   m";
  for (int n = kFirstN; n <= kLastN; ++n) std::cout << fmt::format("  n = {:<3d}", n);
  double sum = 0.0;
  for (int m = kFirstM; m <= kLastM; ++m) {
    std::cout << fmt::format("\n{:4d}", m);
    for (int n = kFirstN; n <= kLastN; ++n) {
      sum += closed_forms::beta(m, n);
      std::cout << fmt::format("  {:<7.4f}", closed_forms::beta(m, n));
    }
  }
  const int count = (kLastM - kFirstM + 1) * (kLastN - kFirstN + 1);
  std::cout << fmt::format("\nmean {:.4f}\n", sum / count);
}

/// The chain of Eqs 20-32 for one pair of exponents, with zeta = epsilon = gamma = w = a_z = 1; its last entry is w
/// again.
void print_bond_chain(int m, int n) {
  using namespace closed_forms;
  const double x_0 = equilibrium_separation(m, n);
  const double p_c = cohesive_force(m, n);
  const double g_f = bond_fracture_energy_from_force(1.0, 1.0, 1.0, p_c, m, n);
  const double strength = bond_strength(1.0, p_c, x_0);
  std::cout << fmt::format("{:4d}{:4d}", m, n);
  for (double value :
       {lennard_jones_alpha(m, n), peak_force_separation(m, n), p_c, x_0, bond_density(1.0, x_0), strength,
        bond_energy(1.0, 1.0, m, n), bonds_in_zone(1.0, 1.0, 1.0, x_0), bond_fracture_energy(1.0, 1.0, 1.0, x_0), g_f,
        cohesive_zone_thickness(g_f, strength, beta(m, n))}) {
    std::cout << fmt::format("{:13.4f}", value);
  }
  std::cout << "\n";
}

void print_lennard_jones() {
  std::cout << "\nFrom the Lennard-Jones potential (20) to w (32), with zeta = epsilon = gamma = w = a_z = 1\n   m   n";
  for (const char* head : {"alpha (21)", "x_m (23)", "P_c (22,24)", "x_0 (25)", "n_b (26)", "sigma_t (27)", "U (28)",
                           "n_bc (29)", "G_f (30)", "G_f (31)", "w (32)"}) {
    std::cout << fmt::format("{:>13}", head);
  }
  std::cout << "\n";
  for (const auto& [m, n] : {std::pair{6, 12}, {8, 13}, {10, 15}, {12, 18}}) print_bond_chain(m, n);
}

}  // namespace

int derive_command(const DeriveOptions& options) {
  const RunConfig config = with_mechanisms(read_run_config(options.config, options.overrides));
  const DerivedParameters stress = derive(config, PlaneCondition::stress);
  const DerivedParameters strain = derive(config, PlaneCondition::strain);
  if (options.json) {
    const MaterialConfig& m = config.material;
    const Json j{{"plane_stress", json_of(stress)},
                 {"plane_strain", json_of(strain)},
                 {"stiffness_ratio", closed_forms::stiffness_ratio(m)},
                 {"stiffness_ratio_as_printed", closed_forms::stiffness_ratio_as_printed(m)},
                 {"beta_table", beta_table()}};
    std::cout << j.dump(2) << "\n";
    return 0;
  }
  print_parameters(stress, strain);
  print_elastic(config);
  print_beta_table();
  print_lennard_jones();
  return 0;
}

}  // namespace asperity::app
