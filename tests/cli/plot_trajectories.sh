#!/bin/bash
# Tests beadswim-plot trajectories and beadswim-plot swarm: figures of trajectories that beadswim-run has written.
source "$(dirname "$0")/harness.sh"

drawn() { # NUMBER REGEX   on how many lines of out it is
  check "there are not $1 lines like $2" test "$(grep -cE -- "$2" out)" -eq "$1"
}
simulate() { # NAME FLAGS...   layout on standard input
  local name=$1
  shift
  beadswim-run - -o "$name.h5md" --cells-per-radius 3 --progress none "$@" >"$name.record" 2>err
}

beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce 2>err | simulate cell --cycles 1
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,2,2 --blocks 2,1,1 >eight.json
simulate eight --cycles 0.1 --frames-per-cycle 40 <eight.json

# --- trajectories: coordinates of beads, as the run record has them
accepts beadswim-plot trajectories cell.h5md
well_formed out
out_has '>swimmer 0<'
out_has '>Middle beads along x<'
out_has '>time \(cycles of the driving\)<'
notes_have '1 swimmer, T = 2000, box 96 × 32 × 32; 1 cycle( |$)'
check 'not every frame is a point' test "$(grep -m 1 -oE '<polyline points="[^"]*"' out | tr ' ' '\n' | grep -c ,)" -eq 41
accepts beadswim-plot trajectories cell.h5md --along z
check 'a straight swimmer leaves its line' \
  test "$(grep -m 1 -oE '<polyline points="[^"]*"' out | cut -d'"' -f2 | tr ' ' '\n' | cut -d, -f2 | sort -u | wc -l)" -eq 1
accepts beadswim-plot trajectories cell.h5md --beads 1,2,3
out_has '>swimmer 0, bead 3<'
out_has '>Beads along x<'
accepts beadswim-plot trajectories eight.h5md --swimmers 0,7 --beads 1,3
out_has '>swimmer 7, bead 1<'
accepts beadswim-plot trajectories cell.h5md eight.h5md --swimmers 0
out_has '>eight, swimmer 0<'
notes_have '1 to 8 swimmers, T = 2000, 2 boxes; 0.1 to 1 cycles'
accepts beadswim-plot trajectories $(printf 'eight.h5md %.0s' $(seq 12)) --swimmers 0
notes_have '8 swimmers, T = 2000, box .*; 0.1 cycles'
# A dozen curves fit into a figure, and differ in colour or dash.
styles() { # NUMBER   of lines in out of different styles; those of the legend are like those of the curves
  check "there are not $1 styles of lines" test "$(grep '<polyline' out | sed 's/points="[^"]*"//' | sort -u | wc -l)" -eq "$1"
}
styles 12
for beads in 1,2 1,2,3; do
  accepts beadswim-plot trajectories eight.h5md --swimmers 0,2,4,6 --beads $beads
  styles $((4 * ((${#beads} + 1) / 2)))
done
accepts beadswim-plot trajectories eight.h5md --swimmers 5 --beads 1,2,3
styles 3

# The bead moves along the page as it does in the run: from one end of the cycle to the other by v T.
moved=$(jq '.swimmers[0].cycles[0].velocity[0] * 2000' cell.record)
accepts beadswim-plot trajectories cell.h5md --beads 1,2,3
python3 - "$moved" >out.check 2>err <<'PYTHON'
import re, sys
text = open("out").read()
ticks = [(float(v), float(y) - 4) for y, v in re.findall(r'<text x="[\d.]+" y="([\d.]+)"[^>]*text-anchor="end">([-\d.]+)<', text)]
(v0, y0), (v1, y1) = ticks[0], ticks[-1]
lines = [l for l in re.findall(r'<polyline points="([^"]*)"', text) if l.count(" ") == 40]
ends = [[float(p.split(",")[1]) for p in (l.split(" ")[0], l.split(" ")[-1])] for l in lines]
mean = sum((b - a) * (v1 - v0) / (y1 - y0) for a, b in ends) / 3
print(len(lines), mean)
sys.exit(len(lines) != 3 or abs(mean - float(sys.argv[1])) > 0.01 * (v1 - v0))
PYTHON
check "the figure's displacement is not the record's" test $? -eq 0

# Open space, which has no box.
beadswim-layout swimmer --preset paper-single --unbounded --period 300 | beadswim-run - --model rpy --cycles 0.5 -o open.h5md >open.record 2>err
accepts beadswim-plot trajectories open.h5md
notes_have '1 swimmer, T = 300, open space; 0.5 cycles'
check 'nothing is wrapped in open space' bash -c '! grep -q wrapped out'

# Dashes of many cycles would look like slow oscillations: lines are solid, each in its colour.
for y in 0 40 80; do beadswim-layout swimmer --preset paper-single --unbounded --period 300 | jq -c ".swimmers[0] += {id: $y, position: [0, $y, 0]}"; done |
  jq -s '.[0] + {swimmers: map(.swimmers[])}' | beadswim-run - --model rpy --cycles 31 --frames-per-cycle 8 -o long.h5md >long.record 2>err
accepts beadswim-plot trajectories long.h5md
check 'no dashes' bash -c '! grep -q "<polyline.*dasharray" out'
check 'three colours' test "$(grep -oE '<polyline.* stroke="[^"]*"' out | grep -oE ' stroke="[^"]*"' | sort -u | wc -l)" -eq 3
refuses '--swimmers: the figure would have 9 curves, but at most 7 can be distinguished' beadswim-plot trajectories long.h5md --beads 1,2,3
accepts beadswim-plot trajectories open.h5md --beads 1,2,3

# A trajectory states neither the Reynolds number nor the penetration depth.
accepts beadswim-plot stroke long.h5md
notes_have 'Runs: T = 300$'
check 'unknown numbers are not drawn' bash -c '! grep -qE "Re =|δ/λ =" out'
accepts beadswim-plot swarm open.h5md
notes_have '1 swimmer in open space, a box drawn around \(lattice units\)'

# --- swarm
accepts beadswim-plot swarm cell.h5md
well_formed out
drawn 3 '<circle class="b0"'
out_has '>Swarm after 1 cycle<'
check 'one swimmer makes no blocks' bash -c '! grep -q alternate out'
notes_have '1 swimmer in a box of 96 × 32 × 32 \(lattice units\)'
notes_have 'λ = 6, bead density 1, l = 32, k = 0.2, KA = 2048; A = B = 2, α = 1.571 rad, T = 2000, along x'
accepts beadswim-plot swarm cell.h5md --frame 0 --repeat 2,6,3
well_formed out
out_has '>Swarm after 0 cycles<'
notes_have 'its periodic copies drawn 2 × 6 × 3'
drawn 54 '<circle class="b0"'   # 2 x 2 x 1 blocks of 9 in a checkerboard
drawn 54 '<circle class="b1"'
same_bytes 'beadswim-plot swarm cell.h5md' 'beadswim-plot swarm cell.h5md --frame 40'
# A swarm and its cell's copies look the same, but for the note.
picture() { beadswim-plot swarm "$@" --frame 0 --block-swimmers 1,1,1 | grep -v 'in a box'; }
export -f picture
same_bytes 'picture eight.h5md' 'picture cell.h5md --repeat 2,2,2'
accepts beadswim-plot swarm eight.h5md --colours swimmers
for colour in 1 2 3 4 5 6; do drawn 3 "<circle class=\"b$colour\""; done
drawn 6 '<circle class="b0"'    # seven colours, eight swimmers
accepts beadswim-plot swarm eight.h5md --block-swimmers 4
drawn 12 '<circle class="b0"'
drawn 12 '<circle class="b1"'
beadswim-layout swarm --preset paper-uniform --block-swimmers 1,1,1 --arm 31 >other.json
beadswim-layout defect mixture --with other.json --count 3 eight.json | simulate mixture --cycles 0.05
accepts beadswim-plot swarm mixture.h5md --colours types
check 'there are not two keys' test "$(grep -cE '<circle' out)" -eq 26

# Heads, and colours by results in the last cycle.
accepts beadswim-plot swarm eight.h5md --frame 0
drawn 8 '<polygon class='
notes_have 'Triangles are heads\.'
beadswim-compare cell.h5md --table table.csv
accepts beadswim-plot swarm cell.h5md --repeat 1,2,1 --colour velocity --data values.csv -o values.svg
check 'the value of each bead' test "$(sed 1d values.csv | cut -d, -f8 | sort | uniq -c | awk '{print $1, $2}')" = \
  "6 $(sed 1d table.csv | cut -d, -f4)"
check 'a header with the unit' grep -qx 'swimmer,bead,x,y,z,radius,unit,"velocity (lattice units)"' values.csv
check 'a colour bar' grep -q '>velocity (' values.svg
refuses '--colour: cell.h5md states no velocity of a cycle that has ended at this frame; add the run record as a second file, or draw a later frame' \
  beadswim-plot swarm cell.h5md --colour velocity --frame 39
refuses '--colour: cell.h5md states no efficiency .* add the run record' beadswim-plot swarm cell.h5md --colour efficiency
accepts beadswim-plot swarm cell.h5md cell.record --colour efficiency --data values.csv
check 'the efficiency of the record' test "$(sed -n 2p values.csv | cut -d, -f8)" = "$(jq '.swimmers[0].cycles[-1].efficiency' cell.record)"
jq '.driving.period = 1' cell.record >other-cell.json
refuses 'other-cell.json: this is not the record of the run whose trajectory is drawn' beadswim-plot swarm cell.h5md other-cell.json --colour efficiency
refuses '--colour: arm_phases has a value per arm' beadswim-plot swarm cell.h5md --colour arm_phases
refuses '--colour: .* is a layout, which has no results' beadswim-plot swarm eight.json --colour velocity
refuses '--colours: the flag cannot be combined with --colour;' beadswim-plot swarm cell.h5md --colour velocity --colours types

# Names of swimmers, wherever they are by then; a trajectory under another name.
accepts beadswim-plot swarm eight.h5md --mark one=1,seven=7
out_has '>one<'
out_has '>seven<'
cp eight.h5md eight.any
same_bytes 'beadswim-plot swarm eight.h5md' 'beadswim-plot swarm eight.any'
refuses '--mark: there is no swimmer with the id 8 in eight.h5md; the nearest id is 7, and the ids range from 0 to 7' beadswim-plot swarm eight.h5md --mark A=8
refuses '--distances: distances between neighbours are drawn only for a layout, but eight.h5md is a trajectory, in which the swimmers have moved; give the layout' \
  beadswim-plot swarm eight.h5md --distances

# A swarm of the paper's size is a file that opens.
accepts beadswim-plot swarm cell.h5md --repeat 20,24,24 -o large.svg
check 'not 34560 beads' test "$(grep -c '<circle' large.svg)" -eq 34560
check 'over 3 MB' test "$(stat -c %s large.svg)" -lt 3000000
accepts beadswim-plot swarm eight.h5md -o swarm.png
check 'swarm.png is no PNG' test "$(head -c 8 swarm.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a

# --- a run that was killed leaves FILE.h5md.part
beadswim-run eight.json -o killed.h5md --cells-per-radius 3 --cycles 1000 --frames-per-cycle 100 --progress none >/dev/null 2>&1 &
for _ in $(seq 100); do
  run beadswim-plot trajectories killed.h5md.part --swimmers 0
  [ "$status" -eq 0 ] && break
  sleep 0.1
done
check 'a file in the making cannot be read' test "$status" -eq 0
kill -KILL $! 2>/dev/null
wait 2>/dev/null
accepts beadswim-plot swarm killed.h5md.part

# --- what it refuses
refuses 'FILES: no file is given; name trajectories' beadswim-plot trajectories
refuses 'FILES: 2 files are given; a swarm is drawn from one layout or one trajectory' beadswim-plot swarm cell.h5md eight.h5md
refuses '^beadswim-plot: no.h5md: the file cannot be read: No such file or directory; give a trajectory' beadswim-plot swarm no.h5md
refuses '--swimmers: there is no swimmer with the id 9 in eight.h5md; the nearest id is 7, and the ids range from 0 to 7' \
  beadswim-plot trajectories eight.h5md --swimmers 0,9
refuses '--swimmers: "-1": the value must be a whole number' beadswim-plot trajectories eight.h5md --swimmers=-1
refuses '--swimmers: the figure would have 24 curves, but at most 12 can be distinguished' beadswim-plot trajectories eight.h5md --beads 1,2,3
refuses '--beads: swimmer 0 in cell.h5md has no bead 4; its beads have the numbers 1 to 3' beadswim-plot trajectories cell.h5md --beads 4
refuses '--frame: there is no frame 41 in cell.h5md; give a frame from 0 to 40' beadswim-plot swarm cell.h5md --frame 41
refuses '--frame: "lst": the frame must be "last" or a whole number' beadswim-plot swarm cell.h5md --frame lst
refuses '--repeat: "2,2" has 2 values, but 3 are needed' beadswim-plot swarm cell.h5md --repeat 2,2
refuses '--repeat: "0": the value must be a whole number from 1' beadswim-plot swarm cell.h5md --repeat 0,1,1
refuses '--repeat: the copies have 5e\+06 beads and bonds, but at most 1000000 can be drawn' beadswim-plot swarm cell.h5md --repeat 100,100,100
refuses '--block-swimmers: "1,3" has 2 values, but 1 or 3' beadswim-plot swarm cell.h5md --block-swimmers 1,3
beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary free-slip | simulate closed --cycles 0.05
refuses '--repeat: 2 copies along y are not possible, because the box of closed.h5md is not periodic along this axis; give 1' beadswim-plot swarm closed.h5md --repeat 1,2,1
accepts beadswim-plot swarm closed.h5md
finish
