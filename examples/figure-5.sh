#!/bin/bash
# Draws figure 5 of the paper (Pickl et al. 2017): the uniform swarm, which moves along x and keeps its order.
#   examples/figure-5.sh [FOLDER [FLAGS of beadswim-run...]]     writes to FOLDER (default: out/figure-5):
#     uniform.h5md, uniform.json   run of one swimmer in a periodic box of 96 x 32 x 32, the unit cell of the swarm
#     figure-5a.svg                the swarm at the end of the run, with alternating colours of the blocks
#     figure-5b.svg                x of the middle bead of one swimmer; all swimmers move equally
# An existing run in FOLDER is kept. 124 cycles take ten minutes on one core at the paper's resolution, and half a minute with
# --cells-per-radius 3.
set -euo pipefail

cycles=124
frames_per_cycle=12
copies=3,9,9      # copies of the unit cell in figure 5a: 243 swimmers, in blocks of 1 x 3 x 3

out=${1:-out/figure-5}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH
[[ " $* " == *" --cycles "* ]] || set -- --cycles "$cycles" "$@"

if [ ! -e "$out/uniform.h5md" ]; then
  status=0
  beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce |
    beadswim-run - -o "$out/uniform.h5md" --frames-per-cycle "$frames_per_cycle" "$@" >"$out/uniform.json" || status=$?
  # Exit status 4 or 3: the run stopped early, because a bead was too fast or beads overlapped. This is also a result; the files
  # contain the run until it stopped.
  [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || [ "$status" -eq 3 ] || exit "$status"
fi

beadswim-plot swarm "$out/uniform.h5md" --repeat "$copies" -o "$out/figure-5a.svg"
beadswim-plot trajectories "$out/uniform.h5md" --along x -o "$out/figure-5b.svg"
for part in a b; do echo "$out/figure-5$part.svg" >&2; done
