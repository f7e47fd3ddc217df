#!/bin/bash
# Tests the flow that runs of all models write: on grids, at points, averaged, in the frame of a swimmer.
source "$(dirname "$0")/harness.sh"

quiet=(--progress none --no-provenance)
holds_for() { python3 -c "from flow_files import *; $1"; } # PYTHON statements, which fail by assert

# --- the flow of a pulled sphere is exact, also in a uniform background flow
sphere() { # FLAGS...
  beadswim-layout shape sphere --radius 3 --force 2 --amplitude 0 --direction 1,2,2 --period 100 --viscosity 0.5 --density 1 --units lattice "$@"
}
printf 'x,y,z\n4,0,0\n0,-6,1\n3,20,-5\n0.5,0.5,0.5\n' >points.csv
sphere --unbounded >sphere.json
for order in 0 2; do
  run beadswim-run sphere.json -o sphere.h5md --model multipole --multipole-order $order --cycles 0.05 --flow-every 0.05 --flow-points points.csv "${quiet[@]}"
  has_status 0
  check "the flow of order $order is not that of Stokes" holds_for '
force = [2 / 3, 4 / 3, 4 / 3]
for _, place, u in read_points("sphere.h5md"):
  moved = [0.05 * 100 * f / (6 * math.pi * 0.5 * 3) for f in force]
  r = difference(place, moved)
  exact = [f / (6 * math.pi * 0.5 * 3) for f in force] if math.hypot(*r) < 3 else stokes_flow(r, force, 3, 0.5)
  assert math.hypot(*difference(u, exact)) < 1e-5 * math.hypot(*exact), (place, u, exact)'
done
jq '.flow = {velocity: [1e-3, 2e-3, 0]}' sphere.json >carried.json
run beadswim-run carried.json -o carried.h5md --model rpy --cycles 0.05 --flow-every 0.05 --flow-points points.csv "${quiet[@]}"
check 'the background flow is missing' holds_for '
force = [2 / 3, 4 / 3, 4 / 3]
_, place, u = read_points("carried.h5md")[2]
moved = [5 * (f / (9 * math.pi) + b) for f, b in zip(force, [1e-3, 2e-3, 0])]
exact = stokes_flow(difference(place, moved), force, 3, 0.5)
assert largest([difference(u, [e + b for e, b in zip(exact, [1e-3, 2e-3, 0])])]) < 1e-7, u'

# --- no flow on a no-slip wall, and a grid that ends there
sphere --half-space z --position 0,0,8 >wall.json
run beadswim-run wall.json -o wall.h5md --model multipole --cycles 0.1 --flow-every 0.1 --flow-region=-9:9,-9:9,0:0 --flow-spacing 1 "${quiet[@]}"
has_status 0
check 'the wall moves' holds_for '
cells, h, origin, fields = last_vti("wall.h5md")
assert cells == [18, 18, 1] and h == 1 and origin == [-9, -9, -0.5], (cells, origin)
assert largest(fields["velocity"]) < 1e-12'
run beadswim-run wall.json -o wall.h5md --model rpy --cycles 0.1 --flow-every 0.1 --flow-spacing 3 "${quiet[@]}"
check 'the usual region is not three lengths around the sphere and above the wall' holds_for '
cells, h, origin, fields = last_vti("wall.h5md")
assert cells == [12, 12, 8] and origin[2] >= 0, (cells, origin)
inside = [u for u, bead in zip(fields["velocity"], fields["bead"]) if bead == 1]
assert inside and len(set(inside)) == 1, inside'

# --- divergence vanishes with the square of the spacing
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.2 >swimmer.json
divergence() { # SPACING; of all cells whose neighbours are outside of beads, root mean square
  beadswim-run swimmer.json -o grid.h5md --model rpy --cycles 0.1 --flow-every 0.1 --flow-spacing "$1" --flow-region=-30:30,8:16,-4:4 "${quiet[@]}" >grid.json
  python3 -c '
from flow_files import *
(nx, ny, nz), h, _, fields = last_vti("grid.h5md")
u = fields["velocity"]
at = lambda i, j, k: u[i + nx * (j + ny * k)]
values = [((at(i + 1, j, k)[0] - at(i - 1, j, k)[0]) + (at(i, j + 1, k)[1] - at(i, j - 1, k)[1])
           + (at(i, j, k + 1)[2] - at(i, j, k - 1)[2])) / (2 * h)
          for k in range(1, nz - 1) for j in range(1, ny - 1) for i in range(1, nx - 1)]
print(math.sqrt(sum(v * v for v in values) / len(values)))'
}
check 'the divergence does not vanish with the spacing' holds -n --argjson coarse "$(divergence 1)" --argjson fine "$(divergence 0.5)" '$coarse / $fine | . > 3.3 and . < 4.7'

# --- a mean is the mean of the fields at the samples; in the frame of the swimmer too
for frame in box swimmer; do
  for time in "--flow-every 0.05" "--flow-mean 1"; do
    run beadswim-run swimmer.json -o "$frame${time:7:5}.h5md" --model rpy --cycles 2 --steps-per-cycle 40 --frames-per-cycle 20 \
      $time --flow-frame $frame --flow-region=-60:60,-30:30,0:30 --flow-spacing 10 "${quiet[@]}"
    has_status 0
  done
  check "the mean in the frame $frame is not that of the fields" holds_for "
