#include "core/base/file_descriptor.hpp"

#include <unistd.h>

#include <cerrno>
#include <utility>

#include "core/base/output_error.hpp"

namespace asperity {

FileDescriptor::FileDescriptor(const std::filesystem::path& path, int flags, mode_t mode)
    : path_(path), descriptor_(::open(path.c_str(), flags | O_CLOEXEC, mode)) {
  if (descriptor_ < 0) throw output_error(path_, "cannot be opened", errno);
}

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void FileDescriptor::write_all(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw output_error(path_, "cannot be written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void FileDescriptor::append_all(std::string_view bytes) const {
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  try {
    write_all(bytes);
  } catch (const Error&) {
    cut_to(before);
    throw;
  }
}

void FileDescriptor::cut_to(off_t size) const {
  if (::ftruncate(descriptor_, size) != 0) throw output_error(path_, "cannot be cut", errno);
}

void FileDescriptor::sync() const {
  // Pipes and devices have nothing to sync and answer EINVAL.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) throw output_error(path_, "cannot be written", errno);
}

}  // namespace asperity
