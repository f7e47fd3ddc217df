#!/bin/bash
# Runs small scenes in the current folder, whose files the reader tests open: NAME.layout.json, NAME.h5md, NAME.run.json.
set -euo pipefail

run() { # NAME FLAGS...
  local name=$1
  shift
  beadswim-run "$name.layout.json" -o "$name.h5md" --progress none "$@" >"$name.run.json"
}

lattice=(--cells-per-radius 2 --relaxation-time 1.5)

# Resolved, bead 1 beyond the periodic boundary along x, with flow fields.
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic \
  --period 100 --amplitude 0.02 --position 3,8,8 >lattice.layout.json
run lattice "${lattice[@]}" --cycles 2 --flow-every 1

# Resolved, with walls across y and z, and an oblique axis.
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,24,24 --boundary periodic,free-slip,no-slip \
  --period 100 --amplitude 0.02 --position 30,12,12 --axis 0.8,0.6,0 --frame initial-axis >walls.layout.json
run walls "${lattice[@]}" --cycles 1

# Resolved, with a level of small cells around the beads and flow fields of both levels.
beadswim-layout swimmer --preset paper-single --box 240,160,160 --boundary free-slip --period 400 --amplitude 0.1 >levels.layout.json
run levels "${lattice[@]}" --refine 1 --cycles 2 --flow-every 1

# A swarm without a grid, its swimmers turned at random, some beyond the boundary.
beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,2,2 |
  beadswim-layout defect rotation - --sigma 0.3 --seed 3 |
  jq '(.swimmers | map(.position[0]) | min) as $first | .swimmers[].position[0] -= $first - 1' >swarm.layout.json
run swarm --model rpy --cycles 2

# Swimmers of periods of their own.
beadswim-layout defect frequency swarm.layout.json --sigma 0.05 --seed 5 >periods.layout.json
run periods --model rpy --cycles 3

# One swimmer in open space: no box.
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.2 >open.layout.json
run open --model rpy --cycles 2

# The same with units that MDAnalysis converts.
beadswim-layout swimmer --preset paper-single --units nm,ns,fg --radius 1000 --viscosity 1e3 --density 1e-6 --box 30000,10000,10000 \
  --boundary periodic --position 4000,5000,5000 >units.layout.json
run units --model rpy --cycles 2

# A run that its time limit stops at once, and the same gone on with to its end.
beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 \
  --position 5,20,20 | tee early.layout.json >restarted.layout.json
status=0
run early --model rpy --cycles 3 --time-limit 1e-6 2>early.said || status=$?
[ "$status" -eq 4 ] || { cat early.said >&2; exit 1; }
beadswim-run --restart early.h5md -o restarted.h5md --progress none >restarted.run.json
echo "$(ls ./*.h5md | wc -l) trajectories"
