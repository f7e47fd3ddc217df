#!/bin/bash
# Compares the costs that `beadswim-run --plan` expects with measured costs.
#   head -40 docs/results/random-scenes.jsonl | docs/results/run-costs.sh > run-costs.jsonl     (ten minutes on an otherwise idle core; the programs on PATH)
# Makes three runs per scene among those that are planned to take 0.5 to 10 core-seconds, spread over the list of the plan, and
# prints a line per run: flags, expected and measured core-seconds.
set -euo pipefail
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

while read -r scene; do
  # shellcheck disable=SC2046  # flags
  beadswim-layout swimmer $(jq -r .layout <<<"$scene") >"$work/layout.json"
  { beadswim-run "$work/layout.json" --plan --cycles 2 2>/dev/null || true; } >"$work/plan.json"
  jq -c '.scene as $scene | input | [.runs[] | select(.refused == null and .cost.core_seconds > 0.5 and .cost.core_seconds < 10)]
      | (length as $n | range([3, $n] | min) as $k | .[(($scene * 7 + $k * ($n / 3 | floor)) % $n)])
      | {scene: $scene, flags, expected: .cost.core_seconds}' <(echo "$scene") "$work/plan.json" >"$work/runs.jsonl"
  while read -r run; do
    # shellcheck disable=SC2046  # flags
    { beadswim-run "$work/layout.json" -o "$work/run.h5md" --cycles 2 --progress none $(jq -r .flags <<<"$run") </dev/null 2>/dev/null || true; } |
      jq -c --argjson run "$run" '$run + {measured: .cost.core_seconds}'
  done <"$work/runs.jsonl"
done
