#include "core/base/revision_date.hpp"

#include "revision.inc"

namespace asperity {

std::string revision_date() { return kRevisionDate; }

}  // namespace asperity
