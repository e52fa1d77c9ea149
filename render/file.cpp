#include "render/file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

#include "core/base/error.hpp"

namespace asperity::render {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error(ErrorKind::output, "cannot write " + path.string() + ": " + reason);
}

/// 0, or the errno of what failed.
int put(const std::filesystem::path& path, std::string_view bytes) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return errno;
  errno = 0;
  const bool all = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  const int write_error = all ? 0 : (errno ? errno : EIO);
  const int close_error = std::fclose(file) == 0 ? 0 : errno;
  return write_error ? write_error : close_error;
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) fail(path, error.message());
  std::filesystem::path beside = path;
  beside += ".part";
  if (const int reason = put(beside, bytes)) {
    std::filesystem::remove(beside, error);
    fail(path, std::strerror(reason));
  }
  std::filesystem::rename(beside, path, error);
  if (!error) return;
  const std::string reason = error.message();
  std::filesystem::remove(beside, error);
  fail(path, reason);
}

}  // namespace asperity::render
