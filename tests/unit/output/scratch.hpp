#pragma once
#include <filesystem>
#include <string>

namespace asperity::testing {

/// An empty folder of this name for one test case.
inline std::filesystem::path fresh_folder(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / "output" / name;
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

}  // namespace asperity::testing
