#!/bin/bash
# beadswim-plot: figures that are well-formed, the same on every run, and hold what they were given.
source "$(dirname "$0")/harness.sh"
cp "$BEADSWIM_SOURCE"/tests/data/compare/*.json .

well_formed() { # FILE
  check "$1 is not well-formed XML" python3 -c 'import sys, xml.dom.minidom as xml; xml.parse(sys.argv[1])' "$1"
}
drawn() { # NUMBER ELEMENT   how often the element is in out
  check "there are not $1 elements <$2>" test "$(grep -c "<$2 " out)" -eq "$1"
}

# --- what it says of itself
accepts beadswim-plot --help
for flag in '-o,--output' --method --cycle; do out_has "^  $flag"; done
accepts beadswim-plot --version

# --- stroke
accepts beadswim-plot stroke run.json prediction.json
well_formed out
drawn 12 circle    # 3 cycles of d1, d2 and the phase shift, and one of each in the legends
drawn 6 polyline   # one level line for each, and its legend
out_has '>d₁, multipole-ode<'
out_has '>arm amplitude \(lattice units\)<'
out_has 'T = 4800, δ/λ = 5.64, Re = 0.15; 4 cells per radius, τ = 1.5, cli, double; box 120 × 80 × 80'
accepts beadswim-plot stroke run.json prediction.json --method rpy-perturbation,oseen-force-closed
drawn 12 polyline
same_bytes 'beadswim-plot stroke run.json prediction.json' 'beadswim-plot stroke - prediction.json <run.json'
jq '.units = {length: {name: "um", si_factor: 1e-6}, time: {name: "s", si_factor: 1}, mass: {name: "pg", si_factor: 1e-15}}' \
  run.json >si.json
accepts beadswim-plot stroke si.json
out_has '>arm amplitude \(um\)<'

# --- velocity against period
files='run.json run_shorter_period.json prediction.json prediction_shorter_period.json'
accepts beadswim-plot velocity-against-period $files --method multipole-ode,oseen-force-closed
well_formed out
drawn 6 circle     # two runs, two predictions by the first method, and the legend's
drawn 4 polyline   # two methods and their legends
out_has '>velocity \(10⁻⁵ lattice units\)<'
out_has '>period T \(lattice units\)<'
accepts beadswim-plot velocity-against-period si.json --cycle 2
out_has '>velocity \(10⁻⁵ um/s\)<'

# --- files
accepts beadswim-plot stroke run.json prediction.json -o figure.svg
out_empty
same_bytes 'cat figure.svg' 'beadswim-plot stroke run.json prediction.json'
if command -v rsvg-convert >/dev/null; then
  accepts beadswim-plot stroke run.json prediction.json -o figure.png
  check 'figure.png is no PNG' test "$(head -c 8 figure.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a
fi
run env PATH=/nowhere "$(command -v beadswim-plot)" stroke run.json prediction.json -o other.png
has_status 2
err_has '^beadswim-plot: other.png: .*install the package librsvg2-bin'
check 'a refused figure left a file behind' test ! -e other.png
refuses '/no/such/folder/x.svg: cannot be created' beadswim-plot stroke run.json -o /no/such/folder/x.svg
refuses '--output: "x.pdf" is neither .svg nor .png' beadswim-plot stroke run.json -o x.pdf

# --- what it refuses
refuses 'KIND: none given; there are stroke, velocity-against-period' beadswim-plot
refuses 'KIND: unknown "strok"; did you mean "stroke"' beadswim-plot strok run.json
refuses 'no file given' beadswim-plot stroke
refuses 'no run with a whole cycle' beadswim-plot stroke prediction.json
refuses 'in other units' beadswim-plot stroke si.json run.json
refuses '--method: no prediction has "multipol"; did you mean "multipole-ode"' \
  beadswim-plot stroke run.json prediction.json --method multipol
jq 'del(.predictions[].settings.period)' prediction.json >timeless.json
refuses 'timeless.json: does not say the period' beadswim-plot velocity-against-period timeless.json
refuses 'standard input can be read once' beadswim-plot stroke - -
refuses 'run.h5md: is a trajectory' beadswim-plot stroke run.h5md

finish
