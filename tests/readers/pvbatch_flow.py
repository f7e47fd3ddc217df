"""Checks that ParaView opens the flow fields of a run, with the mean velocity and the bead positions of the trajectory.

With levels of cells, the cells under a finer level are hidden, and the others fill the box.

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


def images_of(data):
    """Returns the images of all levels."""
    if not data.IsA("vtkCompositeDataSet"):
        return [data]
    leaves = data.NewIterator()
    images = []
    leaves.InitTraversal()
    while not leaves.IsDoneWithTraversal():
        images.append(leaves.GetCurrentDataObject())
        leaves.GoToNextItem()
    return images


def visible_cells(image):
    """Returns the numbers of the cells that are not hidden."""
    ghost = image.GetCellData().GetArray("vtkGhostType")
    return slice(None) if ghost is None else vtk_to_numpy(ghost) == 0


flow = OpenDataFile(path + ".flow.pvd")
flow.UpdatePipelineInformation()
assert len(flow.TimestepValues) > 0
for time in flow.TimestepValues:
    (frame,) = np.flatnonzero(times == time)
    flow.UpdatePipeline(time)
    images = images_of(servermanager.Fetch(flow))
    assert np.allclose(images[0].GetBounds(), np.stack([0 * lengths, lengths], axis=1).ravel())
    volume, momentum = 0, 0
    for image in images:
        cells = {name: vtk_to_numpy(image.GetCellData().GetArray(name))[visible_cells(image)] for name in ("velocity", "pressure")}
        cell = np.prod(image.GetSpacing())
        volume += cell * len(cells["pressure"])
        momentum += cell * cells["velocity"].sum(axis=0)
        assert abs(cells["pressure"]).max() > 0
    assert np.isclose(volume, np.prod(lengths))
    assert np.allclose(momentum / volume, mean_flow[frame], rtol=0, atol=1e-5 * abs(velocity).max())
    for bead in range(len(species)):
        probe = ProbeLocation(Input=flow)
        probe.ProbeType.Center = [float(x) for x in position[frame, bead]]
        probe.ProbeType.Radius = 0
        probe.UpdatePipeline(time)
        there = servermanager.Fetch(probe).GetPointData()
        assert there.GetArray("bead").GetTuple(0) == (species[bead],)
        moving = np.array(there.GetArray("velocity").GetTuple(0))  # the bead's own, a step before
        assert np.allclose(moving, velocity[frame, bead], atol=0.1 * abs(velocity[frame]).max()), (moving, velocity[frame])
print(f"{len(flow.TimestepValues)} fields of {sum(image.GetNumberOfCells() for image in images)} cells, {len(images)} levels")
