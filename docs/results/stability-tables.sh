#!/bin/bash
# Prints the tables of docs/swarm-stability.md from the records of stability.sh.
#   docs/results/stability-tables.sh FOLDER
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cd "${1:?name the folder of the records}"
jq -rs -f "$here/stability-tables.jq" order.jsonl larger.jsonl rows.jsonl along.jsonl along_fine.jsonl map.jsonl phases.jsonl
