#!/usr/bin/python3
"""Completes a record of more than 64 swimmers with swimmers of the trajectory.

  last-cycle.py TRAJECTORY N <record.json      (Debian package python3-h5py)

Prints the record. If it has no key "swimmers", adds every Nth swimmer with its last complete cycle.
"""

import json
import sys

import h5py


def last_cycles(trajectory, index, distance):
    with h5py.File(trajectory) as file:
        columns = {name: group["value"][-1] for name, group in file["swimmers"].items()}
    speed = (columns["velocity"] * columns["axis"]).sum(axis=1)
    for number in range(0, len(speed), distance):
        own = {name: values[number].tolist() for name, values in columns.items()}
        yield {"id": number, "cycles": [{"index": index, "speed_along_axis": speed[number], **own}]}


record = json.load(sys.stdin)
if "swimmers" not in record:
    record["swimmers"] = list(last_cycles(sys.argv[1], record["swarm"][-1]["index"], int(sys.argv[2])))
json.dump(record, sys.stdout)
