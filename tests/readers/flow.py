"""Checks flow files with a reader that is not part of Beadswim: the mean velocity over the volume must be that of the trajectory.

usage: flow.py TRAJECTORY RUN_RECORD
"""
import base64
import json
import os
import struct
import sys
import xml.etree.ElementTree as xml

import h5py
import numpy as np

path, record_path = sys.argv[1:]
record = json.load(open(record_path))
collection = xml.parse(path + ".flow.pvd").getroot().find("Collection")
with h5py.File(path) as file:
    times = file["observables/mean_flow/time"][:]
    mean_flow = file["observables/mean_flow/value"][:]
    velocities = file["particles/beads/velocity/value"][:]

for entry in collection:
    image = xml.parse(os.path.join(os.path.dirname(path), entry.get("file"))).getroot().find("ImageData")
    cells = np.array(image.get("WholeExtent").split(), int)[1::2]
    spacing = np.array(image.get("Spacing").split(), float)
    assert np.allclose(cells * spacing, record["domain"]["lengths"])
    fields = {}
    for array in image.find("Piece").find("CellData"):
        data = base64.b64decode(array.text.strip())
        (size,) = struct.unpack("<Q", data[:8])
        assert size == len(data) - 8
        fields[array.get("Name")] = np.frombuffer(data[8:], "<f4").reshape(-1, int(array.get("NumberOfComponents")))
    assert all(len(field) == cells.prod() for field in fields.values())
    frame = np.argmin(abs(times - float(entry.get("timestep"))))
    assert np.allclose(fields["velocity"].mean(axis=0), mean_flow[frame], atol=1e-7)
    fastest = abs(velocities[frame]).max()
    bead_volume = 4 / 3 * np.pi * record["resolution"]["cells_per_radius"] ** 3
    for bead in (1, 2, 3):
        inside = fields["bead"][:, 0] == bead
        assert abs(inside.sum() / bead_volume - 1) < 0.5  # a staircase
        moving = fields["velocity"][inside].mean(axis=0)  # the bead's own velocity, a step before
        assert np.allclose(moving, velocities[frame][bead - 1], atol=0.1 * fastest), (moving, velocities[frame])
print(f"{len(collection)} flow files hold what the trajectory says")
