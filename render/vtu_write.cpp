#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include <cmath>
#include <vector>

#include "render/vtu.hpp"

namespace asperity::render {
namespace {

vtkIdType id(std::size_t i) { return static_cast<vtkIdType>(i); }

void add_text(vtkFieldData* data, const char* name, const std::vector<std::string>& lines) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& line : lines) array->InsertNextValue(line);
  data->AddArray(array);
}

void add_numbers(vtkFieldData* data, const char* name, const std::vector<double>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (const double value : values) array->InsertNextValue(value);
  data->AddArray(array);
}

/// value(i) for n cells or points, as one double each.
template <class Value>
void add_scalars(vtkFieldData* data, const char* name, std::size_t n, const Value& value) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(id(n));
  for (std::size_t i = 0; i < n; ++i) array->SetValue(id(i), value(i));
  data->AddArray(array);
}

template <class Value>
void add_integers(vtkFieldData* data, const char* name, std::size_t n, const Value& value) {
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfValues(id(n));
  for (std::size_t i = 0; i < n; ++i) array->SetValue(id(i), value(i));
  data->AddArray(array);
}

void add_vectors(vtkFieldData* data, const char* name, const std::vector<Vec2>& vectors) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(id(vectors.size()));
  const char* components[] = {"x", "y", "z"};
  for (int c = 0; c < 3; ++c) array->SetComponentName(c, components[c]);
  for (std::size_t i = 0; i < vectors.size(); ++i) array->SetTuple3(id(i), vectors[i].x, vectors[i].y, 0);
  data->AddArray(array);
}

/// (xx, yy, zz, xy) as ParaView's symmetric tensor (xx, yy, zz, xy, yz, xz).
void add_tensors(vtkFieldData* data, const std::vector<std::array<double, 4>>& stress) {
  vtkNew<vtkDoubleArray> array;
  array->SetName("stress");
  array->SetNumberOfComponents(6);
  array->SetNumberOfTuples(id(stress.size()));
  const char* components[] = {"xx", "yy", "zz", "xy", "yz", "xz"};
  for (int c = 0; c < 6; ++c) array->SetComponentName(c, components[c]);
  for (std::size_t i = 0; i < stress.size(); ++i) {
    const double tensor[6] = {stress[i][0], stress[i][1], stress[i][2], stress[i][3], 0, 0};
    array->SetTuple(id(i), tensor);
  }
  data->AddArray(array);
}

void add_head(vtkFieldData* data, const Frame& frame, const std::vector<std::string>& units) {
  add_numbers(data, "TimeValue", {frame.time_s});
  add_text(data, "experiment", {frame.experiment});
  add_text(data, "name", {frame.name});
  add_text(data, "units", units);
}

void add_curve(vtkFieldData* data, const Frame& frame) {
  add_numbers(data, "axial_strain", {frame.axial_strain});
  add_numbers(data, "axial_stress", {frame.stress_mpa});
  add_numbers(data, "confining_pressure", {frame.confining_pressure_mpa});
  add_numbers(data, "platen_y", {frame.platen_y[0], frame.platen_y[1]});
  const FrameJaws& jaws = frame.jaws;
  if (jaws.radius_mm > 0.0) add_numbers(data, "jaws", {jaws.radius_mm, jaws.centre_x_mm, jaws.half_width_mm});
  const FrameJoint& j = frame.joint;
  if (j.length_mm > 0.0) {
    add_numbers(data, "joint", {j.length_mm, j.rise_mm, j.range_mm, j.shear_mm, j.dilation_mm, j.lift_mm});
    if (j.strips > 1) add_numbers(data, "strips", {static_cast<double>(j.strips), j.pitch_mm});
  }
  add_numbers(data, "curve_axial_strain", frame.curve.axial_strain);
  add_numbers(data, "curve_lateral_strain", frame.curve.lateral_strain);
  add_numbers(data, "curve_stress", frame.curve.stress_mpa);
}

void add_cell_fields(vtkFieldData* data, const Frame& frame) {
  const std::size_t n = frame.triangles.size();
  add_tensors(data, frame.stress);
  add_scalars(data, "principal_stress_max", n, [&](auto i) { return principal_stress(frame.stress[i]).major; });
  add_scalars(data, "principal_stress_min", n, [&](auto i) { return principal_stress(frame.stress[i]).minor; });
  add_scalars(data, "max_shear_stress", n, [&](auto i) { return principal_stress(frame.stress[i]).max_shear(); });
  add_scalars(data, "damage", n, [&](auto i) { return frame.damage[i]; });
  add_integers(data, "grain", n, [&](auto i) { return frame.grain[i]; });
  add_integers(data, "fragment", n, [&](auto i) { return frame.fragment[i]; });
  if (!frame.half.empty()) add_integers(data, "half", n, [&](auto i) { return frame.half[i]; });
}

void add_crack_fields(vtkFieldData* data, const std::vector<CrackSegment>& cracks) {
  const std::size_t n = cracks.size();
  add_integers(data, "mode", n, [&](auto i) { return static_cast<int>(cracks[i].mode); });
  add_scalars(data, "damage", n, [&](auto i) { return cracks[i].damage; });
  add_scalars(data, "opening", n, [&](auto i) { return cracks[i].opening_mm; });
  add_scalars(data, "slip", n, [&](auto i) { return cracks[i].slip_mm; });
  add_scalars(data, "break_time", n, [&](auto i) { return cracks[i].break_time_s; });
  add_scalars(data, "energy", n, [&](auto i) { return cracks[i].energy_n_mm; });
}

