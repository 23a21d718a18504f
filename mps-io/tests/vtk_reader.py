"""Reads files of fields with VTK's own readers and prints what is in them, one line of JSON a file.

    python3 vtk_reader.py FILE...            every array with its bytes
    python3 vtk_reader.py --names FILE...    only the names of the arrays
"""

import json
import os
import sys

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOHDF import vtkHDFReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader

VERTEX = 1
READERS = {".vtu": vtkXMLUnstructuredGridReader, ".vtp": vtkXMLPolyDataReader, ".vtkhdf": vtkHDFReader}


def described(array, names_only):
    if names_only:
        return array.GetNumberOfTuples()
    return {
        "type": array.GetDataTypeAsString(),
        "components": array.GetNumberOfComponents(),
        "bytes": vtk_to_numpy(array).tobytes().hex(),
    }


def read(path, names_only):
    reader = READERS[os.path.splitext(path)[1]]()
    reader.SetFileName(path)
    # A broken file is told on standard error, and no Python error.
    failures = []
    reader.AddObserver("ErrorEvent", lambda *_: failures.append(path))
    reader.Update()
    if failures:
        sys.exit(f"VTK cannot read {path}")
    grid = reader.GetOutput()
    data = grid.GetPointData()
    arrays = {"Points": grid.GetPoints().GetData()} if grid.GetPoints() else {}
    arrays.update({data.GetArrayName(k): data.GetArray(k) for k in range(data.GetNumberOfArrays())})
    kinds = [grid.GetCellType(k) for k in range(grid.GetNumberOfCells())]
    return {
        "time": grid.GetFieldData().GetArray("TimeValue").GetValue(0),
        "points": grid.GetNumberOfPoints(),
        "vertices": kinds.count(VERTEX) if len(kinds) == kinds.count(VERTEX) else -1,
        "arrays": {name: described(array, names_only) for name, array in arrays.items()},
    }


names = "--names" in sys.argv
for file in sys.argv[1:]:
    if file != "--names":
        print(json.dumps(read(file, names)))
