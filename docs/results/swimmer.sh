#!/bin/bash
# Makes the run records swimmer-*.json of this folder, which tests draw: the paper's swimmer in a periodic box of 120 x 80 x 80 cells.
#   docs/results/swimmer.sh FOLDER        (some minutes on 2 idle cores; the programs on PATH)
set -euo pipefail
folder=${1:?name a folder for the records}
mkdir -p "$folder"
for period in 2000 4800; do
  layout=$folder/swimmer-T$period-A0.2.layout.json
  beadswim-layout swimmer --preset paper-single --box 120,80,80 --boundary periodic --position 60,40,40 \
    --period "$period" --amplitude 0.2 >"$layout"
  measure() { # SCHEME [FLAGS...]
    local name=swimmer-$1-T$period-A0.2
    mpirun -n 2 beadswim-run "$layout" -o "$folder/$name.h5md" --bead-boundary "$@" --cycles 6 \
      >"$folder/$name.json" </dev/null
  }
  measure mr
  [ "$period" = 2000 ] || measure staircase --radius-correction off --delay-correction off  # bead boundary of the paper
done
