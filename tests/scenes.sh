#!/bin/bash
# Writes the results of sixteen small scenes into FOLDER, which must not exist, and their hashes into FOLDER/SHA256SUMS.
#
#   tests/scenes.sh FOLDER      (with the built programs on PATH; about half a minute on two cores)
#
# The script shows that a change of the code changes no result: build the revisions before and after the change with the same
# compiler on the same machine, run the script with the programs of each build, and compare the hashes.
#
#   PATH=BEFORE/build/release/bin:$PATH tests/scenes.sh before
#   PATH=AFTER/build/release/bin:$PATH tests/scenes.sh after
#   diff before/SHA256SUMS after/SHA256SUMS     (no output: all results are equal, byte for byte)
#
# The results contain no measured times and no revision. Each trajectory is stored as text, the output of h5dump.
# shellcheck disable=SC2086  # the flags of a scene are separate words
set -euo pipefail
export LC_ALL=C
[ $# -eq 1 ] || { sed -n '2,13s/^# \{0,1\}//p' "$0" >&2; exit 2; }
documented=$(realpath "$(dirname "$0")/../docs/results")
mkdir "$1"
folder=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

# Settings of Open MPI that allow runs as root, as in a container, and more ranks than cores.
if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_btl_vader_single_copy_mechanism=none

layout() { # NAME: stores the layout from standard input, without its provenance, which contains the revision
  jq 'del(.provenance)' | tee "$folder/$1.layout.json" >"$1.json"
}
tiny() { # NAME FLAG...: makes a small swimmer with a period of 100 time steps
  beadswim-layout swimmer --preset paper-single --period 100 "${@:2}" | layout "$1"
}
open() { beadswim-layout swimmer --preset paper-single --unbounded "${@:2}" | layout "$1"; } # NAME FLAG...
launch() { # RANKS ARGUMENT...
  local mpi=()
  [ "$1" -eq 1 ] || mpi=(mpirun -n "$1")
  "${mpi[@]}" beadswim-run "${@:2}" --progress none --no-provenance
}
results() { # NAME: stores the record and the trajectory of a finished run
  mv "$1.record" "$folder/$1.run.json"
  h5dump -m %.17g "$1.h5md" | sed '1d; /^ *GROUP "creator" {/,/^      }$/d' >"$folder/$1.h5md.txt"
}
run() { # NAME RANKS LAYOUT FLAG...
  launch "$2" "$3.json" -o "$1.h5md" "${@:4}" >"$1.record" 2>"$1.log" || { cat "$1.log" >&2; exit 1; }
  results "$1"
}
lattice() { run "$@" --model lbm --cells-per-radius 2 --relaxation-time 1.5; } # NAME RANKS LAYOUT FLAG...
mobility() { run "$1" 1 "$2" --model "${@:3}" --steps-per-cycle 40; }          # NAME LAYOUT MODEL FLAG...

scene_bead_schemes() {
  tiny swimmer --radius 2 --arm 9 --amplitude 0.02 --box 32,16,16 --boundary periodic --position 3.2,7.9,8.3
  for scheme in psm mr cli staircase; do
    lattice $scheme-double 1 swimmer --bead-boundary $scheme --cycles 2
    lattice $scheme-single 2 swimmer --bead-boundary $scheme --cycles 1 --precision single
  done
}
scene_walls() {
  for walls in free-slip no-slip periodic,free-slip,no-slip; do
    tiny $walls --radius 2 --arm 9,8 --amplitude 0.02 --box 32,24,24 --boundary $walls --axis 0.8,0.6,0 --frame initial-axis
    lattice walls-$walls 1 $walls --cycles 1
  done
}
scene_lattice_settings() {
  tiny damped --radius 2,2.5,3 --arm 9 --damping 0.1,0.2 --amplitude 0.05,0.03 --box 40,20,20 --boundary periodic \
    --frame body
  lattice no-corrections 1 damped --radius-correction off --delay-correction off --lubrication off --cycles 1
  lattice flow 2 damped --flow-every 1 --cycles 1
  cp flow.h5md.flow.pvd flow.h5md.flow/*.vti "$folder"
}
scene_lattice_contacts() { # the arms become shorter than two bead radii, so that beads touch
  tiny near --radius 2 --arm 4.5 --amplitude 2 --stiffness 0.2 --axis 1,0.3,0 --box 32,16,16 --boundary periodic
  lattice contacts 1 near --friction 0.3 --cycles 2
}
scene_lattice_swarm() {
  beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,1 --radius 2 --arm 8 --core-gap 12 \
    --block-gap 8,16,16 --period 100 --amplitude 0.1 --frame initial-axis |
    beadswim-layout defect frequency --sigma 0.2 --seed 2 | beadswim-layout defect rotation --sigma 0.3 --seed 5 | layout four
  lattice swarm-one-rank 1 four --cycles 1
  lattice swarm-three-ranks 3 four --cycles 1
}
restart() { # NAME RANKS LAYOUT FLAG...: checks that a restarted run gives the results of the uninterrupted run
  run "$1" "$2" "$3" --cycles 1.5 "${@:4}"
  run "$1-first" "$2" "$3" --cycles 0.7 --checkpoint-every 0.35 "${@:4}"
  launch "$2" --restart "$1-first.h5md" -o "$1-restarted.h5md" --cycles 1.5 >"$1-restarted.record"
  results "$1-restarted"
  for result in run.json h5md.txt; do cmp "$folder/$1.$result" "$folder/$1-restarted.$result"; done
}
scene_restart() {
  restart lattice-whole 2 swimmer --model lbm --cells-per-radius 2
  restart mobility-whole 1 four --model rpy+near --steps-per-cycle 40
}
scene_open_mobility() {
  open uneven --radius 4,5,4.5 --arm 20,22 --damping 0.1,0.3 --amplitude 0.2,0.3 --axis 1,2,0.5 --frame body
  for model in oseen rpy rpy+near; do mobility open-$model uneven $model --cycles 2; done
}
scene_box_mobility() {
  beadswim-layout swimmer --preset paper-single --box 100,60,60 --boundary periodic,free-slip,free-slip | layout slip
  beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,2 |
    beadswim-layout defect rotation --sigma 0.2 --seed 5 | beadswim-layout defect phase --sigma 0.5 --seed 4 |
    beadswim-layout defect amplitude --sigma 0.1 --seed 3 | beadswim-layout defect vacancy --count 2 --seed 1 |
    layout defective
  for model in oseen rpy rpy+near; do
    for scene in slip defective; do mobility $scene-$model $scene $model --cycles 1; done
  done
}
scene_mobility_contacts() { # the beads come so close that the contact law repels them
  open close --arm 14 --amplitude 0.4
  for model in rpy rpy+near; do mobility contacts-$model close $model --cycles 1; done
}
scene_large_swarm() { # the record contains statistics instead of each swimmer
  beadswim-layout swarm --preset paper-uniform --blocks 2,2,2 | beadswim-layout defect jitter --sigma 0.5 --seed 2 | layout large
  mobility large large rpy --cycles 1
}
scene_defects() {
  beadswim-layout swarm --preset paper-uniform --blocks 2,1,1 | layout uniform
  beadswim-layout swimmer --preset paper-single | layout one
  for defect in "vacancy --count 3" "interstitial --fraction 0.05" "jitter --sigma 0.5" "rotation --random --repair" \
    "domains --count 3 --repair" "phase --sigma 0.3 --fraction 0.5" "amplitude --sigma 0.1" "frequency --sigma 0.01" \
    "spacing --axis y --sigma 3 --whole 1" "mixture --with one.json --count 5"; do
    beadswim-layout defect $defect --seed 2 uniform.json | layout "defect-${defect%% *}"
  done
}
scene_layouts() {
  beadswim-layout swimmer --radius 4 --arm 20 --stiffness 0.03 --amplitude 0.1 --period 1000 --viscosity 0.2 --density 2 \
    --units um,ms,pg --box 100,50,50 --boundary periodic,no-slip,free-slip --frame body --axis 0,0,-2 | layout units
  beadswim-layout swimmer --preset paper-single --jsonl | layout line
  beadswim-layout swarm --preset paper-defect --blocks 2,1,1 | beadswim-layout reduce 2>/dev/null | layout reduced
  for name in units line reduced; do
    beadswim-layout check "$name.json" >"$folder/$name.check.txt"
    beadswim-layout check --json "$name.json" | jq 'del(.provenance)' >"$folder/$name.check.json"
  done
}
# Predicts errors and costs of runs. The speed of the lattice is set to fixed values, so that the costs in the plan are
# reproducible. Measured times are removed from the plan.
scene_plan() {
  export XDG_CACHE_HOME=$scratch
  mkdir beadswim
  jq -n --arg version "$(beadswim-run --version | cut -d' ' -f2-)" \
    --arg processor "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)" '
    {schema: "beadswim/lattice-speed/1", version: $version, processor: $processor, ranks: 1, precisions:
      [1e-8, 6e-9 | {cells: [1728, 13824, 110592, 884736], seconds_per_cell: [., . * 1.1, . * 1.4, . * 1.5],
                     seconds_per_area: [. * 5, . * 20, . * 25, . * 30]}]}' | tee known >beadswim/lattice-speed-1.json
  beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce 2>/dev/null | layout cell
  for name in cell uneven; do
    beadswim-run "$name.json" --plan --tolerance 0.12 --no-provenance 2>"$name.log" |
      jq 'del(.runs[].cost | .core_seconds?, .wall_seconds?)' >"$folder/$name.plan.json"
  done
  cmp known beadswim/lattice-speed-1.json # if the files differ, the speed was measured again
  run auto-mobility 1 uneven --model auto --tolerance 0.12 --cycles 1
  run auto-lattice 1 cell --model auto --tolerance 0.2 --cycles 0.2
}
predict() { # NAME FLAG...
  beadswim-theory "$1.json" "${@:2}" 2>"$1.log" | jq 'del(.provenance)' | tee "$folder/$1.prediction.json" >"$1.prediction.json"
}
scene_predictions() {
  open alone
  open uneven-x --radius 4,5,4.5 --arm 20,22 --damping 0.1,0.3 --amplitude 0.2,0.3
  beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic | layout periodic-box
  for name in alone uneven-x slip periodic-box; do predict $name; done
  open of-run
  mobility stroke of-run rpy --cycles 2
  predict of-run --stroke-from "$folder/stroke.run.json"
}
scene_comparisons() {
  cp "$folder/stroke.run.json" .
  for tolerance in 0.05 1e-9; do
    beadswim-compare stroke.run.json of-run.prediction.json --tolerance $tolerance >"$folder/verdict-$tolerance.json" \
      2>"$folder/verdict-$tolerance.txt" || [ $? -eq 1 ]
  done
}
draw() { beadswim-plot "${@:2}" >"$folder/$1.svg"; } # NAME KIND ARGUMENT...
scene_figures() {
  draw stroke stroke stroke.run.json of-run.prediction.json
  draw period velocity-against-period "$documented"/swimmer-mr-*-A0.2.json periodic-box.prediction.json --method multipole-ode,rpy-ode
  draw separation separation alone.prediction.json slip.prediction.json --method all
  draw speed speed-against-error "$documented"/swimmer-*-T4800-A0.2.json --reference periodic-box.prediction.json
  draw products mobility-products "$documented/mobility-products.json"
  draw trajectories trajectories swarm-one-rank.h5md
  draw swarm swarm swarm-one-rank.h5md
  draw layout swarm uniform.json --distances
  draw swimmer swimmer uneven-x.json
  beadswim-view swarm-one-rank.h5md -o page.html
  grep -o '<script type="text/plain".*' page.html >"$folder/page-data.txt"
}

for scene in bead_schemes walls lattice_settings lattice_contacts lattice_swarm restart open_mobility box_mobility \
  mobility_contacts large_swarm defects layouts plan predictions comparisons figures; do
  scene_$scene
done
cd "$folder"
sha256sum -- * >"$scratch/sums"
mv "$scratch/sums" SHA256SUMS
