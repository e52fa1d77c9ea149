#include "core/base/build_info.hpp"

#include "revision.inc"

namespace asperity {

const BuildInfo& build_info() {
  static const BuildInfo info{ASPERITY_VERSION,  kRevision,      kDirty,
                              ASPERITY_COMPILER, ASPERITY_FLAGS, ASPERITY_BUILD_TYPE};
  return info;
}

}  // namespace asperity
