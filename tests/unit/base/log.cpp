#include "core/base/log.hpp"

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/build_info.hpp"
#include "core/base/error.hpp"

using namespace asperity;

namespace {

std::filesystem::path scratch_file() {
  const std::filesystem::path folder = std::filesystem::path(ASPERITY_TEST_SCRATCH) / "log";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder / "log.txt";
}

std::string text_of(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

}  // namespace

TEST_CASE("the log file begins with revision and library versions, then has every message") {
  const std::filesystem::path path = scratch_file();
  set_log_echo(LogEcho::errors);
  open_log_file(path, {{"CGAL", "5.5"}, {"VTK", "9.1.0"}});
  log_info("meshed");
  log_warning("two stages hit {the time limit}");
  close_log_file();
  log_warning("nobody reads this");
  set_log_echo(LogEcho::warnings);
  const std::string text = text_of(path);
  CHECK(text.find("revision " + build_info().revision) < text.find('\n'));
  CHECK(text.find("CGAL 5.5 VTK 9.1.0") < text.find('\n'));
  CHECK(text.find("Z info: meshed\n") != std::string::npos);
  CHECK(text.find("Z warning: two stages hit {the time limit}\n") != std::string::npos);
  CHECK(text.find("nobody") == std::string::npos);
}

TEST_CASE("a resumed run appends to its log") {
  const std::filesystem::path path = scratch_file();
  open_log_file(path, {});
  log_info("first");
  open_log_file(path, {});
  log_info("second");
  close_log_file();
  const std::string text = text_of(path);
  CHECK(text.find("first") < text.find("second"));
}

TEST_CASE("a log file that cannot be opened is an output error") {
  try {
    open_log_file("/proc/no/log.txt", {});
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    CHECK(error.faults().at(0).where == "/proc/no/log.txt");
  }
}
