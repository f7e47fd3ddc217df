#!/bin/bash
# Makes the records of docs/resolution.md: runs of one swimmer at several resolutions, with every bead boundary.
#   docs/results/resolution.sh FOLDER     (half an hour on 2 cores; the programs on PATH)
# Writes FOLDER/resolution.jsonl (one record per line, with the fourth cycle only), resolution-reference.json and the page's
# table, resolution.txt.
set -euo pipefail
folder=${1:?name a folder for the records}
mkdir -p "$folder"
results=$(realpath "$(dirname "$0")")
cd "$folder"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

# The paper's swimmer, T = 2000, A = 0.2, with its centre at the N-th position of a sequence that fills a lattice cell evenly.
layout() { # CELLS-PER-RADIUS N
  beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 \
    --position "$(jq -nr --argjson cell "$((12000 / $1))e-3" --argjson n "$2" \
      '[[30, 0.8191725], [20, 0.6710436], [20, 0.5497005]] | map(.[0] + $cell * (.[1] * $n | . - floor)) | join(",")')"
}

measure() { # SCHEME CELLS-PER-RADIUS POSITIONS [FLAGS...]   prints one record per position
  local scheme=$1 cells=$2 places=$3 work
  shift 3
  work=$(mktemp -d)
  for n in $(seq "$places"); do
    layout "$cells" "$n" >"$work/layout.json"
    beadswim-run "$work/layout.json" -o "$work/run.h5md" --bead-boundary "$scheme" --cells-per-radius "$cells" \
      --cycles 4 --progress none "$@" </dev/null | jq -c 'del(.provenance) | .swimmers[].cycles |= .[-1:]'
  done
  rm -r "$work"
}

at_each_resolution() { # SCHEME [FLAGS...]
  local scheme=$1
  shift
  measure "$scheme" 2 8 "$@"
  measure "$scheme" 3 6 "$@"
  measure "$scheme" 4 3 "$@"
}

without_corrections=(--delay-correction off --radius-correction off)

first_half() {
  measure mr 8 1 >resolution-reference.json
  measure mr 6 2
  for scheme in staircase mr; do at_each_resolution $scheme; done
  for scheme in staircase mr; do at_each_resolution $scheme "${without_corrections[@]}"; done
  at_each_resolution mr --relaxation-time 1
  at_each_resolution mr --precision single
}

second_half() {
  measure psm 8 1 >psm-8.part
  for scheme in cli psm; do at_each_resolution $scheme; done
  for scheme in cli psm; do at_each_resolution $scheme "${without_corrections[@]}"; done
  at_each_resolution psm --relaxation-time 1
  at_each_resolution psm --precision single
  for scheme in mr psm; do
    measure $scheme 2 8 --relaxation-time 0.8
    measure $scheme 3 6 --relaxation-time 0.8
  done
}

first_half >first.part &
trap 'kill $! 2>/dev/null || true' EXIT
second_half >second.part
wait $!
cat first.part second.part psm-8.part >resolution.jsonl
rm first.part second.part psm-8.part
jq -rs -L "$results" --slurpfile reference resolution-reference.json -f "$results/resolution.jq" resolution.jsonl >resolution.txt
