#pragma once
#include <string>

namespace asperity {

/// The date of the revision this executable was built from, YYYY-MM-DD; without git the day of the build.
std::string revision_date();

}  // namespace asperity
