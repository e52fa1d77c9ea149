#pragma once
#include <filesystem>

namespace asperity {

/// Name of the file that processes lock while they write a run folder. It stays there: removing it would race.
inline constexpr const char* kLockName = ".asperity.lock";

/// Whether a run may have written this file, by its path relative to the run folder ("frames/damage_000012.png").
bool is_run_file(const std::filesystem::path& relative);

enum class FolderContent { vacant, run_files, foreign };

/// What a folder holds beside the lock file and empty subfolders of a run: nothing, only files that a run may have
/// written, or also others.
FolderContent content_of(const std::filesystem::path& root);

/// Removes the files a run may have written and nothing else; does not follow links. Throws Error(output).
void clear_run_files(const std::filesystem::path& root);

/// Creates fields/, cracks/, contacts/, frames/, plots/ and checkpoint/. Throws Error(output).
void create_run_subfolders(const std::filesystem::path& root);

}  // namespace asperity
