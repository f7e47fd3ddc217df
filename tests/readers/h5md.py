"""Checks a trajectory with h5py: it must contain the swimmers of the layout and the motion that the run record states.

usage: h5md.py TRAJECTORY LAYOUT RUN_RECORD
"""
import json
import sys

import h5py
import numpy as np

from trajectory import Expected, stroke


def check_groups(file, expected):
    assert list(file["h5md"].attrs["version"]) == [1, 1]
    assert file["h5md/creator"].attrs["name"].decode() == "beadswim-run"
    assert list(file["particles"]) == ["beads"]
    beads = file["particles/beads"]
    assert np.ndim(beads["box"].attrs["dimension"]) == 0 and beads["box"].attrs["dimension"] == 3
    boundary = [text.decode() for text in beads["box"].attrs["boundary"]]
    assert boundary == ["periodic" if periodic else "none" for periodic in expected.periodic], boundary
    assert np.array_equal(beads["species"][:], expected.of_beads(lambda kind, bead: bead + 1))
    assert np.array_equal(beads["swimmer"][:], expected.swimmer_ids())
    assert np.array_equal(beads["radius"][:], expected.radii())
    bonds = file["connectivity/bonds"]
    assert bonds.attrs["particles_group"] and file[bonds.attrs["particles_group"]] == beads
    first = 3 * np.arange(len(expected.swimmers))[:, None, None]
    assert np.array_equal(bonds[:], (first + [[0, 1], [1, 2]]).reshape(-1, 2))
    layout = json.loads(file["parameters/layout"][()])
    assert len(layout.pop("provenance")) >= len(expected.layout["provenance"]) > 0
    assert layout == {key: value for key, value in expected.layout.items() if key != "provenance"}


def check_frames(file, expected):
    """Returns times and unwrapped positions."""
    beads = file["particles/beads"]
    for name in ("particles/beads/position", "particles/beads/velocity", "particles/beads/image",
                 "particles/beads/box/edges", "observables/mean_flow", "observables/momentum"):
        assert len({len(file[name][part]) for part in ("step", "time", "value")}) == 1, name
    times = beads["position/time"][:]
    assert times[0] == 0 and all(np.diff(times) > 0) and all(np.diff(beads["position/step"][:]) > 0)
    assert np.array_equal(beads["box/edges/value"][:], np.tile(np.diag(expected.lengths), (len(times), 1, 1)))
    wrapped = beads["position/value"][:].astype(float)
    image = beads["image/value"][:]
    for axis in range(3):
        if expected.periodic[axis]:
            assert wrapped[..., axis].min() >= 0 and wrapped[..., axis].max() <= expected.lengths[axis]
        else:
            assert not image[..., axis].any()
    if any(expected.periodic):
        assert image.any(), "no bead is beyond the box; the scene does not test unwrapping"
    unwrapped = wrapped + image * expected.lengths
    size = abs(unwrapped).max()
    assert np.allclose(unwrapped[0], expected.positions_at_start(), rtol=0, atol=2e-7 * size)
    return times, unwrapped


def check_velocities(file, times, unwrapped):
    """Compares velocities with differences of positions, which have the relative error (omega dt)^2/6. Skips the fast start of the run."""
    velocity = file["particles/beads/velocity/value"][:]
    difference = np.gradient(unwrapped, times, axis=0)
    error = abs(velocity - difference)[2:-1].max() / abs(velocity).max()
    assert error < 0.01, error


def check_cycle(cycle, beads, times, period):
    """Compares the record of one cycle of a swimmer with the positions of its three beads in this cycle."""
    size = abs(beads).max()
    moved = (beads[-1] - beads[0]).mean(axis=0)
    assert np.allclose(moved, np.array(cycle["velocity"]) * period, rtol=0, atol=1e-6 * size), (moved, cycle)
    for arm in range(2):
        lengths = np.linalg.norm(beads[:, arm + 1] - beads[:, arm], axis=1)
        mean, amplitude, phase = stroke(lengths[:-1], period, times[:-1])
        atol = 1e-6 * size  # of positions in single precision
        assert np.isclose(mean, cycle["arm_means"][arm], rtol=0, atol=atol + 5e-4 * amplitude), (mean, cycle)
        assert np.isclose(amplitude, cycle["arm_amplitudes"][arm], rtol=0.002, atol=atol), (amplitude, cycle)
        turn = np.angle(np.exp(1j * (phase - cycle["arm_phases"][arm])))
        assert abs(turn) < 0.002 + atol / amplitude, (phase, cycle)


def check_table(file, row, number, swimmer, period, time):
    """Checks that a row of /swimmers has the bits of the last cycle that the swimmer has completed by then; NaN before its first cycle."""
    ended = int(np.floor(time / period + 1e-9))
    for name in ("velocity", "axis", "mean_flow", "arm_amplitudes", "arm_phases", "arm_means"):
        numbers = file[f"swimmers/{name}/value"][row, number]
        if ended == 0:
            assert np.isnan(numbers).all(), (name, numbers)
        else:
            assert list(numbers) == swimmer["cycles"][ended - 1][name], (name, numbers)


def check_motion(file, expected, times, unwrapped):
    """Compares the cycles of the record with /swimmers and with the positions. Returns the number of base cycles."""
    base = file["swimmers/velocity/time"][:]
    assert np.allclose(base, expected.period * np.arange(1, len(base) + 1))
    for number, swimmer in enumerate(expected.record["swimmers"]):
        period = swimmer.get("period", expected.period)
        assert swimmer["id"] == expected.swimmers[number]["id"]
        for row, time in enumerate(base):
            check_table(file, row, number, swimmer, period, time)
        for k, cycle in enumerate(swimmer["cycles"]):
            if period == expected.period:  # other cycles end between frames
                frames = (times > (k - 1e-9) * period) & (times < (k + 1 + 1e-9) * period)
                check_cycle(cycle, unwrapped[frames, 3 * number:3 * number + 3], times[frames], period)
    return len(base)


def check_observables(file, expected):
    momentum = expected.record["momentum"]
    if momentum:
        assert list(file["observables/momentum/value"][-1]) == momentum["total"]
        assert list(file["observables/momentum/value"][0]) == momentum["initial"]
    else:
        assert not file["observables/momentum/value"][:].any()
    if not any(expected.periodic):
        assert not file["observables/mean_flow/value"][:].any()


expected = Expected(*sys.argv[2:4])
with h5py.File(sys.argv[1]) as file:
    check_groups(file, expected)
    times, unwrapped = check_frames(file, expected)
    check_velocities(file, times, unwrapped)
    cycles = check_motion(file, expected, times, unwrapped)
    assert cycles > 0 or expected.record["status"] != "finished"
    check_observables(file, expected)
print(f"{len(times)} frames of {unwrapped.shape[1]} beads, {cycles} cycles")
