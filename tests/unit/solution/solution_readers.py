#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""solution_readers.py vtk|h5py WRITE_SAMPLE_SOLUTION: a reader that is not ours sees in our files what was written.

The numbers are those of tests/support/sample_solution.h. Exit code 77: the reader is not installed here.
"""
import os
import subprocess
import sys
import tempfile

try:
    import numpy

    if sys.argv[1] == "vtk":
        from vtkmodules.vtkIOHDF import vtkHDFReader
    else:
        import h5py
except ImportError as error:
    print(f"skipped: {error} (Debian: python3-{'vtk9' if sys.argv[1] == 'vtk' else 'h5py'})")
    sys.exit(77)

LIGHT = {"radiosity_front": 2000, "radiosity_back": 3000, "irradiance_front": 1, "irradiance_back": 1000}
FAR = (100000, 0, -1000000)
ERRORS = {"standard_error_front": 4000, "standard_error_back": 5000, "smoothing_bias_front": 6000,
          "smoothing_bias_back": 7000}


def value(first, index):
    return numpy.float32(numpy.float32(first) + numpy.float32(index) / numpy.float32(3))


def check(found, expected, what):
    assert found == expected, f"{what}: found {found}, expected {expected}"


def check_with_vtk(path, patches, bands, arrays, origin):
    reader = vtkHDFReader()
    check(reader.CanReadFile(path), 1, "VTK's opinion of the file")
    reader.SetFileName(path)
    reader.Update()
    grid = reader.GetOutput()
    check(grid.GetNumberOfPoints(), patches + 2, "points")
    check(grid.GetNumberOfCells(), patches, "cells")
    check({grid.GetCellType(i) for i in range(patches)}, {5}, "types of cells")
    corners = grid.GetCell(1).GetPointIds()
    check([corners.GetId(i) for i in range(3)], [1, 2, 3], "corners of patch 1")
    vertex = tuple(o + float(numpy.float32(x)) for o, x in zip(origin, (3 / 7, 1, 0.1)))
    check(grid.GetPoint(3), vertex, "vertex 3")
    cells = grid.GetCellData()
    names = {cells.GetArrayName(i) for i in range(cells.GetNumberOfArrays())}
    check(names, {*arrays, "area", "triangle", "material"}, "names of cell arrays")
    for name, first in arrays.items():
        array = cells.GetArray(name)
        check(array.GetNumberOfTuples(), patches, name)
        check(array.GetNumberOfComponents(), bands, f"components of {name}")
        last = value(first, patches * bands - 1)
        check(array.GetComponent(patches - 1, bands - 1), last, f"last value of {name}")
    check(cells.GetArray("triangle").GetComponent(patches - 1, 0), 3 * (patches - 1), "last triangle")
    check(cells.GetArray("material").GetComponent(1, 0), 1, "material of patch 1")


def check_with_h5py(path, patches, bands, arrays, origin):
    with h5py.File(path, "r") as file:
        check(file["Luxel"].attrs["format_version"], 2, "format version")
        has_errors = len(arrays) > len(LIGHT)
        stop = b"error_reached" if has_errors else b"converged"
        check(file["Luxel"].attrs["stop_reason"], stop, "stop reason")
        check(file["Luxel"].attrs.get("error_95th"), 0.025 if has_errors else None, "95th percentile")
        check(list(file["Luxel/bands"].asstr()), [f"band {i}" for i in range(bands)], "bands")
        check(list(file["Luxel/materials/name"].asstr()), ["wall", 'lamp, "größer"'], "materials")
        check(file["Luxel/materials/reflectance"].shape, (2, bands), "shape of reflectance")
        check(file["Luxel/provenance/command_line"].asstr()[0], "luxel solve room.obj --error 1%", "command")
        check(int(file["Luxel/provenance"].attrs["rays"]), 12345678901, "rays")
        check(int(file["Luxel/provenance"].attrs["scene_fingerprint"]), 0xFEDCBA9876543210, "fingerprint")
        for name, first in arrays.items():
            array = file["VTKHDF/CellData/" + name]
            check(array.shape, (patches,) if bands == 1 else (patches, bands), f"shape of {name}")
            check(array.attrs["unit"], b"W/m^2", f"unit of {name}")
            check(array[...].flat[-1], value(first, patches * bands - 1), f"last value of {name}")
        check(file["VTKHDF/CellData/area"].attrs["unit"], b"m^2", "unit of area")
        check(file["VTKHDF/Points"].attrs["unit"], b"m", "unit of points")
        check(file["VTKHDF/Points"].dtype, "float64" if any(origin) else "float32", "type of points")
        check(tuple(file.get("Luxel/origin", (0, 0, 0))), origin, "origin")


def main():
    look = check_with_vtk if sys.argv[1] == "vtk" else check_with_h5py
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sample.vtkhdf")
        for patches in (4, 60000):
            for bands in (1, 3, 7):
                for kind in ([], ["errors"], ["far"]):
                    subprocess.run([sys.argv[2], path, str(patches), str(bands), *kind], check=True)
                    arrays = LIGHT | ERRORS if kind == ["errors"] else LIGHT
                    look(path, patches, bands, arrays, FAR if kind == ["far"] else (0, 0, 0))
                print(f"{patches} patches of {bands} bands: {sys.argv[1]} agrees")


if __name__ == "__main__":
    main()
