#!/bin/bash
# Makes documents of every schema with the programs, in the folder where scenes.sh has made its files: documents/SCHEMA/NAME.json.
set -euo pipefail

corpus=$(realpath "$(dirname "$0")/../fuzz/corpus")
mkdir -p documents/{layout,layout-2,layout-check,run,prediction,verdict,plan,bench,failure}
cd documents

# Layouts: presets, units, frames, boxes, every defect, a reduced cell.
swimmer() { beadswim-layout swimmer --preset paper-single "$@"; }
swimmer >layout/single.json
swimmer --unbounded --units um,s,pg --radius 1 --viscosity 1e6 --density 1 >layout/units.json
swimmer --unbounded | jq 'del(.resolution) |
  .units = {length: {name: "cell", si_factor: 2.5e-7}, time: "us", mass: "pg"}' >layout/own-units.json
beadswim-layout swimmer --radius 4,5,4 --arm 20,24 --stiffness 0.03,0.04 --damping 0,0.1 --angular-stiffness 0 \
  --bead-density 1 --amplitude 0.2,0 --phase=-1 --period 3000 --viscosity 0.3333 --density 1 --frame body \
  --box 120,80,80 --boundary periodic,free-slip,no-slip >layout/unequal.json
beadswim-layout swarm --preset paper-uniform --blocks 2,2,2 --block-swimmers 1,2,2 >layout/swarm.json
beadswim-layout swarm --preset paper-defect >layout/paper-defect.json
beadswim-layout reduce layout/swarm.json >layout/cell.json 2>/dev/null
disturb() { # DEFECT FLAGS...
  beadswim-layout defect "$1" layout/swarm.json --seed 1 "${@:2}" >"layout/$1.json"
}
for filter in 'vacancy --count 2' 'interstitial --count 1' 'jitter --sigma 0.5' 'rotation --sigma 0.1' 'domains --count 2' \
  'phase --sigma 0.3' 'amplitude --sigma 0.1' 'frequency --sigma 0.1' 'spacing --axis y --sigma 1' \
  'mixture --count 3 --with layout/single.json'; do
  disturb $filter # as words
done

# Swimmers of any shape: beads in a loop with every kind of drive, a lone bead; changed by filters.
beadswim-layout defect amplitude --sigma 0.1 --seed 1 "$corpus/layout/shape.json" >layout-2/amplitude.json
beadswim-layout defect rotation --random --seed 1 layout-2/amplitude.json >layout-2/rotation.json

# Layouts of a study.
beadswim-layout vary layout/single.json --over amplitude=0.1,0.2 --over /swimmers/0/id=1,2 | sed -n 2p >layout/study.json

# What check says of them.
for name in layout/{single,units,unequal,swarm,mixture} layout-2/amplitude; do
  beadswim-layout check "$name.json" --json >"layout-check/${name#*/}.json"
done

# Run records: resolved, by mobility, of many swimmers, stopped by time, by speed and by failure, without provenance.
for scene in lattice walls swarm periods open early restarted; do cp "../$scene.run.json" "run/$scene.json"; done
quick() { # EXIT-STATUS NAME LAYOUT FLAGS...
  local expected=$1 name=$2 layout=$3 status=0
  shift 3
  beadswim-run "$layout" -o ../quick.h5md --progress none "$@" >"run/$name.json" 2>../quick.said || status=$?
  [ "$status" -eq "$expected" ] || { echo "run/$name.json: exit status $status" >&2; cat ../quick.said >&2; exit 1; }
}
quick 0 no-provenance ../open.layout.json --model rpy+near --cycles 1 --no-provenance
quick 0 single ../lattice.layout.json --cells-per-radius 2 --relaxation-time 1.5 --cycles 1 --precision single --bead-boundary psm
beadswim-layout swarm --preset paper-uniform --blocks 2,3,4 --block-swimmers 1,2,2 >../many.layout.json
quick 0 many ../many.layout.json --model rpy --cycles 0.5
quick 0 shapes layout-2/amplitude.json --model rpy --cycles 2
quick 0 many-cycle ../many.layout.json --model oseen --sum-tolerance 0.01 --cycles 1
swimmer --radius 2 --arm 9 --box 32,16,16 --boundary periodic --period 100 --amplitude 100 --stiffness 5 >../fast.layout.json
quick 4 too-fast ../fast.layout.json --cells-per-radius 2 --relaxation-time 1.5 --cycles 1

# Predictions: all methods in a box, between walls, in open space; of a measured stroke; with warnings; line by line.
beadswim-theory ../lattice.layout.json >prediction/box.json
beadswim-theory layout/unequal.json --method rpy-ode,multipole-perturbation >prediction/unequal.json
beadswim-theory ../open.layout.json --stroke-from ../open.run.json >prediction/open.json
beadswim-theory layout/units.json --method rpy-perturbation --tolerance 1e-6 >prediction/warned.json 2>/dev/null
beadswim-theory layout/frequency.json --swimmer 3 --method rpy-ode >prediction/of-one.json
jq -c . layout/single.json | beadswim-theory --jsonl - --method oseen-force-closed >prediction/line.json
beadswim-theory layout/study.json --method oseen-force-closed >prediction/study.json

# Streams in which one layout has no prediction, and one has walls that the model lacks.
jq -c . layout/study.json layout-2/amplitude.json >../stream.jsonl
beadswim-theory ../stream.jsonl --method rpy-force-repaired >../predictions.jsonl 2>/dev/null || [ $? -eq 3 ]
tail -n 1 ../predictions.jsonl >failure/theory.json
jq -c '., (.domain.boundary[1] = "no-slip")' layout/study.json |
  beadswim-run --model rpy --cycles 0.1 -o ../run-{}.h5md --progress none >../runs.jsonl 2>/dev/null || [ $? -eq 3 ]
head -n 1 ../runs.jsonl >run/study.json
tail -n 1 ../runs.jsonl >failure/run.json

# Verdicts, positive and negative, by a prediction and by a run.
compare() { # NAME FILES-AND-FLAGS...
  local status=0
  beadswim-compare "${@:2}" >"verdict/$1.json" 2>/dev/null || status=$?
  [ "$status" -le 1 ]
}
compare against-theory run/open.json prediction/open.json --method rpy-ode
compare negative run/open.json prediction/open.json --tolerance 1e-9
compare against-run run/lattice.json run/single.json --cycle 1
compare without-cost run/no-provenance.json prediction/open.json

# Plans: with a choice, with none.
plan() { # EXIT-STATUS NAME LAYOUT FLAGS...
  local status=0
  beadswim-run "$3" --plan "${@:4}" >"plan/$2.json" 2>../plan.said || status=$?
  [ "$status" -eq "$1" ] || { echo "plan/$2.json: exit status $status" >&2; cat ../plan.said >&2; exit 1; }
}
plan 0 choice ../open.layout.json --tolerance 0.5
plan 2 no-choice ../lattice.layout.json --tolerance 1e-6
plan 0 swarm ../swarm.layout.json --model rpy --tolerance 10 --no-provenance

# Benchmarks, of the lattice and of mobility products.
beadswim-bench --json --edge 32 --rounds 1 >bench/lattice.json 2>/dev/null
beadswim-bench --json --beads 300 --rounds 1 >bench/products.json 2>/dev/null
echo "$(ls ./*/*.json | wc -l) documents"
