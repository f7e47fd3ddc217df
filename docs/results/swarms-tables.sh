#!/bin/bash
# Prints the tables of docs/swarm-figures.md from the records of swarms.sh.
#   docs/results/swarms-tables.sh FOLDER
set -euo pipefail
here=$(realpath "$(dirname "$0")")
cd "${1:?name the folder of the records}"
jq -rs -f "$here/swarms-tables.jq" uniform.jsonl defect.jsonl sensitivity.jsonl fine.jsonl inertia.jsonl
