"""Reads and writes flow files (.vti) as python does, for flow_figures.sh."""

import base64
import math
import re
import struct
import sys

SIZES = {"Float32": 4, "UInt8": 1}


def read_vti(path):
    """Returns the cells along each axis, the spacing, the origin, and the fields by name, as flat lists."""
    text = open(path).read()
    cells = [int(n) for n in re.search('WholeExtent="([^"]*)"', text)[1].split()[1::2]]
    origin = [float(x) for x in re.search('Origin="([^"]*)"', text)[1].split()]
    spacing = float(re.search('Spacing="([^ "]*)', text)[1])
    fields = {}
    for kind, name, data in re.findall(r'<DataArray type="(\w+)" Name="(\w+)"[^>]*>\s*(\S+)\s*<', text):
        numbers = base64.b64decode(data)[8:]
        fields[name] = struct.unpack(f"<{len(numbers) // SIZES[kind]}{'f' if kind == 'Float32' else 'B'}", numbers)
    return cells, spacing, origin, fields


def write_vti(path, cells, spacing, origin, velocity, bead=lambda x, y, z: 0, hidden=None):
    """Writes the fields that functions of the place give at the centres of the cells."""
    nx, ny, nz = cells
    places = [[o + spacing * (n + 0.5) for o, n in zip(origin, (i, j, k))] for k in range(nz) for j in range(ny) for i in range(nx)]
    fields = [("Float32", "velocity", 3, "f", [u for place in places for u in velocity(*place)]),
              ("Float32", "bead", 1, "f", [bead(*place) for place in places])]
    if hidden:
        fields.append(("UInt8", "vtkGhostType", 1, "B", [8 if hidden(*place) else 0 for place in places]))
    extent = f"0 {nx} 0 {ny} 0 {nz}"
    with open(path, "w") as file:
        file.write('<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n'
                   f'  <ImageData WholeExtent="{extent}" Origin="{origin[0]} {origin[1]} {origin[2]}" Spacing="{spacing} {spacing} {spacing}">\n'
                   f'    <Piece Extent="{extent}">\n      <CellData>\n')
        for kind, name, components, code, numbers in fields:
            data = struct.pack(f"<{len(numbers)}{code}", *numbers)
            file.write(f'        <DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary">\n'
                       + base64.b64encode(struct.pack("<Q", len(data)) + data).decode() + "\n        </DataArray>\n")
        file.write("      </CellData>\n    </Piece>\n  </ImageData>\n</VTKFile>\n")


def read_csv(path):
    """Returns places and velocities."""
    header, *lines = open(path).read().splitlines()
    assert header == "x,y,z,ux,uy,uz,length_unit,velocity_unit", header
    return [[float(x) for x in line.split(",")[:6]] for line in lines]


class Figure:
    """Places in a figure, from the labels of its axes."""

    def __init__(self, path):
        self.text = open(path).read()
        ticks = re.findall(r'<text x="([\d.]+)" y="([\d.]+)" font-size="11.00" font-weight="normal" text-anchor="(middle|end)">([-\d.]+)<', self.text)
        self.x = self.axis([(float(value), float(x)) for x, _, anchor, value in ticks if anchor == "middle"])
        self.y = self.axis([(float(value), float(y) - 4) for _, y, anchor, value in ticks if anchor == "end"])

    @staticmethod
    def axis(ticks):
        (v0, p0), (v1, p1) = ticks[0], ticks[-1]
        return v0, p0, (v1 - v0) / (p1 - p0)

    def place(self, x, y):
        return tuple(v0 + (p - p0) * scale for p, (v0, p0, scale) in ((x, self.x), (y, self.y)))

    def circles(self):
        """Returns centre, radius and fill of each bead."""
        found = re.findall(r'<circle cx="([-\d.]+)" cy="([-\d.]+)" r="([\d.]+)" fill="([^"]*)"', self.text)
        return sorted((*self.place(float(x), float(y)), float(r) * self.x[2], fill) for x, y, r, fill in found)

    def lines(self):
        """Returns the points of each streamline."""
        found = re.findall(r'<polyline points="([^"]*)"', self.text)
        return [[self.place(*map(float, point.split(","))) for point in line.split()] for line in found]
