#pragma once
#include <string>
#include <vector>

#include "app/report/joint_numbers.hpp"

namespace asperity::app {

/// One closed form of a joint's strength beside what was simulated, and why the two differ: sentences made of the run's
/// own numbers, which say no more than these bear out.
struct FormBeside {
  std::string name, equation;  ///< "sliding up the flanks", "C61".
  double predicted_mpa = 0;    ///< Infinite: not this way.
  double simulated_mpa = 0;
  std::string simulated_name;  ///< "peak", "residual", "applied".
  std::string why;
};

/// All that apply: those of several teeth only where there are several, all but the transition on the plan area.
std::vector<FormBeside> forms_beside(const JointNumbers& numbers);

}  // namespace asperity::app
