#include <catch2/catch.hpp>
#include <fstream>

#include "core/base/atomic_file.hpp"
#include "core/base/error.hpp"
#include "render/series.hpp"
#include "tests/render/picture_file.hpp"
#include "tests/support/synthetic_frame.hpp"

namespace fs = std::filesystem;
using namespace asperity;
using namespace asperity::render;

namespace {

Frame frame_at(double time_s) {
  Frame frame = test::synthetic_disc();
  frame.time_s = time_s;
  return frame;
}

ErrorKind kind_thrown(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind();
  }
  FAIL("nothing was thrown");
  return ErrorKind::unexpected;
}

int files_in(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

void check_same_cracks(const std::vector<CrackSegment>& a, const std::vector<CrackSegment>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool same = a[i].a == b[i].a && a[i].b == b[i].b && a[i].mode == b[i].mode && a[i].damage == b[i].damage &&
                      a[i].opening_mm == b[i].opening_mm && a[i].slip_mm == b[i].slip_mm &&
                      a[i].break_time_s == b[i].break_time_s && a[i].energy_n_mm == b[i].energy_n_mm;
    REQUIRE(same);
  }
}

void check_same_contacts(const std::vector<ContactForce>& a, const std::vector<ContactForce>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool same = a[i].a == b[i].a && a[i].b == b[i].b && a[i].point == b[i].point &&
                      a[i].normal_n == b[i].normal_n && a[i].shear_n == b[i].shear_n && a[i].kind == b[i].kind;
    REQUIRE(same);
  }
}

}  // namespace

TEST_CASE("A frame comes back from its VTU files bit for bit") {
  const fs::path run = test::scratch("render_round_trip");
  Frame written = test::synthetic_rectangle();
  written.time_s = 0.1 + 0.2;
  written.name = "names & <marks> σ₁";
  SeriesWriter(run).write(written);
  const Frame read = read_frame(run, 0);
  CHECK(read.time_s == written.time_s);
  CHECK(series_times(run) == std::vector<double>{written.time_s});
  CHECK(read.experiment == written.experiment);
  CHECK(read.name == written.name);
  CHECK(read.axial_strain == written.axial_strain);
  CHECK(read.stress_mpa == written.stress_mpa);
  CHECK(read.confining_pressure_mpa == written.confining_pressure_mpa);
  CHECK(read.platen_y == written.platen_y);
  CHECK((read.position == written.position));
  CHECK((read.displacement == written.displacement));
  CHECK((read.velocity == written.velocity));
  CHECK((read.triangles == written.triangles));
  CHECK((read.stress == written.stress));
  CHECK(read.damage == written.damage);
  CHECK(read.grain == written.grain);
  CHECK(read.fragment == written.fragment);
  CHECK(read.curve.axial_strain == written.curve.axial_strain);
  CHECK(read.curve.lateral_strain == written.curve.lateral_strain);
  CHECK(read.curve.stress_mpa == written.curve.stress_mpa);
  check_same_cracks(read.cracks, written.cracks);
  check_same_contacts(read.contacts, written.contacts);
}

TEST_CASE("Jaws come back from the files, and flat platens leave no trace of them") {
  Frame frame = test::synthetic_disc();
  const fs::path flat = test::scratch("render_flat"), curved = test::scratch("render_jaws");
  SeriesWriter(flat).write(frame);
  CHECK(read_frame(flat, 0).jaws == FrameJaws{});
  CHECK(read_file(flat / "fields" / "fields_000000.vtu").find("jaws") == std::string::npos);
  frame.jaws = {40.5, 0.25, 27};
  SeriesWriter(curved).write(frame);
  CHECK(read_frame(curved, 0).jaws == frame.jaws);
}

// render_independent_reader opens what this test leaves.
TEST_CASE("A series lists every frame, with and without cracks, contacts or curve") {
  const fs::path run = test::scratch("render_series");
  SeriesWriter writer(run);
  Frame intact = frame_at(0);
  intact.cracks.clear();
  intact.contacts.clear();
  intact.curve = {};
  writer.write(intact);
  writer.write(frame_at(1.0 / 3));
  writer.write(frame_at(0.5));
  CHECK(series_times(run) == std::vector<double>{0, 1.0 / 3, 0.5});
  CHECK(read_frame(run, 0).cracks.empty());
  CHECK(read_frame(run, 0).curve.axial_strain.empty());
  CHECK(read_frame(run, 0).contacts.empty());
  CHECK(read_frame(run, 1).cracks.size() > 100);
  CHECK(read_frame(run, 1).contacts.size() > 1000);
  CHECK(files_in(run / "fields") == 3);
}

