#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "core/config/read_config.hpp"

namespace asperity::test {

/// What reading a text throws: its faults and its kind. No faults: it was accepted.
struct Refusal {
  std::optional<ErrorKind> kind;
  std::vector<Fault> faults;

  /// The only fault at this place, or an empty one.
  Fault at(const std::string& where) const {
    std::vector<Fault> found;
    for (const Fault& fault : faults)
      if (fault.where == where) found.push_back(fault);
    return found.size() == 1 ? found.front() : Fault{};
  }
};

inline Refusal refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    parse_run_config(text, "dir/some run.json", overrides);
    return {};
  } catch (const Error& error) {
    return {error.kind(), error.faults()};
  }
}

inline const std::string kDisc = R"({"experiment": {"type": "brazilian"}})";
inline const std::string kUniaxial = R"({"experiment": {"type": "uniaxial"}})";
inline const std::string kTriaxial = R"({"experiment": {"type": "triaxial", "confining_pressure_mpa": 0.5}})";

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace asperity::test
