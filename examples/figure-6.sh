#!/bin/bash
# Draws figure 6 of the paper (Pickl et al. 2017): the swarm whose layers have unequal distances, nine swimmers in a periodic box
# of 120 x 120 x 120.
#   examples/figure-6.sh [FOLDER [FLAGS of beadswim-run...]]     writes to FOLDER (default: out/figure-6):
#     defect.h5md, defect.json   the run; an existing run is kept
#     figure-6a.svg              x of the middle beads of swimmers A and B
#     figure-6b.svg              z of the beads of swimmer A, at a corner of its block
#     figure-6c.svg              y of the beads of swimmer B, at the edge of its block along y and in the middle along z
#     figure-6-swarm.svg         the swarm at the end of the run
# A cycle takes 50 s on one core at the paper's resolution, and 1 to 2 s with --cells-per-radius 3 --precision single. --cycles N
# changes the number of cycles (default: 124). The environment variable SWARM_FLAGS contains additional flags of beadswim-layout
# swarm, for example SWARM_FLAGS='--stiffness 0.0347'.
set -euo pipefail

cycles=124
frames_per_cycle=12
A=0               # id of swimmer A, at y = z = 23; ids increase along y first
B=3               # id of swimmer B, at y = 23, z = 60

out=${1:-out/figure-6}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH
[[ " $* " == *" --cycles "* ]] || set -- --cycles "$cycles" "$@"

if [ ! -e "$out/defect.h5md" ]; then
  status=0
  beadswim-layout swarm --preset paper-defect ${SWARM_FLAGS:-} |
    beadswim-run - -o "$out/defect.h5md" --frames-per-cycle "$frames_per_cycle" "$@" >"$out/defect.json" || status=$?
  # Exit status 4 or 3: the run stopped early, because a bead was too fast or beads overlapped. This is also a result; the files
  # contain the run until it stopped.
  [ "$status" -eq 0 ] || [ "$status" -eq 4 ] || [ "$status" -eq 3 ] || exit "$status"
fi

beadswim-plot trajectories "$out/defect.h5md" --swimmers "$A,$B" --along x -o "$out/figure-6a.svg"
beadswim-plot trajectories "$out/defect.h5md" --swimmers "$A" --beads 1,2,3 --along z -o "$out/figure-6b.svg"
beadswim-plot trajectories "$out/defect.h5md" --swimmers "$B" --beads 1,2,3 --along y -o "$out/figure-6c.svg"
beadswim-plot swarm "$out/defect.h5md" --repeat 2,2,2 -o "$out/figure-6-swarm.svg"
for part in a b c -swarm; do echo "$out/figure-6$part.svg" >&2; done
