"""Checks that ParaView opens a trajectory by the name of its .xdmf2 file and shows the beads of every frame.

usage: pvbatch pvbatch_beads.py TRAJECTORY
"""
import sys

import h5py
import numpy as np
from paraview import servermanager
from paraview.simple import Calculator, Delete, Glyph, OpenDataFile
from vtkmodules.util.numpy_support import vtk_to_numpy

path = sys.argv[1]
with h5py.File(path) as file:
    beads = file["particles/beads"]
    moving = {name: beads[name]["value"][:] for name in ("position", "velocity", "image")}
    fixed = {name: beads[name][:] for name in ("radius", "species", "swimmer")}
    times = beads["position/time"][:]
    lengths = np.diagonal(beads["box/edges/value"][0])


def fetched(source, time):
    source.UpdatePipeline(time)
    return servermanager.Fetch(source)


source = OpenDataFile(path + ".xdmf2")
assert source is not None, "ParaView has no reader for .xdmf2"
source.UpdatePipelineInformation()
assert np.array_equal(source.TimestepValues, times), source.TimestepValues
for n, time in enumerate(times):
    frame = fetched(source, time)
    assert frame.GetNumberOfPoints() == frame.GetNumberOfCells() == len(fixed["radius"])
    assert np.array_equal(vtk_to_numpy(frame.GetPoints().GetData()), moving["position"][n])
    arrays = {**fixed, "velocity": moving["velocity"][n], "image": moving["image"][n]}
    for name, numbers in arrays.items():
        assert np.array_equal(vtk_to_numpy(frame.GetPointData().GetArray(name)), numbers), (name, n)

# Typical use: unwraps positions, and draws spheres with the radii of the beads.
unwrap = Calculator(Input=source, CoordinateResults=1)
unwrap.Function = "coords + " + " + ".join(f"{lengths[a]!r}*image_{'XYZ'[a]}*{'ijk'[a]}Hat" for a in range(3))
spheres = Glyph(Input=unwrap, GlyphType="Sphere", ScaleFactor=2, GlyphMode="All Points")
spheres.ScaleArray = ["POINTS", "radius"]
spheres.OrientationArray = ["POINTS", "No orientation array"]
spheres.GlyphType.ThetaResolution = spheres.GlyphType.PhiResolution = 32
low, high = np.array(fetched(spheres, times[-1]).GetBounds()).reshape(3, 2).T
unwrapped = moving["position"][-1] + moving["image"][-1] * lengths
radius = fixed["radius"][:, None]
assert np.allclose(low, (unwrapped - radius).min(axis=0), rtol=0, atol=0.02 * radius.max()), low
assert np.allclose(high, (unwrapped + radius).max(axis=0), rtol=0, atol=0.02 * radius.max()), high
for proxy in (spheres, unwrap, source):
    Delete(proxy)
print(f"{len(times)} frames of {len(radius)} beads")
