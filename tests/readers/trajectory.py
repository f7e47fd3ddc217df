"""Expected content of a trajectory, computed from the layout and the run record alone, for the tests of readers."""
import json

import numpy as np


class Expected:
    """Expected content for one run. LAYOUT and RUN_RECORD are paths of files."""

    def __init__(self, layout, record):
        self.layout = json.load(open(layout))
        self.record = json.load(open(record))
        self.swimmers = sorted(self.layout["swimmers"], key=lambda swimmer: swimmer["id"])
        self.period = self.record["driving"]["period"]
        domain = self.layout["domain"]
        self.lengths = np.array(domain["lengths"] if domain else [0, 0, 0], float)
        self.periodic = [bool(domain) and kind == "periodic" for kind in (domain or {}).get("boundary", [""] * 3)]

    def of_beads(self, value):
        """value(swimmer's type, number of the bead) of all beads, in the trajectory's order."""
        types = self.layout["types"]
        return np.array([value(types[swimmer["type"]], bead) for swimmer in self.swimmers for bead in range(3)])

    def radii(self):
        return self.of_beads(lambda kind, bead: kind["beads"][bead]["radius"])

    def swimmer_ids(self):
        return np.repeat([swimmer["id"] for swimmer in self.swimmers], 3)

    def positions_at_start(self):
        """At rest the beads are at position - l1 axis, position, position + l2 axis."""
        offset = self.of_beads(lambda kind, bead: [-kind["springs"][0]["rest_length"], 0, kind["springs"][1]["rest_length"]][bead])
        middle = np.repeat([swimmer["position"] for swimmer in self.swimmers], 3, axis=0)
        axis = np.repeat([swimmer["axis"] for swimmer in self.swimmers], 3, axis=0)
        return middle + offset[:, None] * axis


def stroke(arm, period, times):
    """Returns mean, amplitude d and phase delta of arm(t) = mean + d cos(omega t + delta) by a least-squares fit."""
    omega = 2 * np.pi / period
    columns = np.stack([np.ones_like(times), np.cos(omega * times), -np.sin(omega * times)], axis=1)
    mean, c, s = np.linalg.lstsq(columns, arm, rcond=None)[0]
    return mean, np.hypot(c, s), np.arctan2(s, c)
