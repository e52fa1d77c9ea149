#pragma once
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "core/base/error.hpp"
#include "tests/support/measured_folder.hpp"

/// Refusals of measured files.
namespace asperity::measured {

/// The faults of a document; none where it is accepted.
inline std::vector<Fault> faults_of(const Folder& folder, const json& document) {
  try {
    folder.read(document);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::config);
    return error.faults();
  }
  return {};
}

/// Exactly one fault, there, in these words, with a hint or what is allowed.
inline void check_one(const std::vector<Fault>& faults, const std::string& where, const std::string& what) {
  std::string all;
  for (const Fault& fault : faults) all += describe(fault) + "\n";
  CAPTURE(all, where, what);
  REQUIRE(faults.size() == 1);
  CHECK_THAT(faults.front().where, Catch::EndsWith(where));
  CHECK_THAT(faults.front().what, Catch::Contains(what));
  CHECK(!(faults.front().hint + faults.front().allowed).empty());
}

}  // namespace asperity::measured
