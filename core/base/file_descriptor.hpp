#pragma once
#include <fcntl.h>
#include <sys/types.h>

#include <filesystem>
#include <string_view>

namespace asperity {

/// Owns one open POSIX file; not inherited by child processes.
class FileDescriptor {
 public:
  /// Opens with the flags of open(2); throws Error(output) saying `cannot be opened`.
  FileDescriptor(const std::filesystem::path& path, int flags, mode_t mode = 0666);
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  FileDescriptor(const FileDescriptor&) = delete;
  FileDescriptor& operator=(const FileDescriptor&) = delete;
  ~FileDescriptor();

  int get() const { return descriptor_; }
  const std::filesystem::path& path() const { return path_; }

  /// Writes all bytes at the present position; throws Error(output).
  void write_all(std::string_view bytes) const;
  /// Appends all bytes, or none where the disk is full; throws Error(output). For files opened with O_APPEND.
  void append_all(std::string_view bytes) const;
  /// Cuts the file; throws Error(output).
  void cut_to(off_t size) const;
  /// Waits until the bytes are on the disk; throws Error(output).
  void sync() const;

 private:
  std::filesystem::path path_;
  int descriptor_;
};

}  // namespace asperity
