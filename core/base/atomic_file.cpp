#include "core/base/atomic_file.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>

#include "core/base/file_descriptor.hpp"
#include "core/base/output_error.hpp"

namespace asperity {
namespace {

void write_and_sync(const std::filesystem::path& path, std::string_view bytes) {
  const FileDescriptor file(path, O_WRONLY | O_CREAT | O_TRUNC);
  file.write_all(bytes);
  file.sync();
}

/// The rename itself is on the disk only after its folder is.
void sync_folder_of(const std::filesystem::path& path) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  FileDescriptor(folder, O_RDONLY | O_DIRECTORY).sync();
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, std::string_view bytes) {
  std::filesystem::path beside = path;
  beside += ".tmp";
  try {
    write_and_sync(beside, bytes);
    if (std::rename(beside.c_str(), path.c_str()) != 0) throw output_error(path, "cannot be replaced", errno);
  } catch (const Error&) {
    ::unlink(beside.c_str());
    throw;
  }
  sync_folder_of(path);
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directory(folder, error);
  if (error) throw output_error(folder, "cannot be created", error.value());
}

std::string read_file(const std::filesystem::path& path) {
  const FileDescriptor file(path, O_RDONLY);
  std::string bytes;
  std::array<char, 65536> chunk;
  for (;;) {
    const ssize_t got = ::read(file.get(), chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw output_error(path, "cannot be read", errno);
    if (got == 0) return bytes;
    bytes.append(chunk.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace asperity
