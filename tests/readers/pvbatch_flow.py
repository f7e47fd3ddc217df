"""Checks that ParaView opens the flow fields of a run, with the mean velocity and the bead positions of the trajectory.

usage: pvbatch pvbatch_flow.py TRAJECTORY
"""
import sys

import h5py
import numpy as np
from paraview import servermanager
from paraview.simple import OpenDataFile, ProbeLocation
from vtkmodules.util.numpy_support import vtk_to_numpy

path = sys.argv[1]
with h5py.File(path) as file:
    times = file["observables/mean_flow/time"][:]
    mean_flow = file["observables/mean_flow/value"][:]
    beads = file["particles/beads"]
    lengths = np.diagonal(beads["box/edges/value"][0])
    position, velocity = beads["position/value"][:], beads["velocity/value"][:]
    species = beads["species"][:]

flow = OpenDataFile(path + ".flow.pvd")
flow.UpdatePipelineInformation()
assert len(flow.TimestepValues) > 0
for time in flow.TimestepValues:
    (frame,) = np.flatnonzero(times == time)
    flow.UpdatePipeline(time)
    image = servermanager.Fetch(flow)
    assert np.allclose(image.GetBounds(), np.stack([0 * lengths, lengths], axis=1).ravel())
    cells = {name: vtk_to_numpy(image.GetCellData().GetArray(name)) for name in ("velocity", "pressure", "bead")}
    assert np.allclose(cells["velocity"].mean(axis=0), mean_flow[frame], rtol=0, atol=1e-5 * abs(velocity).max())
    assert abs(cells["pressure"]).max() > 0
    for bead in range(len(species)):
        probe = ProbeLocation(Input=flow)
        probe.ProbeType.Center = [float(x) for x in position[frame, bead]]
        probe.ProbeType.Radius = 0
        probe.UpdatePipeline(time)
        there = servermanager.Fetch(probe).GetPointData()
        assert there.GetArray("bead").GetTuple(0) == (species[bead],)
        moving = np.array(there.GetArray("velocity").GetTuple(0))  # the bead's own, a step before
        assert np.allclose(moving, velocity[frame, bead], atol=0.1 * abs(velocity[frame]).max()), (moving, velocity[frame])
print(f"{len(flow.TimestepValues)} fields of {image.GetNumberOfCells()} cells")
