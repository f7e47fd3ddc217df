#!/bin/bash
# Tests beadswim-plot flow: the figure must show the flow of the files, and the beads of the run, in their places.
source "$(dirname "$0")/harness.sh"

holds() { # MESSAGE PYTHON   statements, which fail by assert
  check "$1" python3 -c "from flow_figures import *; $2"
}

beadswim-layout swimmer --preset paper-single --box 60,24,24 --boundary periodic --radius 3 --arm 13 --period 400 --amplitude 0.3 |
  jq '.swimmers[0].position = [40, 22, 12] | .units = {length: {name: "um", si_factor: 1e-6}, time: {name: "s", si_factor: 1}, mass: {name: "pg", si_factor: 1e-15}}' \
    >layout.json
beadswim-run layout.json -o run.h5md --cells-per-radius 3 --cycles 0.2 --flow-every 0.06 --progress none >run.json 2>err
flow=$(ls run.h5md.flow/*.vti | tail -n 1)

# --- a run: title, axes, colours, beads
accepts beadswim-plot flow run.h5md
well_formed out
out_has '>Flow after 0.18 cycles<'
out_has '>x \(um\)<'
out_has '>y \(um\)<'
out_has '>speed \((10\S+ )?um/s\)<'
notes_have 'Plane z = 12; 1 swimmer, T = 400, box 60 × 24 × 24 Streamlines follow the velocity in the plane. Circles are sections of beads.'
cp out run.svg
same_bytes 'beadswim-plot flow run.h5md' 'cat run.svg'
same_bytes "beadswim-plot flow $flow" 'cat run.svg'
same_bytes "cd run.h5md.flow && beadswim-plot flow $(basename "$flow")" 'cat run.svg'
cp "$flow" alone.vti
same_bytes 'beadswim-plot flow alone.vti' 'beadswim-plot flow - <alone.vti'
accepts beadswim-plot flow "$(ls run.h5md.flow/*.vti | head -n 1)"
out_has '>Flow after 0.06 cycles<'
# The plane z = 12.25 is between two layers of cells.
accepts beadswim-plot flow run.h5md --plane xy:12.25 --data run.csv
holds 'the numbers are not those of the flow file' "
(nx, ny, nz), h, origin, fields = read_vti('$flow')
rows = read_csv('run.csv')
assert len(rows) == nx * ny and h == 1
for x, y, z, *u in rows:
    i, j = int(x), int(y)
    both = [fields['velocity'][3 * (i + nx * (j + ny * k)):][:3] for k in (11, 12)]
    assert (x, y, z) == (i + 0.5, j + 0.5, 12.25)
    assert all(abs(v - (a + 3 * b) / 4) < 1e-6 * abs(v) + 1e-15 for v, a, b in zip(u, *both)), (x, y, u)"
# The flow at 0.18 periods is between the frames at 0.175 and 0.2 periods. Beads at y = 22 with radius 3 reach over the face of the box: their copies are drawn at y = -2 too.
h5dump -d /particles/beads/position/value -o beads.bin -b LE run.h5md >/dev/null
holds 'the beads are not in their places' "
numbers = open('beads.bin', 'rb').read()
before, after = ([struct.unpack('<3f', numbers[i:i + 12]) for i in range(len(numbers) - start, len(numbers) - start + 36, 12)] for start in (72, 36))
beads = [[0.8 * a + 0.2 * b for a, b in zip(*both)] for both in zip(before, after)]
assert max(abs(a[0] - b[0]) for a, b in zip(before, after)) > 0.02
expected = sorted((x + 60 * n, y + 24 * m) for x, y, z in beads for n in (-1, 0, 1) for m in (-1, 0, 1)
                  if -3 < x + 60 * n < 63 and -3 < y + 24 * m < 27)
drawn = Figure('run.svg').circles()
assert len(drawn) == len(expected) and len(drawn) >= 6, (drawn, expected)
for (x, y), (cx, cy, r, fill) in zip(expected, drawn):
    assert math.hypot(x - cx, y - cy) < 0.002 and abs(r - 3) < 0.05 and fill != 'none', (x, y, cx, cy, r)"

# --- planes, quantities, styles
accepts beadswim-plot flow run.h5md --plane xz:20 --quantity uz --style arrows --data run.csv
well_formed out
out_has '>z \(um\)<'
out_has '>uz \((10\S+ )?um/s\)<'
notes_have 'Plane y = 20; .* Arrows show the velocity in the plane; their length grows as its square root. Circles'
cp out xz.svg
holds 'a section has another radius than a circle of the sphere' "
assert all(abs(r - math.sqrt(9 - 4)) < 0.05 for x, y, r, fill in Figure('xz.svg').circles())
assert all(row[1] == 20 for row in read_csv('run.csv'))"
check 'the first rows are not those of the plane xz' test "$(sed -n 3p run.csv | cut -d, -f1-3)" = 1.5,20,0.5
accepts beadswim-plot flow run.h5md --plane yz --data run.csv
notes_have 'Plane x = 30;'
check 'the first rows are not those of the plane yz' test "$(sed -n 3p run.csv | cut -d, -f1-3)" = 30,1.5,0.5
# A plane that no bead touches has all beads in projection.
accepts beadswim-plot flow run.h5md --plane xy:3
notes_have 'Dashed circles are beads in front of the plane or behind it.'
cp out far.svg
holds 'projected beads are not dashed outlines' "
assert all(abs(r - 3) < 0.05 and fill == 'none' for x, y, r, fill in Figure('far.svg').circles())"
accepts beadswim-plot flow run.h5md -o run.png
check 'it is not a PNG image' test "$(head -c 4 run.png | tail -c 3)" = PNG

# --- a file without its run has no units, and its beads are the cells that they cover
accepts beadswim-plot flow alone.vti
out_has '>Flow<'
out_has '>x<'
notes_have '^Plane z = 12 Streamlines follow the velocity in the plane. Beads are grey.$'

# --- solid rotation about (4, 3): streamlines are circles, counterclockwise
python3 -c "from flow_figures import *; write_vti('vortex.vti', [80, 60, 1], 0.1, [0, 0, 7], lambda x, y, z: (3 - y, x - 4, 0))"
accepts beadswim-plot flow vortex.vti --data vortex.csv
notes_have '^Plane z = 7.05 Streamlines follow the velocity in the plane.$'
cp out vortex.svg
holds 'streamlines of solid rotation are not circles' "
for line in Figure('vortex.svg').lines():
    radii = [math.hypot(x - 4, y - 3) for x, y in line]
    assert max(radii) - min(radii) < 0.01, (min(radii), max(radii))
    (x0, y0), (x1, y1) = line[:2]
    assert (x0 - 4) * (y1 - 3) - (y0 - 3) * (x1 - 4) > 0
    if radii[0] < 2.9: assert line[0] == line[-1]"
# One layer of cells across another axis than z is drawn in its own plane.
python3 -c "from flow_figures import *; write_vti('layer.vti', [8, 1, 6], 1, [0, 0, 0], lambda x, y, z: (1, 0, 0))"
accepts beadswim-plot flow layer.vti
notes_have '^Plane y = 0.5 '
refuses '--plane: the flow in layer.vti has only one layer of cells along y, so the plane xy is only a line; give xz' \
  beadswim-plot flow layer.vti --plane xy

# --- two levels: cells under the finer level do not count, and the other files of the same time are found by the index
mkdir levels.h5md.flow
python3 -c "
from flow_figures import *
inside = lambda x, y, z: 2 < x < 6 and 1 < y < 5
flow = lambda x, y, z: (x, y, 0)
write_vti('levels.h5md.flow/1-0.vti', [8, 6, 2], 1, [0, 0, 0], lambda *r: (1e6, 0, 0) if inside(*r) else flow(*r), hidden=inside)
write_vti('levels.h5md.flow/1-1.vti', [8, 8, 4], 0.5, [2, 1, 0], flow, hidden=lambda *r: False)
open('levels.h5md.flow.pvd', 'w').write(''.join(f'<DataSet timestep=\"5\" part=\"{n}\" file=\"levels.h5md.flow/1-{n}.vti\"/>' for n in (0, 1)))"
for level in 0 1; do
  accepts beadswim-plot flow levels.h5md.flow/1-$level.vti --data levels.csv
  holds 'the levels are not drawn together' "
rows = read_csv('levels.csv')
assert len(rows) == 48 - 16 + 64, len(rows)
assert all(abs(x - u) + abs(y - v) < 1e-6 for x, y, z, u, v, w in rows)"
done

# --- a mean, and the frame of a swimmer, are named; the beads of the trajectory are elsewhere, and the cells that they cover are drawn
mean() { # FLAGS...
  beadswim-run layout.json -o mean.h5md --model rpy --cycles 3 --flow-spacing 2 --progress none "$@" >mean.json 2>err
  accepts beadswim-plot flow mean.h5md
  check 'beads are drawn where the flow has none' bash -c '! grep -q "<circle" out'
}
mean --flow-mean 2
out_has '>Mean flow of 2 cycles after 3 cycles<'
notes_have '^Plane z = 12; 1 swimmer, .* Beads are grey.$'
around=(--flow-frame swimmer --flow-region=-24:24,-12:12,-12:12)
mean --flow-mean 1 "${around[@]}"
out_has '>Mean flow of 1 cycle after 3 cycles<'
notes_have '^Plane z = 0 in the frame of swimmer 0; 1 swimmer, .* Beads are grey.$'
mean --flow-every 3 "${around[@]}"
out_has '>Flow after 3 cycles<'
notes_have '^Plane z = 0 in the frame of swimmer 0; '

# --- refusals
refuses '--plane: the flow in .*vti has no z = 25, only 0 to 24; give a coordinate' beadswim-plot flow run.h5md --plane xy:25
for plane in xx xy: xy:1,2 xz:nan ''; do
  refuses '--plane: "[^"]*": the value must be xy, xz or yz' beadswim-plot flow run.h5md --plane "$plane"
done
refuses 'FILES: 2 files are given; a flow is drawn from one' beadswim-plot flow run.h5md run.h5md
cp run.h5md none.h5md
refuses 'none.h5md: this run has written no flow to none.h5md.flow.pvd; run it with --flow-every' beadswim-plot flow none.h5md
refuses 'missing.vti: the file cannot be read' beadswim-plot flow missing.vti
refuses 'layout.json: it does not begin as VTK image data .*; give a flow file' beadswim-plot flow layout.json
head -c 100000 "$flow" >damaged.vti
refuses 'damaged.vti: its field "velocity" is incomplete; give a flow file' beadswim-plot flow damaged.vti
rm "$flow"
refuses "$flow: the file cannot be read" beadswim-plot flow run.h5md
finish
