#!/bin/bash
# Draws figure 4 of the paper (Pickl et al. 2017): the setup of a swarm, with the distances of neighbours and the swimmers A and
# B.
#   examples/figure-4.sh [FOLDER [FLAGS of beadswim-layout swarm...]]   writes to FOLDER (default: out/figure-4):
#     swarm.json     the layout: one block of 1 x 3 x 3 swimmers in a periodic box
#     figure-4.svg   the block and its periodic copies
# With --preset paper-uniform, draws the uniform swarm instead of the swarm with a defect.
set -euo pipefail

preset=paper-defect
copies=2,2,2      # periodic copies of the block, to show the distance D between blocks
A=0               # id of swimmer A, at y = z = 23; ids increase along y first
B=3               # id of swimmer B, at y = 23, z = 60

out=${1:-out/figure-4}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH
[[ " $* " == *" --preset "* ]] || set -- --preset "$preset" "$@"

beadswim-layout swarm "$@" |
  tee "$out/swarm.json" |
  beadswim-plot swarm - --repeat "$copies" --distances --mark "A=$A,B=$B" -o "$out/figure-4.svg"
echo "$out/figure-4.svg" >&2
