#include <vtkCallbackCommand.h>
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "core/base/error.hpp"
#include "render/vtu.hpp"

namespace asperity::render {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason) {
  throw Error(ErrorKind::output, "cannot read " + path.string() + ": " + reason);
}

void note_failure(vtkObject* /*caller*/, unsigned long /*event*/, void* failed, void* /*message*/) {
  *static_cast<bool*>(failed) = true;
}

/// One VTU file and its arrays, each asked for by name.
class VtuFile {
 public:
  explicit VtuFile(const std::filesystem::path& path) : path_(path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) fail(path, "no such file");
    bool failed = false;
    vtkNew<vtkCallbackCommand> listener;  // VTK would print its errors instead
    listener->SetCallback(note_failure);
    listener->SetClientData(&failed);
    reader_->AddObserver(vtkCommand::ErrorEvent, listener);
    reader_->SetReaderErrorObserver(listener);
    reader_->SetParserErrorObserver(listener);
    reader_->SetFileName(path.c_str());
    reader_->Update();
    if (failed || reader_->GetErrorCode() != 0) fail(path, "not a whole VTU file");
  }

  vtkUnstructuredGrid* grid() const { return reader_->GetOutput(); }
  std::size_t cells() const { return static_cast<std::size_t>(grid()->GetNumberOfCells()); }
  std::size_t points() const { return static_cast<std::size_t>(grid()->GetNumberOfPoints()); }

  vtkDataArray* cell_array(const char* name) const { return need(grid()->GetCellData(), name, cells()); }
  vtkDataArray* point_array(const char* name) const { return need(grid()->GetPointData(), name, points()); }

  bool has_numbers(const char* name) const { return grid()->GetFieldData()->GetArray(name) != nullptr; }

  std::vector<double> numbers(const char* name) const {
    vtkDataArray* array = grid()->GetFieldData()->GetArray(name);
    if (!array) fail(path_, std::string("no field data ") + name);
    std::vector<double> values(static_cast<std::size_t>(array->GetNumberOfTuples()));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
    return values;
  }

  double number(const char* name, std::size_t place = 0) const {
    const std::vector<double> values = numbers(name);
    if (place >= values.size()) fail(path_, std::string("field data ") + name + " is too short");
    return values[place];
  }

  std::string text(const char* name) const {
    auto* array = vtkStringArray::SafeDownCast(grid()->GetFieldData()->GetAbstractArray(name));
    if (!array || array->GetNumberOfValues() < 1) fail(path_, std::string("no field data ") + name);
    return array->GetValue(0);
  }

  [[noreturn]] void refuse(const std::string& reason) const { fail(path_, reason); }

 private:
  vtkDataArray* need(vtkFieldData* data, const char* name, std::size_t length) const {
    vtkDataArray* array = data->GetArray(name);
    // A file without cells may come back without arrays.
    if (!array && length > 0) fail(path_, std::string("no array ") + name);
    return array;
  }

  std::filesystem::path path_;
  vtkNew<vtkXMLUnstructuredGridReader> reader_;
};

Vec2 point_of(vtkUnstructuredGrid* grid, vtkIdType i) {
  double p[3];
  grid->GetPoint(i, p);
  return {p[0], p[1]};
}

std::vector<Vec2> vectors(vtkDataArray* array, std::size_t n) {
  std::vector<Vec2> out(n);
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = static_cast<vtkIdType>(i);
    out[i] = {array->GetComponent(at, 0), array->GetComponent(at, 1)};
  }
  return out;
}

template <class Value>
std::vector<Value> scalars(vtkDataArray* array, std::size_t n) {
  std::vector<Value> out(n);
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<Value>(array->GetComponent(static_cast<vtkIdType>(i), 0));
  return out;
}

void read_mesh(const VtuFile& file, Frame& frame) {
  frame.position.resize(file.points());
  for (std::size_t i = 0; i < file.points(); ++i) frame.position[i] = point_of(file.grid(), static_cast<vtkIdType>(i));
  frame.triangles.resize(file.cells());
  for (std::size_t i = 0; i < file.cells(); ++i) {
    vtkIdType count = 0;
    const vtkIdType* nodes = nullptr;
    file.grid()->GetCellPoints(static_cast<vtkIdType>(i), count, nodes);
    for (std::size_t c = 0; c < 3 && count == 3; ++c) frame.triangles[i][c] = static_cast<int>(nodes[c]);
  }
}

