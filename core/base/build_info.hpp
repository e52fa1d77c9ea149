#pragma once
#include <string>

namespace asperity {

/// What this executable was built from; every manifest records it.
struct BuildInfo {
  std::string version;
  std::string revision;  ///< git commit, the one recorded at packaging, or "unknown".
  bool dirty;            ///< Tracked files differed from the revision.
  std::string compiler;
  std::string flags;
  std::string build_type;
};

const BuildInfo& build_info();

}  // namespace asperity
