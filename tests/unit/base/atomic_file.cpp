#include "core/base/atomic_file.hpp"

#include <catch2/catch.hpp>

#include "core/base/error.hpp"
#include "tests/unit/output/scratch.hpp"

using namespace asperity;
using asperity::testing::fresh_folder;

namespace fs = std::filesystem;

TEST_CASE("an atomic write replaces the file and leaves nothing beside it") {
  const fs::path folder = fresh_folder("atomic");
  write_file_atomically(folder / "a.json", "old");
  write_file_atomically(folder / "a.json", std::string("new\0bytes", 9));
  CHECK(read_file(folder / "a.json") == std::string("new\0bytes", 9));
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
}

TEST_CASE("a write that fails leaves the old file, and says path and reason") {
  const fs::path folder = fresh_folder("atomic_full");
  write_file_atomically(folder / "a.json", "old");
  fs::create_symlink("/dev/full", folder / "a.json.tmp");
  try {
    write_file_atomically(folder / "a.json", "new");
    FAIL("no error");
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    CHECK_THAT(error.what(),
               Catch::Contains("a.json") && Catch::Contains("cannot be written: No space left on device"));
    CHECK_THAT(error.what(), Catch::Contains("--out"));
  }
  CHECK(read_file(folder / "a.json") == "old");
  CHECK_FALSE(fs::is_symlink(folder / "a.json.tmp"));
}

TEST_CASE("writing into a folder that is not there is an output error") {
  const fs::path path = fresh_folder("atomic_none") / "no" / "a.json";
  CHECK_THROWS_WITH(write_file_atomically(path, "x"), Catch::Contains("cannot be opened: No such file or directory"));
  CHECK_THROWS_AS(read_file(path), Error);
}