void read_cell_fields(const VtuFile& file, Frame& frame) {
  const std::size_t n = file.cells();
  vtkDataArray* stress = file.cell_array("stress");
  frame.stress.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t c = 0; c < 4; ++c)
      frame.stress[i][c] = stress->GetComponent(static_cast<vtkIdType>(i), static_cast<int>(c));
  frame.damage = scalars<double>(file.cell_array("damage"), n);
  frame.grain = scalars<int>(file.cell_array("grain"), n);
  frame.fragment = scalars<int>(file.cell_array("fragment"), n);
}

/// The ends of every cell, which must be a line.
std::vector<std::array<Vec2, 2>> line_ends(const VtuFile& file) {
  std::vector<std::array<Vec2, 2>> lines(file.cells());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    vtkIdType count = 0;
    const vtkIdType* ends = nullptr;
    file.grid()->GetCellPoints(static_cast<vtkIdType>(i), count, ends);
    if (count != 2) file.refuse("a cell is not a line of two points");
    lines[i] = {point_of(file.grid(), ends[0]), point_of(file.grid(), ends[1])};
  }
  return lines;
}

}  // namespace

void read_fields_vtu(const std::filesystem::path& path, Frame& frame) {
  const VtuFile file(path);
  read_mesh(file, frame);
  read_cell_fields(file, frame);
  frame.displacement = vectors(file.point_array("displacement"), file.points());
  frame.velocity = vectors(file.point_array("velocity"), file.points());
  frame.time_s = file.number("TimeValue");
  frame.experiment = file.text("experiment");
  frame.name = file.text("name");
  frame.axial_strain = file.number("axial_strain");
  frame.stress_mpa = file.number("axial_stress");
  frame.confining_pressure_mpa = file.number("confining_pressure");
  frame.platen_y = {file.number("platen_y", 0), file.number("platen_y", 1)};
  if (file.has_numbers("jaws")) {
    frame.jaws = {file.number("jaws", 0), file.number("jaws", 1), file.number("jaws", 2)};
  }
  if (file.has_numbers("joint")) {
    frame.joint = {file.number("joint", 0), file.number("joint", 1), file.number("joint", 2), file.number("joint", 3),
                   file.number("joint", 4), file.number("joint", 5)};
    if (file.has_numbers("strips")) {
      frame.joint.strips = static_cast<int>(file.number("strips", 0));
      frame.joint.pitch_mm = file.number("strips", 1);
    }
    frame.half = scalars<int>(file.cell_array("half"), frame.triangles.size());
  }
  frame.curve = {file.numbers("curve_axial_strain"), file.numbers("curve_lateral_strain"),
                 file.numbers("curve_stress")};
}

void read_cracks_vtu(const std::filesystem::path& path, Frame& frame) {
  const VtuFile file(path);
  const auto ends = line_ends(file);
  const std::size_t n = ends.size();
  const auto mode = scalars<int>(file.cell_array("mode"), n);
  const auto damage = scalars<double>(file.cell_array("damage"), n);
  const auto opening = scalars<double>(file.cell_array("opening"), n);
  const auto slip = scalars<double>(file.cell_array("slip"), n);
  const auto break_time = scalars<double>(file.cell_array("break_time"), n);
  const auto energy = scalars<double>(file.cell_array("energy"), n);
  frame.cracks.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    frame.cracks[i] = {ends[i][0], ends[i][1], CrackMode{mode[i]}, damage[i],
                       opening[i], slip[i],    break_time[i],      energy[i]};
}

void read_contacts_vtu(const std::filesystem::path& path, Frame& frame) {
  const VtuFile file(path);
  const auto ends = line_ends(file);
  const std::size_t n = ends.size();
  const auto normal = scalars<double>(file.cell_array("normal_force"), n);
  const auto shear = scalars<double>(file.cell_array("shear_force"), n);
  const auto kind = scalars<int>(file.cell_array("kind"), n);
  const auto point = vectors(file.cell_array("contact_point"), n);
  frame.contacts.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    frame.contacts[i] = {ends[i][0], ends[i][1], point[i], normal[i], shear[i], ContactKind{kind[i]}};
}

}  // namespace asperity::render
