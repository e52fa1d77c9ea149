#include "core/output/run_folder.hpp"

#include <catch2/catch.hpp>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "core/output/manifest.hpp"
#include "core/output/run_files.hpp"
#include "tests/unit/output/scratch.hpp"

using namespace asperity;
using asperity::testing::fresh_folder;
using asperity::testing::SmallFiles;

namespace fs = std::filesystem;

namespace {

const RunIdentity kClean{"config-1", "revision-1", false, ""};

Manifest manifest_of(const RunIdentity& identity, Outcome outcome) {
  Manifest manifest;
  manifest.config_name = "disc";
  manifest.config_hash = identity.config_hash;
  manifest.build.revision = identity.revision;
  manifest.build.dirty = identity.dirty;
  manifest.executable_sha256 = identity.executable_sha256;
  manifest.outcome = outcome;
  return manifest;
}

/// A folder as a run of this identity leaves it.
fs::path folder_with_run(const std::string& name, const RunIdentity& identity, Outcome outcome) {
  const fs::path root = fresh_folder(name);
  const RunFolder folder = RunFolder::begin(root, identity, ExistingRun::keep);
  write_manifest(folder.manifest(), manifest_of(identity, outcome));
  write_file_atomically(folder.curves(), "time_s\n");
  write_file_atomically(folder.frames() / "damage_000000.png", "png");
  write_file_atomically(folder.fields() / "fields_000000.vtu.tmp", "cut off");
  return root;
}

FolderUse use_of(const fs::path& root, const RunIdentity& identity) {
  return decide_folder_use(root, identity, ExistingRun::keep).use;
}

std::string refusal_of(const fs::path& root, const RunIdentity& identity, ExistingRun existing) {
  try {
    RunFolder::begin(root, identity, existing);
  } catch (const Error& error) {
    CHECK(error.kind() == ErrorKind::output);
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST_CASE("a folder that is absent or empty is used, with its parents") {
  const fs::path root = fresh_folder("rf_new") / "a" / "b";
  CHECK(use_of(root, kClean) == FolderUse::create);
  CHECK_FALSE(fs::exists(root));
  const RunFolder folder = RunFolder::begin(root, kClean, ExistingRun::keep);
  CHECK(folder.decision().use == FolderUse::create);
  CHECK_FALSE(folder.reused());
  for (const fs::path& path :
       {folder.fields(), folder.cracks(), folder.contacts(), folder.frames(), folder.plots(), folder.checkpoint()}) {
    CHECK(fs::is_directory(path));
  }
}

TEST_CASE("a finished run of the same configuration and code is re-used untouched") {
  const fs::path root = folder_with_run("rf_reuse", kClean, Outcome::finished);
  const RunFolder folder = RunFolder::begin(root, kClean, ExistingRun::keep);
  CHECK(folder.reused());
  CHECK(fs::exists(folder.frames() / "damage_000000.png"));
}

TEST_CASE("an unfinished run of the same configuration is started again") {
  const Outcome outcome = GENERATE(Outcome::running, Outcome::interrupted, Outcome::failed);
  const fs::path root = folder_with_run("rf_again", kClean, outcome);
  const RunFolder folder = RunFolder::begin(root, kClean, ExistingRun::keep);
  CHECK(folder.decision().use == FolderUse::restart);
  CHECK_FALSE(fs::exists(folder.curves()));
  CHECK_FALSE(fs::exists(folder.manifest()));
  CHECK(fs::is_empty(folder.frames()));
  CHECK(fs::is_empty(folder.fields()));
}

TEST_CASE("a finished run by another revision is made again") {
  const fs::path root = folder_with_run("rf_revision", kClean, Outcome::finished);
  RunIdentity newer = kClean;
  newer.revision = "revision-2";
  const FolderDecision decision = decide_folder_use(root, newer, ExistingRun::keep);
  CHECK(decision.use == FolderUse::restart);
  CHECK_THAT(decision.why, Catch::Contains("revision-1"));
}

TEST_CASE("a dirty build or one of unknown revision re-uses only what the same executable made") {
  const RunIdentity first = GENERATE(RunIdentity{"config-1", "revision-1", true, "executable-1"},
                                     RunIdentity{"config-1", "unknown", false, "executable-1"});
  const fs::path root = folder_with_run("rf_dirty", first, Outcome::finished);
  CHECK(use_of(root, first) == FolderUse::reuse);
  RunIdentity second = first;
  second.executable_sha256 = "executable-2";
  CHECK(use_of(root, second) == FolderUse::restart);
  second.executable_sha256 = "";
  CHECK(use_of(root, second) == FolderUse::restart);
  CHECK(use_of(root, kClean) == FolderUse::restart);
}

TEST_CASE("two dirty builds of which neither knows its executable are not the same code") {
  const RunIdentity dirty{"config-1", "revision-1", true, ""};
  CHECK(use_of(folder_with_run("rf_nameless", dirty, Outcome::finished), dirty) == FolderUse::restart);
}

TEST_CASE("another configuration in a used folder is refused unless forced") {
  const fs::path root = folder_with_run("rf_other", kClean, Outcome::finished);
  const RunIdentity other{"config-2", "revision-1", false, ""};
  CHECK_THAT(refusal_of(root, other, ExistingRun::keep),
             Catch::Contains("another configuration (found disc)") && Catch::Contains("--force"));
  CHECK(fs::exists(root / "curves.csv"));
  CHECK(RunFolder::begin(root, other, ExistingRun::replace).decision().use == FolderUse::restart);
  CHECK_FALSE(fs::exists(root / "curves.csv"));
}

TEST_CASE("force starts a finished run of the same configuration again") {
  const fs::path root = folder_with_run("rf_force", kClean, Outcome::finished);
  CHECK_FALSE(RunFolder::begin(root, kClean, ExistingRun::replace).reused());
  CHECK_FALSE(fs::exists(root / "curves.csv"));
}

TEST_CASE("clearing removes nothing that a user put there") {
  const fs::path root = folder_with_run("rf_user", kClean, Outcome::interrupted);
  const fs::path outside = fresh_folder("rf_user_outside");
  write_file_atomically(outside / "cracks_000000.vtu", "mine");
  const std::vector<fs::path> mine{"notes.txt", "plots/paper_figure.png", "frames/best.png", "mine/curves.csv"};
  fs::create_directory(root / "mine");
  for (const fs::path& file : mine) write_file_atomically(root / file, "mine");
  fs::remove_all(root / "cracks");
  fs::create_directory_symlink(outside, root / "cracks");
  RunFolder::begin(root, kClean, ExistingRun::replace);
  for (const fs::path& file : mine) CHECK(fs::exists(root / file));
  CHECK(fs::exists(outside / "cracks_000000.vtu"));
  CHECK_FALSE(fs::exists(root / "curves.csv"));
}

TEST_CASE("a folder with files and no manifest of ours is refused, forced or not") {
  const fs::path root = fresh_folder("rf_foreign");
  write_file_atomically(root / "manifest.json", "{\"name\": \"web app\"}");
  const ExistingRun existing = GENERATE(ExistingRun::keep, ExistingRun::replace);
  CHECK_THAT(refusal_of(root, kClean, existing), Catch::Contains("holds files that are no run of Asperity"));
  CHECK(std::distance(fs::directory_iterator(root), fs::directory_iterator()) == 1);
}

TEST_CASE("a run cut off before its manifest was written is started again") {
  const fs::path root = fresh_folder("rf_cut");
  write_file_atomically(RunFolder::begin(root, kClean, ExistingRun::keep).original_config(), "{}");
  CHECK(use_of(root, kClean) == FolderUse::restart);
  write_file_atomically(root / "notes.txt", "mine");
  CHECK_THAT(refusal_of(root, kClean, ExistingRun::replace), Catch::Contains("no run of Asperity"));
}

TEST_CASE("a second writer is turned away and told who writes") {
  const fs::path root = fresh_folder("rf_lock");
  {
    const RunFolder folder = RunFolder::begin(root, kClean, ExistingRun::keep);
    CHECK_THAT(refusal_of(root, kClean, ExistingRun::keep),
               Catch::Contains("another run writes there (found process") && Catch::Contains(" on "));
    write_manifest(folder.manifest(), manifest_of(kClean, Outcome::running));
    CHECK_THAT(refusal_of(root, kClean, ExistingRun::replace), Catch::Contains("another run writes there"));
    CHECK_THROWS_WITH(RunFolder::open(root), Catch::Contains("another run writes there"));
    CHECK(fs::exists(folder.manifest()));
  }
  CHECK_FALSE(RunFolder::begin(root, kClean, ExistingRun::keep).reused());
}

TEST_CASE("open takes a run as it lies there") {
  const fs::path root = folder_with_run("rf_open", kClean, Outcome::interrupted);
  CHECK(fs::exists(RunFolder::open(root).curves()));
  CHECK_THROWS_WITH(RunFolder::open(root / "frames"), Catch::Contains("is no run folder of Asperity"));
  CHECK_THROWS_WITH(RunFolder::open(root / "none"), Catch::Contains("is no run folder of Asperity"));
}

TEST_CASE("a path that is a file, and a folder that cannot be made, are output errors") {
  const fs::path root = fresh_folder("rf_file");
  write_file_atomically(root / "file", "x");
  CHECK_THAT(refusal_of(root / "file", kClean, ExistingRun::keep), Catch::Contains("is no folder"));
  CHECK_THAT(refusal_of("/proc/no/run", kClean, ExistingRun::keep), Catch::Contains("/proc/no/run: cannot be created"));
}

TEST_CASE("a run cut off before its manifest is told from one that has begun and from a stranger's folder") {
  const fs::path root = fresh_folder("rf_at_start");
  CHECK_FALSE(cut_off_at_start(root));
  const RunFolder folder = RunFolder::begin(root, kClean, ExistingRun::keep);
  CHECK_FALSE(cut_off_at_start(root));
  write_file_atomically(folder.effective_config(), "{}");
  CHECK(cut_off_at_start(root));
  write_manifest(folder.manifest(), manifest_of(kClean, Outcome::running));
  CHECK_FALSE(cut_off_at_start(root));
}

TEST_CASE("a folder that was removed, moved or replaced meanwhile is noticed") {
  const fs::path root = fresh_folder("rf_moved"), elsewhere = fresh_folder("rf_moved_to");
  const RunFolder folder = RunFolder::begin(root, kClean, ExistingRun::keep);
  CHECK_NOTHROW(folder.require_in_place());
  fs::rename(root, elsewhere);
  CHECK_THROWS_WITH(folder.require_in_place(), Catch::StartsWith(root.string() + ": was removed, moved or replaced"));
  const RunFolder other = RunFolder::begin(root, kClean, ExistingRun::keep);
  CHECK_NOTHROW(other.require_in_place());
  CHECK_THROWS_AS(folder.require_in_place(), Error);
}

TEST_CASE("a finished run is cleared only after its manifest says that it is no longer whole") {
  const fs::path root = folder_with_run("rf_marked", kClean, Outcome::finished);
  {
    const SmallFiles limit(200);  // enough for the lock's line, too little for a manifest
    CHECK_THROWS_WITH(RunFolder::begin(root, kClean, ExistingRun::replace), Catch::Contains("manifest.json"));
  }
  CHECK(fs::exists(root / "curves.csv"));
  CHECK(use_of(root, kClean) == FolderUse::reuse);
}

TEST_CASE("files of a run are known by their exact names") {
  CHECK(is_run_file("frames/cracks_000012.png"));
  CHECK(is_run_file("frames/cracks_000012.jpg"));
  CHECK(is_run_file("contacts/contacts_000012.vtu"));
  CHECK(is_run_file("contacts.pvd"));
  CHECK(is_run_file("measured.csv"));
  CHECK(is_run_file("plots/stress_strain.svg"));
  CHECK(is_run_file("plots/crack_rose.csv"));
  CHECK(is_run_file("fragments.csv"));
  CHECK(is_run_file("fields.pvd.tmp"));
  CHECK_FALSE(is_run_file("frames/cracks_12.png"));
  CHECK_FALSE(is_run_file("curves.csv.bak"));
  CHECK_FALSE(is_run_file("sub/curves.csv"));
  CHECK_FALSE(is_run_file("plots/mine.csv"));
  CHECK_FALSE(is_run_file(kLockName));
}

TEST_CASE("the default folder lies in outputs/ and cannot leave it") {
  CHECK(default_run_folder("quickstart") == fs::path("outputs") / "quickstart");
  const std::string name = GENERATE("", ".", "..", "../x", "a/b", "/etc");
  CHECK_THROWS_AS(default_run_folder(name), Error);
}

TEST_CASE("this executable's identity names the configuration's bytes and the code") {
  const RunIdentity identity = identity_of("ab12");
  CHECK(identity.config_hash == "ab12");
  CHECK_FALSE((identity.dirty && identity.executable_sha256.empty()));
  CHECK(same_code(identity, started_manifest()));
}