every = [read_vti(f)[3]['velocity'] for f in sorted(glob.glob('${frame}every.h5md.flow/*.vti'))[-20:]]
mean = last_vti('${frame}mean .h5md')[3]['velocity']
assert len(every) == 20
size = largest(mean)
for p, u in enumerate(mean):
  assert math.hypot(*difference(u, [sum(each[p][a] for each in every) / 20 for a in range(3)])) < 1e-6 * size, p"
done
check 'frames do not matter' bash -c '! cmp -s boxmean\ .h5md.flow/000000080.vti swimmermean\ .h5md.flow/000000080.vti'

# --- a restart continues the sums, on any number of ranks
mean=(--flow-mean 2 --flow-frame swimmer --flow-region=-60:60,-30:30,0:30 --flow-spacing 10)
run beadswim-run swimmer.json -o whole.h5md --model rpy --cycles 3 --steps-per-cycle 40 "${mean[@]}" "${quiet[@]}"
run beadswim-run swimmer.json -o part.h5md --model rpy --cycles 3 --steps-per-cycle 40 "${mean[@]}" --checkpoint-every 0.7 "${quiet[@]}"
run beadswim-run --restart part.h5md.ckpt.0 -o part.h5md --cycles 3 "${mean[@]}" "${quiet[@]}"
has_status 0
check 'a restart changes the mean' cmp -s whole.h5md.flow/000000120.vti part.h5md.flow/000000120.vti
other_places() { # FLAGS...   of the flow, at as many points
  refuses '^beadswim-run: --flow-mean: the last 2 cycles begin before the checkpoint, whose run did not sum up the flow at these places' \
    beadswim-run --restart part.h5md.ckpt.0 -o other.h5md --cycles 3 --flow-mean 2 --flow-spacing 10 "$@" "${quiet[@]}"
}
other_places --flow-frame box --flow-region=-60:60,-30:30,0:30
other_places --flow-frame swimmer --flow-region=-50:70,-30:30,0:30
refuses '^beadswim-run: --flow-mean: the last 3 cycles begin before the checkpoint' beadswim-run --restart part.h5md.ckpt.0 -o part.h5md --cycles 3 --flow-mean 3 "${quiet[@]}"
run beadswim-run swimmer.json -o points.h5md --model rpy --cycles 2 --steps-per-cycle 40 --flow-every 0.5 --flow-points points.csv --checkpoint-every 1 "${quiet[@]}"
cp points.h5md.flow.csv whole.csv
run beadswim-run --restart points.h5md.ckpt.0 --cycles 2 "${quiet[@]}"
has_status 0
check 'a restart changes the rows of points' cmp -s whole.csv points.h5md.flow.csv
check 'there is not one row for each point and time' test "$(wc -l <whole.csv)" -eq 17

# --- the lattice: the same bits on 1 and 2 ranks; points interpolate the cells
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 40,20,20 --boundary free-slip,periodic,no-slip --period 200 --amplitude 0.1 >lattice.json
printf 'x,y,z\n10.25,7.75,10.25\n11.5,3,0.25\n20,10,10\n0.1,19.9,7\n' >lattice.csv
lattice=(--cells-per-radius 2 --relaxation-time 1 --cycles 1)
for ranks in 1 2; do
  run mpirun -n $ranks beadswim-run lattice.json -o lattice$ranks.h5md "${lattice[@]}" --flow-mean 1 "${quiet[@]}"
  has_status 0
  run mpirun -n $ranks beadswim-run lattice.json -o at$ranks.h5md "${lattice[@]}" --flow-every 1 --flow-points lattice.csv "${quiet[@]}"
  has_status 0
done
check 'ranks change the mean' cmp -s lattice1.h5md.flow/000000400.vti lattice2.h5md.flow/000000400.vti
check 'ranks change the flow at points' cmp -s at1.h5md.flow.csv at2.h5md.flow.csv
run beadswim-run lattice.json -o cells.h5md "${lattice[@]}" --flow-every 1 "${quiet[@]}"
run beadswim-run lattice.json -o grid.h5md "${lattice[@]}" --flow-every 1 --flow-spacing 1 "${quiet[@]}"
check 'the grid of cells has other values than the cells' holds_for '
cells, grid = last_vti("cells.h5md"), last_vti("grid.h5md")
assert cells[:3] == grid[:3], (cells[:3], grid[:3])
size = largest(cells[3]["velocity"])
assert all(largest([difference(a, b)]) < 1e-6 * size or bead > 0
           for a, b, bead in zip(cells[3]["velocity"], grid[3]["velocity"], cells[3]["bead"]))
