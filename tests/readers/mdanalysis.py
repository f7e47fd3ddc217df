"""Checks that MDAnalysis, used as docs/formats/h5md.md describes, reads the same numbers that the trajectory file contains.

usage: mdanalysis.py TRAJECTORY LAYOUT RUN_RECORD
"""
import sys
import warnings

import h5py
import numpy as np

warnings.filterwarnings("ignore")
import MDAnalysis

from trajectory import Expected

path = sys.argv[1]
expected = Expected(*sys.argv[2:4])
with h5py.File(path) as file:
    beads = file["particles/beads"]
    position, velocity, image = (beads[name]["value"][:] for name in ("position", "velocity", "image"))
    times = beads["position/time"][:]
    mean_flow = file["observables/mean_flow/value"][:]

# A trajectory in nm and ns has units that MDAnalysis converts to its own, Angstrom and ps.
with h5py.File(path) as file:
    has_units = "unit" in file["particles/beads/position/value"].attrs
length, time = (10, 1000) if has_units else (1, 1)
options = {} if has_units else {"convert_units": False}

universe = MDAnalysis.Universe.empty(position.shape[1], n_residues=len(expected.swimmers),
                                     atom_resindex=np.arange(position.shape[1]) // 3, trajectory=False)
universe.load_new(path, format="H5MD", **options)
universe.add_TopologyAttr("radii", expected.radii())
assert len(universe.trajectory) == len(times)
for frame in universe.trajectory:
    n = frame.frame
    assert np.isclose(frame.time, time * times[n], rtol=1e-12)
    assert np.allclose(frame.positions, length * position[n], rtol=1e-6, atol=0)
    assert np.allclose(frame.velocities, length / time * velocity[n], rtol=1e-6, atol=0)
    assert np.array_equal(frame.data["mean_flow"], mean_flow[n])
    if expected.lengths.any():
        assert np.allclose(frame.dimensions, [*(length * expected.lengths), 90, 90, 90])
    else:
        assert frame.dimensions is None

# Typical use: unwraps positions with the image numbers, and evaluates the displacement of the first swimmer.
universe.trajectory[-1]
swimmer = universe.residues[0].atoms
centre = (swimmer.positions / length + image[-1, swimmer.indices] * expected.lengths).mean(axis=0)
start = expected.positions_at_start()[:3].mean(axis=0)
cycles = expected.record["swimmers"][0]["cycles"]
if cycles and "period" not in expected.record["swimmers"][0]:
    moved = sum(np.array(cycle["velocity"]) for cycle in cycles) * expected.period
    assert np.allclose(centre - start, moved, rtol=0, atol=1e-6 * abs(position).max()), (centre - start, moved)
print(f"{len(times)} frames of {position.shape[1]} beads")