TEST_CASE("A resumed series keeps its first frames and drops those after the checkpoint") {
  const fs::path run = test::scratch("render_resume");
  SeriesWriter first(run);
  for (const double time : {0.0, 1.0, 2.0, 3.0}) first.write(frame_at(time));
  const std::string kept = test::file_bytes(run / "fields/fields_000001.vtu");
  SeriesWriter second(run, 2);
  CHECK(second.size() == 2);
  CHECK(series_times(run) == std::vector<double>{0, 1});
  CHECK(files_in(run / "cracks") == 2);
  CHECK(files_in(run / "contacts") == 2);
  second.write(frame_at(1.5));
  CHECK(series_times(run) == std::vector<double>{0, 1, 1.5});
  CHECK(read_frame(run, 2).time_s == 1.5);
  CHECK(test::file_bytes(run / "fields/fields_000001.vtu") == kept);
  CHECK(kind_thrown([&] { SeriesWriter(run, 4); }) == ErrorKind::output);
}

TEST_CASE("A run without a series of contacts can be read, and not be continued") {
  const fs::path run = test::scratch("render_no_contacts");
  SeriesWriter(run).write(frame_at(0));
  fs::remove_all(run / "contacts");
  CHECK(kind_thrown([&] { read_frame(run, 0); }) == ErrorKind::output);
  fs::remove(run / "contacts.pvd");
  CHECK(read_frame(run, 0).cracks.size() > 100);
  CHECK(read_frame(run, 0).contacts.empty());
  CHECK(kind_thrown([&] { SeriesWriter(run, 1); }) == ErrorKind::output);
}

TEST_CASE("The same frame gives the same bytes") {
  const fs::path a = test::scratch("render_same_a"), b = test::scratch("render_same_b");
  SeriesWriter(a).write(frame_at(1));
  SeriesWriter(b).write(frame_at(1));
  for (const char* file :
       {"fields/fields_000000.vtu", "cracks/cracks_000000.vtu", "contacts/contacts_000000.vtu", "contacts.pvd"})
    CHECK(test::file_bytes(a / file) == test::file_bytes(b / file));
}

TEST_CASE("A folder that cannot be written is an output error that names it, and leaves nothing") {
  const fs::path folder = test::scratch("render_unwritable");
  std::ofstream(folder / "file") << "not a folder";
  CHECK(kind_thrown([&] { SeriesWriter(folder / "file"); }) == ErrorKind::output);
  CHECK_THROWS_WITH(write_file_atomically(folder / "file/x.png", "bytes"), Catch::Contains("file/x.png"));
  fs::create_directories(folder / "taken.png");  // renaming onto a folder fails after the bytes are written
  CHECK(kind_thrown([&] { write_file_atomically(folder / "taken.png", "bytes"); }) == ErrorKind::output);
  CHECK(files_in(folder) == 2);
}

TEST_CASE("A failed frame leaves the series as it was") {
  const fs::path run = test::scratch("render_failed_frame");
  SeriesWriter writer(run);
  writer.write(frame_at(0));
  fs::create_directories(run / "cracks/cracks_000001.vtu");
  CHECK(kind_thrown([&] { writer.write(frame_at(1)); }) == ErrorKind::output);
  CHECK(writer.size() == 1);
  CHECK(series_times(run) == std::vector<double>{0});
}

TEST_CASE("Missing and damaged files are output errors") {
  const fs::path run = test::scratch("render_damaged");
  CHECK(kind_thrown([&] { series_times(run); }) == ErrorKind::output);
  CHECK(kind_thrown([&] { read_frame(run, 0); }) == ErrorKind::output);
  SeriesWriter(run).write(frame_at(0));
  CHECK(kind_thrown([&] { read_frame(run, 1); }) == ErrorKind::output);
  const std::string whole = test::file_bytes(run / "fields/fields_000000.vtu");
  write_file_atomically(run / "fields/fields_000000.vtu", whole.substr(0, whole.size() / 2));
  CHECK(kind_thrown([&] { read_frame(run, 0); }) == ErrorKind::output);
  write_file_atomically(run / "fields/fields_000000.vtu", "no XML at all");
  CHECK(kind_thrown([&] { read_frame(run, 0); }) == ErrorKind::output);
  write_file_atomically(run / "fields.pvd", "<VTKFile>");
  CHECK(kind_thrown([&] { series_times(run); }) == ErrorKind::output);
}
