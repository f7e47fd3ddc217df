#!/bin/bash
# Makes the records of docs/figure-3.md, in part by examples/figure-3-runs.sh.
#   docs/results/figure-3.sh FOLDER [GROUP...]     (90 minutes on 2 idle cores, including 45 minutes for group closed)
# Groups: fine, staircase (bead boundary of the paper), three, coarse: figure 3 at several settings; levels: in the paper's box, with
# levels of cells; slow: almost no inertia; walls: free-slip and periodic boxes of several sizes; walls-levels: the free-slip boxes
# with levels of cells; closed: the paper's box with cells of one size; cost: core-seconds. Existing files are kept.
set -euo pipefail
folder=${1:?name a folder for the records}
shift
examples=$(realpath "$(dirname "$0")")/../../examples
mkdir -p "$folder"
cd "$folder"
command -v beadswim-run >/dev/null || PATH=$(realpath "$examples/..")/build/release/bin:$PATH
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1

fine() { "$examples/figure-3-runs.sh" fine; }
staircase() {
  "$examples/figure-3-runs.sh" staircase by-period --bead-boundary staircase --radius-correction off --delay-correction off
}
three() { "$examples/figure-3-runs.sh" three --cells-per-radius 3 --precision single; }
coarse() { "$examples/figure-3-runs.sh" coarse --cells-per-radius 2 --precision single; }
levels() {
  BOX=1200,800,800 BOUNDARY=free-slip PERIODS="$(seq -s ' ' 1000 1000 10000) 4800" "$examples/figure-3-runs.sh" levels --refine auto
}

simulate() { # FLAGS...   standard input: layout; prints a record as one line
  mpirun -n 2 beadswim-run - -o run.h5md --progress none "$@" | jq -c . && rm run.h5md{,.xdmf2}
}

# Stiffness and frequency are divided by ten: γω/k and strokes are the same as at T = 4800, inertia is a tenth.
slow() {
  local cells
  for cells in 2 3 4; do
    beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic --position 60,40,40 --stiffness 0.00347 --period 48000 \
      --amplitude 0.02 | simulate --cells-per-radius $cells --relaxation-time 3 --cycles 2
  done >slow.part
  mv slow.part slow.jsonl
}

in_box() { # BOX BOUNDARY FLAGS...   T = 4800, A = 0.2
  local box=$1 boundary=$2
  shift 2
  beadswim-layout swimmer --preset paper-single --box "$box" --boundary "$boundary" --amplitude 0.2 \
    --position "$(jq -nr "[$box] | map(. / 2) | join(\",\")")" |
    simulate --cells-per-radius 2 --precision single "$@"
}
walls() {
  for box in 120,80,80 160,80,80 200,120,120 300,200,200 400,260,260 600,400,400; do in_box $box free-slip --cycles 3; done >walls.part
  for box in 60,40,40 80,60,60 120,80,80 160,120,120 240,160,160; do in_box $box periodic --cycles 3; done >>walls.part
  mv walls.part walls.jsonl
}
walls-levels() {
  for box in 120,80,80 160,80,80 200,120,120 300,200,200 400,260,260 600,400,400 1200,800,800; do
    in_box $box free-slip --cycles 3 --refine auto
  done >walls-levels.part
  mv walls-levels.part walls-levels.jsonl
}
closed() { # 96 million cells, 12 GB
  in_box 1200,800,800 free-slip --cycles 3 >closed.part
  mv closed.part closed.jsonl
}

# Runs one cycle at each setting on an idle machine and prints lines "SETTING RECORD".
cost() {
  cycle() { # SETTING FLAGS...
    local setting=$1 record
    shift
    record=$(beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic --position 60,40,40 | simulate --cycles 1 "$@")
    echo "$setting $record"
  }
  {
    cycle fine
    cycle staircase --bead-boundary staircase --radius-correction off --delay-correction off
    cycle three --cells-per-radius 3 --precision single
    cycle coarse --cells-per-radius 2 --precision single
  } >cost.part
  mv cost.part cost.txt
}

[ $# -gt 0 ] || set -- fine staircase three coarse levels slow walls walls-levels cost closed
for group; do
  [ -e "$group.jsonl" ] || [ -e "$group.txt" ] || "$group"
done
# The records keep the last two cycles of each run, without provenance.
shopt -s nullglob
for file in *.jsonl */*.jsonl; do
  jq -c 'del(.provenance) | .swimmers[].cycles |= .[-2:]' "$file" >kept.part
  mv kept.part "$file"
done
