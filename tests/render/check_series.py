"""Opens a run folder's VTU series with Debian's own VTK and checks what ParaView needs: every array is there and finite, its unit
stands in the file, and docs/paraview.md lists it with that unit. Usage: check_series.py RUN_DIR"""
import math
import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree

from vtkmodules.vtkCommonDataModel import VTK_LINE, VTK_TRIANGLE
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

FIELDS = {
    "cells": {"stress": 6, "principal_stress_max": 1, "principal_stress_min": 1, "max_shear_stress": 1, "damage": 1, "grain": 1, "fragment": 1},
    "points": {"displacement": 3, "velocity": 3},
    "field data": ["experiment", "name", "units", "axial_strain", "axial_stress", "confining_pressure", "platen_y",
                   "curve_axial_strain", "curve_lateral_strain", "curve_stress"],
}
CRACKS = {
    "cells": {"mode": 1, "damage": 1, "opening": 1, "slip": 1, "break_time": 1, "energy": 1},
    "points": {},
    "field data": ["experiment", "name", "units"],
}
CONTACTS = {
    "cells": {"normal_force": 1, "shear_force": 1, "kind": 1, "contact_point": 3},
    "points": {},
    "field data": ["experiment", "name", "units"],
}


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    return reader.GetOutput()


def check_arrays(data, expected, length, path):
    for name, components in expected.items():
        array = data.GetArray(name)
        assert array is not None, f"{path}: no {name}"
        assert array.GetNumberOfComponents() == components, f"{path}: {name}"
        assert array.GetNumberOfTuples() == length, f"{path}: {name}"
        for i in range(length):
            assert all(math.isfinite(v) for v in array.GetTuple(i)), f"{path}: {name}[{i}]"


def units_in(field):
    """Of a file: the unit of each array, empty where it is a number without one."""
    lines = field.GetAbstractArray("units")
    matches = [re.match(r"(\w+)(?: \[([^]]+)\])?", lines.GetValue(i)) for i in range(lines.GetNumberOfValues())]
    return {match[1]: match[2] or "" for match in matches}


def units_in_guide():
    """Of docs/paraview.md: series, array and unit of each row of its tables."""
    guide = pathlib.Path(__file__).resolve().parents[2] / "docs" / "paraview.md"
    rows = {}
    series = ""
    for line in guide.read_text(encoding="utf-8").splitlines():
        if line.startswith("### "):
            series = line.split("`")[1].removesuffix(".pvd")
        elif line.startswith("| `"):
            name, _, unit, _ = (cell.strip() for cell in line.strip("|").split("|"))
            rows[series, name.strip("`")] = "" if unit == "number" else unit
    return rows


GUIDE = units_in_guide()


def check_units(grid, series, path):
    field = grid.GetFieldData()
    units = units_in(field)
    names = {data.GetArrayName(i) for data in (field, grid.GetCellData(), grid.GetPointData()) for i in range(data.GetNumberOfArrays())}
    assert set(units) == names - {"experiment", "name", "units"} | {"points"}, f"{path}: units of {sorted(units)}, arrays {sorted(names)}"
    for name, unit in units.items():
        assert GUIDE.get((series, name)) == unit, f"{path}: {name} [{unit}], but docs/paraview.md has {GUIDE.get((series, name))}"


def check_grid(grid, expected, time, cell_type, path):
    field = grid.GetFieldData()
    assert field.GetArrayName(0) == "TimeValue", path
    assert field.GetArray("TimeValue").GetNumberOfTuples() == 1, path
    assert field.GetArray("TimeValue").GetClassName() == "vtkDoubleArray", path
    assert field.GetArray("TimeValue").GetValue(0) == time, path
    for name in expected["field data"]:
        assert field.GetAbstractArray(name) is not None, f"{path}: no field data {name}"
    check_arrays(grid.GetCellData(), expected["cells"], grid.GetNumberOfCells(), path)
    check_arrays(grid.GetPointData(), expected["points"], grid.GetNumberOfPoints(), path)
    assert all(grid.GetCellType(i) == cell_type for i in range(grid.GetNumberOfCells())), path
    if grid.GetNumberOfPoints():
        assert grid.GetPoints().GetData().GetClassName() == "vtkDoubleArray", path


def check_series(run, series, expected, cell_type):
    steps = ElementTree.parse(run / f"{series}.pvd").getroot().findall("Collection/DataSet")
    assert len(steps) >= 2, f"{series}: {len(steps)} frames"
    counts = []
    for step in steps:
        path = run / step.get("file")
        head = path.read_bytes()[:400]
        assert b'header_type="UInt64"' in head and b"vtkZLibDataCompressor" in head, path
        grid = read(path)
        check_grid(grid, expected, float(step.get("timestep")), cell_type, path)
        check_units(grid, series, path)
        counts.append(grid.GetNumberOfCells())
    return counts


run = pathlib.Path(sys.argv[1])
triangles = check_series(run, "fields", FIELDS, VTK_TRIANGLE)
assert min(triangles) > 100, triangles
lines = check_series(run, "cracks", CRACKS, VTK_LINE)
assert max(lines) > 10, lines
forces = check_series(run, "contacts", CONTACTS, VTK_LINE)
assert max(forces) > 10, forces
first = read(run / "fields/fields_000000.vtu")
stress = first.GetCellData().GetArray("stress")
names = [stress.GetComponentName(i) for i in range(6)]
assert names == ["xx", "yy", "zz", "xy", "yz", "xz"], names
print(f"{len(triangles)} frames, {triangles} triangles, {lines} cracks, {forces} contacts")
