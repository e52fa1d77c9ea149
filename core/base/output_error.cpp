#include "core/base/output_error.hpp"

#include <cerrno>
#include <system_error>

namespace asperity {
namespace {

std::string hint_for(int error_number) {
  switch (error_number) {
    case ENOSPC:
    case EDQUOT:
      return "free space on that disk, or choose another folder with --out";
    case EACCES:
    case EPERM:
    case EROFS:
      return "choose a folder you may write to with --out";
    default:
      return "";
  }
}

}  // namespace

Error output_error(const std::filesystem::path& path, const std::string& what, int error_number) {
  const std::string reason = std::generic_category().message(error_number);
  return Error(ErrorKind::output, {{path.string(), what + ": " + reason, "", "", hint_for(error_number)}});
}

}  // namespace asperity
