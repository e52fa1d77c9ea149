#pragma once
#include <functional>
#include <vector>

#include "core/config/run_config.hpp"
#include "core/contact/law.hpp"

/// A contact law driven along paths of separations, point by point, by the functions that a run calls. What is read off
/// the paths (peaks, limits, energies) holds for whatever law was driven; no closed form is used.
namespace asperity {

/// One of the three laws with its parameters.
struct DrivenLaw {
  LawParameters parameters;
  LawReading reading = LawReading::consistent;
  LawForm form = LawForm::damage_slip;
};

/// The law of a run with what its mechanisms set; errors as law_parameters.
DrivenLaw driven_law(const RunConfig& config);

/// The same contact under other words of /contacts/law; errors as law_parameters.
DrivenLaw driven_law(RunConfig config, const LawConfig& law);

/// Brings a contact point to a new separation (mm) by its law.
void update_point(PointState& s, double normal, double shear, const DrivenLaw& law);

enum class PathLeg { loading, unloading, reloading };

/// A contact point at one moment of a path; separations mm (opening positive), tractions MPa (tension positive).
struct PathPoint {
  double opening = 0, slip = 0;
  double normal_traction = 0, shear_traction = 0;
  double damage = 0;
  bool broken = false;
  PathLeg leg = PathLeg::loading;
};

using LawPath = std::vector<PathPoint>;

/// Pure opening from rest to `last` (mm), on the way closed to zero and opened again at each of `unload_at` (ascending,
/// mm). `through` are further separations that the path meets exactly, such as a peak.
LawPath opening_path(const DrivenLaw& law, double last, const std::vector<double>& unload_at = {},
                     const std::vector<double>& through = {});

/// Closing without slip from rest to a pressure (MPa).
LawPath closing_path(const DrivenLaw& law, double pressure);

/// The separation (mm, below 0) at which a contact without slip bears a pressure (MPa). At no pressure it is just
/// closed, by less than rounding shows, because the literal law tells open from closed at 0.
double closed_separation(const DrivenLaw& law, double pressure);

/// Slip at constant closing under a pressure (MPa) from 0 to `last` (mm), on the way unloaded until the shear traction
/// is gone and loaded again at each of `unload_at` (ascending, mm).
LawPath shear_path(const DrivenLaw& law, double pressure, double last, const std::vector<double>& unload_at = {});

/// Where one straight path from rest meets the law's limits.
struct LawLimits {
  PathPoint first_damage;  ///< The last point without damage: where softening, or a drop, begins.
  PathPoint strongest;     ///< The largest traction while the bond holds.
  PathPoint last_bonded;   ///< The last point before the bond is broken.
  double friction = 0;     ///< Shear traction (MPa) at twice that point's slip; 0 in opening.
};

/// Opening and slip in the fixed proportion of a unit of `angle` (rad; 0 pure opening, pi/2 pure slip of an open
/// contact), measured over delta_ct and delta_cs.
LawLimits limits_in_opening(const DrivenLaw& law, double angle);

/// Slip under a constant pressure (MPa).
LawLimits limits_under_pressure(const DrivenLaw& law, double pressure);

/// Opening and slip in that proportion until the bond is broken.
LawPath mixed_path(const DrivenLaw& law, double angle);

/// Work of the tractions along a path's loading legs (N/mm, trapezoids): what it takes to get there the first time.
double loading_work(const LawPath& path);

}  // namespace asperity
