#!/bin/bash
# Prints the tables of docs/speed-against-error.md from the records that speed-against-error.sh made: with CELLS, only the lattice
# runs with this number of cells per radius.
#   docs/results/speed-against-error-tables.sh FOLDER [CELLS]
set -euo pipefail
folder=$1
results=$(realpath "$(dirname "$0")")
while read -r name title; do
  jq -c --arg title "$title" --slurpfile reference "$folder/$name-reference.json" -s '{title: $title, runs: ., reference: $reference[0]}' \
    "$folder/$name.jsonl"
done <<'END' | jq -rs -L "$results" --argjson cells "${2:-null}" -f "$results/speed-against-error.jq"
swimmer one swimmer
cell swarm, unit cell
nine nine swimmers
many 540 swimmers
END
