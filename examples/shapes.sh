#!/bin/bash
# Runs and predicts all swimmers of docs/shapes.md, by the examples in the folder shapes, in ten seconds.
#   examples/shapes.sh [FOLDER]   writes to FOLDER/KIND for each kind; default: out/shapes/KIND
set -euo pipefail

for example in "$(dirname "$0")"/shapes/*.sh; do
  kind=$(basename "$example" .sh)
  [ "$kind" = shape ] || "$example" "${1:-out/shapes}/$kind"
done
