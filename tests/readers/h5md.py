"""A trajectory opens in h5py and MDAnalysis, with the positions that the run record implies.

usage: h5md.py TRAJECTORY RUN_RECORD
"""
import json
import sys
import warnings

import h5py
import numpy as np

warnings.filterwarnings("ignore")
import MDAnalysis

path, record_path = sys.argv[1:]
record = json.load(open(record_path))

with h5py.File(path) as file:
    assert list(file["h5md"].attrs["version"]) == [1, 1]
    beads = file["particles/beads"]
    assert np.ndim(beads["box"].attrs["dimension"]) == 0 and beads["box"].attrs["dimension"] == 3
    steps = beads["position/step"][:]
    wrapped = beads["position/value"][:].astype(float)
    unwrapped = wrapped + beads["image/value"][:] * np.diagonal(beads["box/edges/value"][0])
    assert json.loads(file["parameters/layout"][()])["schema"] == "beadswim/layout/1"
    assert len(file["observables/mean_flow/value"]) == len(steps)

cycle = record["swimmers"][0]["cycles"][0]
end = list(steps).index(record["resolution"]["steps_per_cycle"])
moved = (unwrapped[end] - unwrapped[0]).mean(axis=0)
expected = np.array(cycle["velocity"]) * record["driving"]["period"]
assert np.allclose(moved, expected, atol=1e-5), (moved, expected)

universe = MDAnalysis.Universe.empty(wrapped.shape[1], trajectory=False)
universe.load_new(path, format="H5MD", convert_units=False)
assert len(universe.trajectory) == len(steps)
assert np.allclose(universe.dimensions[:3], record["domain"]["lengths"])
assert np.allclose(universe.trajectory[end].positions, wrapped[end])
print(f"h5py and MDAnalysis read {len(steps)} frames of {wrapped.shape[1]} beads")