assert max(abs(a - b) for a, b in zip(cells[3]["pressure"], grid[3]["pressure"])) < 1e-6 * max(map(abs, cells[3]["pressure"]))
assert [round(b) for b in cells[3]["bead"]] == [round(b) for b in grid[3]["bead"]]
points = read_points("at1.h5md")
(nx, ny, _), h, _, fields = cells
u = fields["velocity"]
expected = [sum(wx * wy * wz * u[i + nx * (j + ny * k)][a]
            for i, wx in ((9, 0.25), (10, 0.75)) for j, wy in ((7, 0.75), (8, 0.25)) for k, wz in ((9, 0.25), (10, 0.75))) for a in range(3)]
assert largest([difference(points[0][2], expected)]) < 1e-5 * largest([expected]), (points[0][2], expected)'

# --- every model writes the flow, in boxes and open space
beadswim-layout swimmer --preset paper-single --box 120,80,80 >box.json
for model in rpy rpy+near multipole unsteady oseen; do
  run beadswim-run box.json -o model.h5md --model $model --cycles 0.1 --flow-every 0.1 --flow-spacing 8 "${quiet[@]}"
  has_status 0
  check "$model writes no flow" holds_for 'cells, h, _, fields = last_vti("model.h5md"); assert cells == [15, 10, 10] and largest(fields["velocity"]) > 0'
done

# --- what cannot be is refused before any work
refuses '^beadswim-run: --flow-region: the places from 10 to 130 along x go beyond the fluid, which is there from 0 to 120' \
  beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-region 10:130,0:80,0:80
refuses '^beadswim-run: --flow-region: the places from -1 to 3 along z go beyond the fluid' beadswim-run wall.json -o x.h5md --model rpy --flow-every 1 --flow-region 0:1,0:1,-1:3
refuses '^beadswim-run: --flow-region: "1:2,3" is no region; give the ends' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-region 1:2,3
refuses '^beadswim-run: --flow-spacing: a region of 120 x 80 x 80 has 7.68e\+11 cells of 0.01, more than 1e\+08; give at least 0.2[0-9]*, or a smaller --flow-region' \
  beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-spacing 0.01
printf 'x,y,z\n1,2,three\n' >bad.csv
refuses '^beadswim-run: bad.csv: line 2 has no finite number in the column z; give one' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-points bad.csv
printf '1,2,3\n' >bad.csv
refuses '^beadswim-run: bad.csv: line 1 names no column x; begin with the line x,y,z' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-points bad.csv
printf 'x,y,z\n' >bad.csv
refuses '^beadswim-run: bad.csv: the file has no points' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-points bad.csv
printf 'x,y,z\n1,2,81\n' >bad.csv
refuses '^beadswim-run: --flow-points: the places from 81 to 81 along z go beyond the fluid' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-points bad.csv
refuses '^beadswim-run: none.csv: ' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-points none.csv
refuses '^beadswim-run: --flow-frame: "swimmer:7" is no frame of this layout; give box, swimmer or swimmer:ID' \
  beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-frame swimmer:7
refuses '^beadswim-run: --flow-spacing: no flow is asked for; add --flow-every or --flow-mean' beadswim-run box.json -o x.h5md --model rpy --flow-spacing 1
refuses '^beadswim-run: --flow-mean: a run writes the present flow or a mean flow' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-mean 1
refuses '^beadswim-run: --flow-mean: the run has 2 cycles, fewer than the 3 of the mean; give at most 2' beadswim-run box.json -o x.h5md --model rpy --cycles 2 --flow-mean 3
refuses '^beadswim-run: --flow-points: points and a grid exclude each other' beadswim-run box.json -o x.h5md --model rpy --flow-every 1 --flow-points points.csv --flow-spacing 1
check 'refused runs leave files' bash -c '! ls x.h5md*'

rest_is_long

# --- the mean flow of the paper's swimmer on the lattice is that of unsteady of order 2. Beads swing by 2.1 around their mean
# places, so that two radii from all their places are 10.1 from the mean ones.
beadswim-layout swimmer --preset paper-single --box 80,48,48 --amplitude 0.2 --period 1200 >paper.json
mean=(--cycles 3 --flow-mean 1 --flow-frame swimmer --flow-region=-36:36,-20:20,0:0 --flow-spacing 2)
run beadswim-run paper.json -o unsteady.h5md --model unsteady --multipole-order 2 "${mean[@]}" "${quiet[@]}"
has_status 0
run mpirun -n 2 beadswim-run paper.json -o lbm.h5md --model lbm --cells-per-radius 3 --relaxation-time 1 "${mean[@]}" "${quiet[@]}"
has_status 0
check 'the lattice has another mean flow than unsteady' holds_for '
a, b = last_vti("unsteady.h5md"), last_vti("lbm.h5md")
near = [(-20, 0, 0), (0, 0, 0), (20, 0, 0)]
distance = [min(math.hypot(*difference(x, bead)) for bead in near) for x in centres(*a[:3])]
error = max(math.hypot(*difference(u, v)) for u, v, d in zip(a[3]["velocity"], b[3]["velocity"], distance) if d > 10.1)
size = max(math.hypot(*u) for u, d in zip(a[3]["velocity"], distance) if d > 8)
assert error < 0.05 * size'

finish
