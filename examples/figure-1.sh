#!/bin/bash
# Draws figure 1 of the paper (Pickl et al. 2017): the bead-spring swimmer, to scale, with its driving forces.
#   examples/figure-1.sh [FOLDER [FLAGS of beadswim-layout swimmer...]]   writes to FOLDER (default: out/figure-1):
#     swimmer.json   the layout
#     figure-1.svg   the sketch of the swimmer
set -euo pipefail

out=${1:-out/figure-1}
shift "$(($# > 0))"
mkdir -p "$out"
command -v beadswim-plot >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH

beadswim-layout swimmer --preset paper-single "$@" |
  tee "$out/swimmer.json" |
  beadswim-plot swimmer - -o "$out/figure-1.svg"
echo "$out/figure-1.svg" >&2
