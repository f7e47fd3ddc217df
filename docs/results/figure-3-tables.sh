#!/bin/bash
# Prints the tables of docs/figure-3.md from the records of figure-3.sh and predictions by the present programs.
#   docs/results/figure-3-tables.sh FOLDER     (a minute; the programs on PATH)
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cd "${1:?name the folder of the records}"
command -v beadswim-theory >/dev/null || PATH=$(realpath "$here/../..")/build/release/bin:$PATH

methods=oseen-force-closed,rpy-equal-weight,multipole-ode,rpy-ode,rpy-box-ode,inertia-corrected

# Prints each record of a file with its predictions, one per line: {name, run, theory: {METHOD: prediction}}.
with_theory() { # NAME FILE LAYOUT-FLAGS...
  local name=$1 file=$2
  shift 2
  while read -r record; do
    beadswim-layout swimmer --preset paper-single $(jq -r '"--box \(.domain.lengths | join(",")) --boundary \(.domain.boundary[0])
      --period \(.driving.period) --amplitude \(.driving.amplitude | join(",")) --phase=\(.driving.phase)"' <<<"$record") "$@" |
      beadswim-theory - --method "$methods" |
      jq -c --arg name "$name" --argjson run "$record" \
        '{name: $name, run: $run, theory: (.predictions | map({key: .method, value: .}) | from_entries)}'
  done <"$file"
}

{
  for setting in fine staircase three coarse; do
    for sweep in by-period by-amplitude-ratio by-phase; do
      file=$setting/$sweep.jsonl
      [ ! -e "$file" ] || with_theory "$setting" "$file" | jq -c --arg sweep $sweep '. + {sweep: $sweep}'
    done
  done
  [ ! -e levels/by-period.jsonl ] || with_theory levels levels/by-period.jsonl
  [ ! -e walls-levels.jsonl ] || jq -c '{name: "walls-levels", run: .}' walls-levels.jsonl
  [ ! -e slow.jsonl ] || with_theory slow slow.jsonl --stiffness 0.00347
  for file in walls.jsonl closed.jsonl; do [ ! -e "$file" ] || with_theory walls "$file"; done
  for setting in fine staircase three coarse; do
    [ ! -e cost.txt ] || with_theory "cost-$setting" <(sed -n "s/^$setting //p" cost.txt)
  done
} | jq -rs -f "$here/figure-3-tables.jq"
