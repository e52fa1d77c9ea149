#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace asperity {

/// What the log repeats on stderr: warnings and errors, or errors only. The log file gets everything.
enum class LogEcho { warnings, errors };

/// Chooses what reaches stderr from now on; at program start it is LogEcho::warnings.
void set_log_echo(LogEcho echo);

/// Adds a log file, appending to it, and heads it with version, revision, build and library versions ("CGAL" -> "5.5").
/// Closes the one before. Call it from one thread only. Throws Error(output) where the file cannot be opened.
void open_log_file(const std::filesystem::path& path, const std::map<std::string, std::string>& libraries);

/// Ends the log file; later messages go to stderr alone.
void close_log_file();

void log_info(std::string_view message);
void log_warning(std::string_view message);
void log_error(std::string_view message);

}  // namespace asperity
