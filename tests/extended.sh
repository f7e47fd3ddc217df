#!/bin/bash
# Runs the slower checks: unit tests and a small scene under the sanitizers, and the tests labelled slow (among them the files in
# readers of other projects, the page of beadswim-view, the commands of README.md and of the documentation). Each part has a time
# limit. Both together take 30 to 45 minutes on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD

preset=${BEADSWIM_PRESET:-release}

set -a
. tests/mpi.env
set +a

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

section() { printf '\n== %s\n' "$*"; }

build() { # PRESET [TARGET...]
  cmake --preset "$1"
  timeout 2400 cmake --build --preset "$1" ${2:+--target "${@:2}"}
}

# Runs a small swimmer for a few hundred time steps. This executes every part of a time step.
tiny_scene() { # RANKS BEAD-BOUNDARY
  beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic \
    --period 100 --amplitude 0.02 >layout.json
  timeout 600 mpirun -n "$1" beadswim-run layout.json -o "ranks$1.h5md" --cells-per-radius 2 --relaxation-time 1.5 \
    --bead-boundary "$2" --radius-correction on --cycles 2 --flow-every 1 --progress none --no-provenance \
    >"ranks$1.json"
}

# Runs a sphere that is pulled through a box with two levels of cells, which follow it.
scene_with_levels() { # RANKS
  beadswim-layout shape sphere --radius 3 --force 2 --amplitude 0 --direction 3,2,1 --period 400 --viscosity 0.16666667 \
    --density 1 --units lattice --box 72,64,64 --boundary periodic --position 50,32,32 >layout.json
  timeout 600 mpirun -n "$1" beadswim-run layout.json -o "ranks$1.h5md" --cells-per-radius 3 --relaxation-time 1 --refine 1 \
    --cycles 0.5 --flow-every 0.25 --checkpoint-every 0.25 --progress none --no-provenance >"ranks$1.json"
}

.ci/install-packages.sh --with-readers

section "Unit tests under the address and undefined-behaviour sanitizers, on 3 ranks or 1"
build sanitize unit_tests beadswim-layout beadswim-run beadswim-theory
# Left out: long comparisons of numbers, whose code other tests execute.
long=FluidMemoryTest.ConvergesToExactMultipolesOfTwoSpheres:NearField.IsSymmetricAndPositiveDefinite
long=$long:NearField.KeepsTheNetForceAndUniformFlow:NearField.TurnsAndMovesWithTheSwimmers
long=$long:OverdampedSwimmer.SwimsAsExactStokesFlowSaysWithNearFields:OverdampedSwimmer.SwimsAsHarmonicBalanceSaysInOpenSpace
long=$long:MobilityRoot.GivesVelocitiesWhoseCovarianceIsTheMobility:Diffusion.IsThatOfARandomWalkWithItsError
GTEST_FILTER=-$long \
  timeout 2000 ctest --preset sanitize --label-regex unit

section "Tiny scenes under the sanitizers, on 1 and 3 ranks, and predictions by all methods"
cd "$scratch"
(
  PATH=$root/build/sanitize/bin:$PATH
  set -a
  . "$root/tests/sanitizers/sanitizers.env"
  for scheme in psm mr cli staircase; do
    for ranks in 1 3; do tiny_scene "$ranks" $scheme; done
    cmp ranks1.json ranks3.json
    echo "$scheme: 1 and 3 ranks give the same record."
  done
  for ranks in 1 3; do scene_with_levels "$ranks"; done
  cmp ranks1.json ranks3.json
  echo "with levels of cells: 1 and 3 ranks give the same record."
  for scene in "swimmer --preset paper-single --unbounded" "swimmer --preset paper-single --box 120,80,80" \
    "shape triangle --unbounded" "shape triangle --half-space z --position 0,0,30"; do
    beadswim-layout $scene | timeout 600 beadswim-theory - >predictions.json
    echo "beadswim-layout $scene: $(jq '.predictions | length' predictions.json) methods predict its motion."
  done
)

cd "$root"
build "$preset"

section "Tests labelled slow, among them documents in other readers, the page of beadswim-view in a browser, the commands of pages"
BEADSWIM_NONE_SKIPPED=1 timeout 3600 ctest --preset "$preset" --label-regex slow

section "All extended checks passed"
