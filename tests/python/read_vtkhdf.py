#!/usr/bin/env python3
"""Reads a result folder's fields.vtkhdf back with h5py and with VTK's own reader, and holds both to history.csv.

    python3 -m venv venv && venv/bin/pip install h5py numpy vtk
    venv/bin/python tests/python/read_vtkhdf.py RESULT_DIR

Exits with 1 and says where the first mismatch is; with 0 where the three agree:

* a step for each row of history, or for every n-th where the scenario's record.fields_every says so, at the same times;
* in each step the highest tension of a rope (members of canopies are none) equals tension_max_n, and a labelled point
  lies at P_x_m, P_y_m, P_z_m;
* VTK shows, at every step, the points, velocities, tensions and classes that h5py reads.
"""

import argparse
import csv
import sys
from pathlib import Path

import h5py
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOHDF import vtkHDFReader


class Mismatch(Exception):
    """Two readers, or the fields and history.csv, disagree."""


def require_equal(what, expected, found):
    """Raises Mismatch unless both arrays have the same shape and the same values; NaN equals NaN."""
    expected, found = np.asarray(expected), np.asarray(found)
    if expected.shape != found.shape:
        raise Mismatch(f"{what}: shape {found.shape}, expected {expected.shape}")
    if not np.array_equal(expected, found, equal_nan=True):
        place = np.argwhere(expected != found)[0]
        raise Mismatch(f"{what}, first at {tuple(place)}: {found[tuple(place)]}, expected {expected[tuple(place)]}")


def read_history(path):
    """history.csv as arrays by column; an empty cell is NaN."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    if not rows:
        raise Mismatch(f"{path} has no rows")
    return {name: np.array([float(row[name]) if row[name] else np.nan for row in rows]) for name in rows[0]}


def read_with_h5py(path):
    """The arrays by step: (steps, nodes, 3), (steps, segments) and so on."""
    with h5py.File(path) as file:
        vtk = file["VTKHDF"]
        kind = vtk.attrs["Type"]
        require_equal("VTKHDF version", [2, 2], vtk.attrs["Version"])
        if kind != b"PolyData":  # VTK reads a string of fixed length only, which h5py gives as bytes
            raise Mismatch(f"VTKHDF type: {kind!r}, expected b'PolyData'")
        steps, nodes = vtk["Steps"].attrs["NSteps"], vtk["NumberOfPoints"][0]
        names = file["netcast"]
        labels = {}
        if "label_names" in names:
            labels = {name.decode(): int(node) for name, node in zip(names["label_names"], names["label_nodes"])}
        return {
            "times": vtk["Steps/Values"][:],
            "segments": vtk["Lines/Connectivity"][:].reshape(-1, 2),
            "triangles": vtk["Polygons/Connectivity"][:].reshape(-1, 3),
            "positions": vtk["Points"][:].reshape(steps, nodes, 3),
            "velocity": vtk["PointData/velocity"][:].reshape(steps, nodes, 3),
            "tension": vtk["CellData/tension"][:].reshape(steps, -1),
            "class": vtk["CellData/class"][:],
            "class_names": [name.decode() for name in names["class_names"]] if "class_names" in names else [],
            "labels": labels,
        }


def read_with_vtk(path):
    """Yields (time, arrays) of each step, as ParaView would show it."""
    reader = vtkHDFReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    information = reader.GetOutputInformation(0)
    times = information.Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()) or ()
    if len(times) != reader.GetNumberOfSteps():
        raise Mismatch(f"VTK offers {len(times)} times for {reader.GetNumberOfSteps()} steps")
    for step, time in enumerate(times):
        reader.SetStep(step)
        reader.UpdateTimeStep(time)
        data = reader.GetOutput()
        yield time, {
            "segments": vtk_to_numpy(data.GetLines().GetConnectivityArray()).reshape(-1, 2),
            "triangles": vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3),
            "positions": vtk_to_numpy(data.GetPoints().GetData()),
            "velocity": vtk_to_numpy(data.GetPointData().GetArray("velocity")),
            "tension": vtk_to_numpy(data.GetCellData().GetArray("tension")),
            "class": vtk_to_numpy(data.GetCellData().GetArray("class")),
        }


# the highest tension, the largest area, the start and the end of the open spell
MOST_MOMENTS = 4


def steps_with_rows(row_times, step_times):
    """The steps of the fields that have a row of the history, and these rows. The others are moments between records."""
    row_at = {time: row for row, time in enumerate(row_times)}
    steps = [step for step, time in enumerate(step_times) if time in row_at]
    between = len(step_times) - len(steps)
    if between > MOST_MOMENTS:
        raise Mismatch(f"{between} steps of the fields have no row in history.csv, at most {MOST_MOMENTS} may")
    return steps, [row_at[step_times[step]] for step in steps]


def check(folder):
    """Raises Mismatch where the files of a result folder disagree; returns a line that says what was compared."""
    history = read_history(folder / "history.csv")
    fields = read_with_h5py(folder / "fields.vtkhdf")

    recorded, rows = steps_with_rows(history["time_s"], fields["times"])
    if len(set(np.diff(rows))) > 2:
        raise Mismatch(f"the steps of the fields are no regular share of the rows of history.csv: {rows}")
    history = {name: values[rows] for name, values in history.items()}
    # neither members of canopies nor triangles of sheets, which have no class, are ropes
    ropes = [number >= 0 and fields["class_names"][number] != "canopy" for number in fields["class"]]
    if any(ropes):
        highest = fields["tension"][recorded][:, ropes].max(axis=1)
        require_equal("h5py: highest tension against tension_max_n", history["tension_max_n"], highest)
    points = [name for name in fields["labels"] if f"{name}_x_m" in history]
    for name in points:
        expected = np.stack([history[f"{name}_{axis}_m"] for axis in "xyz"], axis=1)
        found = fields["positions"][recorded, fields["labels"][name]]
        require_equal(f"h5py: position of {name} against history.csv", expected, found)

    steps = 0
    for step, (time, seen) in enumerate(read_with_vtk(folder / "fields.vtkhdf")):
        require_equal(f"VTK: time of step {step}", fields["times"][step], time)
        for name in ("positions", "velocity", "tension"):
            require_equal(f"VTK: {name} at step {step}", fields[name][step], seen[name])
        for name in ("segments", "triangles", "class"):
            require_equal(f"VTK: {name} at step {step}", fields[name], seen[name])
        steps += 1
    require_equal("VTK: number of steps", len(fields["times"]), steps)
    nodes = fields["positions"].shape[1]
    segments, triangles = len(fields["segments"]), len(fields["triangles"])
    size = f"{steps} steps, {nodes} nodes, {segments} segments, {triangles} triangles, points {', '.join(points) or 'none'}"
    return f"{size}: h5py, VTK and history.csv agree"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("result_dir", type=Path)
    arguments = parser.parse_args()
    try:
        print(check(arguments.result_dir))
    except (Mismatch, OSError, KeyError) as error:
        sys.exit(f"{arguments.result_dir}: {error}")


if __name__ == "__main__":
    main()
