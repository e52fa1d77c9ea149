#pragma once
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// A coefficient with its digits as printed, "-0.10".
struct PublishedTerm {
  std::string name;  ///< "1", "x1", "x1x2", "x1^2"
  std::string coefficient;
};

/// A regression equation, term by term as printed, misprints included.
struct PublishedEquation {
  std::string property, label;
  std::vector<PublishedTerm> terms;
};

/// What the authors of a calibration said of it, for the audit.
struct Published {
  std::string source;
  std::vector<PublishedEquation> equations;
  std::vector<double> coded;            ///< Their solution.
  std::vector<std::string> parameters;  ///< The same decoded, with its digits as printed.
  /// Relative standard deviation they found on several meshes, by property.
  std::vector<std::pair<std::string, double>> scatter;
};

}  // namespace asperity
