#pragma once
#include <filesystem>

/// Where this program lies and what was installed beside it.
namespace asperity::app {

inline constexpr const char* kSharedFolder =
    "asperity";  ///< Below PREFIX/share; the same name is in cmake/Install.cmake.

/// This program's file.
std::filesystem::path this_executable();

/// A file or folder that is shipped with the program, e.g. "configs/paper": below the working folder if it is there,
/// else below PREFIX/share/asperity of a program installed as PREFIX/bin/asperity, else as it was given.
std::filesystem::path shipped(const std::filesystem::path& name);

}  // namespace asperity::app
