#pragma once
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/confrontation/read_measured.hpp"
#include "core/confrontation/test_features.hpp"

/// Measured files for tests.
namespace asperity::measured {

using nlohmann::json;
namespace fs = std::filesystem;

/// A folder with curve files for one test case.
class Folder {
 public:
  explicit Folder(const std::string& name) : root_(fs::path(ASPERITY_TEST_SCRATCH) / "measured" / name) {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void put(const std::string& name, const std::string& text) const { std::ofstream(root_ / name) << text; }
  MeasuredData read(const json& document) const { return parse_measured_data(document.dump(), root_ / "data.json"); }
  std::string file(const std::string& name) const { return (root_ / name).string(); }

 private:
  fs::path root_;
};

/// Rows of a curve that rises to 10 at path 1 and falls to 4 at path 2, scaled.
inline std::string triangle(const std::string& header, double path = 1.0, double load = 1.0,
                            const std::string& before = "", const std::string& after = "") {
  std::string text = header + "\n";
  for (int i = 0; i <= 20; ++i) {
    const double q = i <= 10 ? i : 10.0 - 0.6 * (i - 10);
    text += before + std::to_string(0.1 * i * path) + "," + std::to_string(q * load) + after + "\n";
  }
  return text;
}

inline json uniaxial(const std::string& curve) {
  return {{"tests", {{{"id", "U"}, {"experiment", "uniaxial"}, {"height_mm", 100}, {"curve", curve}}}}};
}

/// Mean of a feature over the specimens of a test; it has to be there.
inline double mean_of(const MeasuredTest& test, const std::string& name) {
  for (const TestFeature& f : features_of(test)) {
    if (f.kind->name == name && f.count > 0) return f.mean;
  }
  FAIL(name << " is not there");
  return 0.0;
}

}  // namespace asperity::measured