std::vector<Vec2> contact_points(const std::vector<ContactForce>& contacts) {
  std::vector<Vec2> points;
  for (const ContactForce& contact : contacts) points.push_back(contact.point);
  return points;
}

void add_contact_fields(vtkFieldData* data, const std::vector<ContactForce>& contacts) {
  const std::size_t n = contacts.size();
  add_scalars(data, "normal_force", n, [&](auto i) { return contacts[i].normal_n; });
  add_scalars(data, "shear_force", n, [&](auto i) { return contacts[i].shear_n; });
  add_integers(data, "kind", n, [&](auto i) { return static_cast<int>(contacts[i].kind); });
  add_vectors(data, "contact_point", contact_points(contacts));
}

vtkNew<vtkPoints> double_points() {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  return points;
}

/// One VTK_LINE from a to b for each.
template <class Line>
vtkNew<vtkUnstructuredGrid> line_grid(const std::vector<Line>& lines) {
  vtkNew<vtkUnstructuredGrid> grid;
  const auto points = double_points();
  grid->AllocateExact(id(lines.size()), id(2 * lines.size()));
  for (const Line& line : lines) {
    const vtkIdType ends[2] = {points->InsertNextPoint(line.a.x, line.a.y, 0),
                               points->InsertNextPoint(line.b.x, line.b.y, 0)};
    grid->InsertNextCell(VTK_LINE, 2, ends);
  }
  grid->SetPoints(points);
  return grid;
}

/// A line for each array of the file: its unit, or what its numbers stand for.
std::vector<std::string> field_units(const Frame& frame) {
  std::vector<std::string> units{
      "points [mm]", "TimeValue [s]", "stress [MPa], tension positive", "principal_stress_max [MPa], in the plane",
      "principal_stress_min [MPa], in the plane", "max_shear_stress [MPa], in the plane", "damage [-]",
      "grain: number, -1 where particles are no parts of grains", "fragment: number, 0 the largest",
      "displacement [mm]", "velocity [mm/s]", "axial_strain [-], shortening positive",
      "axial_stress [MPa], compression positive", "confining_pressure [MPa]", "platen_y [mm], bottom and top",
      "curve_axial_strain [-]", "curve_lateral_strain [-]", "curve_stress [MPa]"};
  if (frame.jaws.radius_mm > 0.0) units.push_back("jaws [mm]: radius, place of the centre, half the width");
  if (frame.joint.length_mm > 0.0)
    units.push_back(
        "joint [mm]: length, rise of the profile, range of the shear displacement, shear displacement, dilation, lift "
        "of the upper block");
  if (!frame.half.empty()) units.push_back("half: 0 lower, 1 upper");
  return units;
}

std::string bytes_of(vtkUnstructuredGrid* grid) {
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(grid);
  writer->WriteToOutputStringOn();
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToZLib();
  writer->SetHeaderTypeToUInt64();
  writer->Write();
  return writer->GetOutputString();
}

}  // namespace

PrincipalStress principal_stress(const std::array<double, 4>& stress) {
  const double centre = 0.5 * (stress[0] + stress[1]);
  const double radius = std::hypot(0.5 * (stress[0] - stress[1]), stress[3]);
  return {centre + radius, centre - radius};
}

std::string fields_vtu(const Frame& frame) {
  vtkNew<vtkUnstructuredGrid> grid;
  const auto points = double_points();
  for (const Vec2 p : frame.position) points->InsertNextPoint(p.x, p.y, 0);
  grid->SetPoints(points);
  grid->AllocateExact(id(frame.triangles.size()), id(3 * frame.triangles.size()));
  for (const auto& triangle : frame.triangles) {
    const vtkIdType nodes[3] = {triangle[0], triangle[1], triangle[2]};
    grid->InsertNextCell(VTK_TRIANGLE, 3, nodes);
  }
  add_cell_fields(grid->GetCellData(), frame);
  add_vectors(grid->GetPointData(), "displacement", frame.displacement);
  add_vectors(grid->GetPointData(), "velocity", frame.velocity);
  add_head(grid->GetFieldData(), frame, field_units(frame));
  add_curve(grid->GetFieldData(), frame);
  return bytes_of(grid);
}

std::string cracks_vtu(const Frame& frame) {
  const auto grid = line_grid(frame.cracks);
  add_crack_fields(grid->GetCellData(), frame.cracks);
  add_head(grid->GetFieldData(), frame,
           {"points [mm]", "TimeValue [s]", "mode: 0 softening, 1 tension, 2 shear, 3 open before the test", "damage [-]", "opening [mm]",
            "slip [mm]", "break_time [s], -1 while softening", "energy [N mm]"});
  return bytes_of(grid);
}

std::string contacts_vtu(const Frame& frame) {
  const auto grid = line_grid(frame.contacts);
  add_contact_fields(grid->GetCellData(), frame.contacts);
  add_head(grid->GetFieldData(), frame,
           {"points [mm], particles' centroids", "TimeValue [s]", "normal_force [N], compression positive",
            "shear_force [N], magnitude", "kind: 0 bonded, 1 broken, 2 general", "contact_point [mm]"});
  return bytes_of(grid);
}

}  // namespace asperity::render
