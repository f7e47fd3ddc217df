"""Reads the flow that beadswim-run writes: VTI files and the CSV file of points. Used by flow.sh."""

import base64
import csv
import glob
import math
import struct
import xml.etree.ElementTree as xml


def read_vti(path):
    """Returns (cells, spacing, origin, {field: list of values}); values of vectors are tuples of 3."""
    image = xml.parse(path).getroot().find("ImageData")
    cells = [int(n) for n in image.get("WholeExtent").split()[1::2]]
    fields = {}
    for array in image.find("Piece/CellData").iter("DataArray"):
        parts = int(array.get("NumberOfComponents", "1"))
        count = parts * math.prod(cells)
        numbers = struct.unpack(f"<{count}f", base64.b64decode(array.text.strip())[8:])
        fields[array.get("Name")] = (
            list(numbers) if parts == 1 else list(zip(*(numbers[k::parts] for k in range(parts)))))
    return cells, float(image.get("Spacing").split()[0]), [float(x) for x in image.get("Origin").split()], fields


def last_vti(run):
    return read_vti(sorted(glob.glob(run + ".flow/*.vti"))[-1])


def centres(cells, spacing, origin):
    return [tuple(origin[a] + spacing * ((i, j, k)[a] + 0.5) for a in range(3))
            for k in range(cells[2]) for j in range(cells[1]) for i in range(cells[0])]


def read_points(run):
    """Returns a list of (cycle, place, velocity)."""
    with open(run + ".flow.csv") as file:
        rows = [{name: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    return [(r["cycle"], (r["x"], r["y"], r["z"]), (r["ux"], r["uy"], r["uz"])) for r in rows]


def stokes_flow(r, force, radius, viscosity):
    """Exact Stokes flow at r from the centre of a sphere that a force pulls."""
    d2 = sum(x * x for x in r)
    d = math.sqrt(d2)
    along = sum(x * f for x, f in zip(r, force)) / d2
    near, far = 1 - radius ** 2 / d2, 1 + radius ** 2 / (3 * d2)
    return [(far * f + near * along * x) / (8 * math.pi * viscosity * d) for x, f in zip(r, force)]


def largest(vectors):
    return max(math.hypot(*v) for v in vectors)


def difference(a, b):
    return [x - y for x, y in zip(a, b)]
