#!/bin/bash
# Tests the container definition examples/containers/beadswim.def without Apptainer. Runs its sections in two minimal Debian 12 systems
# (.ci/bare-debian.sh): the files and %post of both stages, then %environment and %test. Takes about ten minutes.
#   tests/container.sh FOLDER
set -euo pipefail
cd "$(dirname "$0")/.."
definition=examples/containers/beadswim.def
folder=$(realpath -m "${1:?name a folder for two small systems}")

section() { # STAGE NAME: prints the lines of a section
  awk -v stage="$1" -v name="$2" '
    /^Stage: / { now = $2; inside = 0 }
    /^%/ { inside = (now == stage && $0 ~ "^%" name); next }
    /^Bootstrap:/ { inside = 0 }
    inside && NF' "$definition"
}

# Runs the script on standard input in the system of the stage, which is created if it does not exist.
inside() { .ci/bare-debian.sh "$folder/$1" env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 DEBIAN_FRONTEND=noninteractive sh; }

inside build </dev/null
section build files | while read -r from to; do
  mkdir -p "$folder/build$to"
  cp -r "$from" "$folder/build$to"
done
section build post | inside build
inside final </dev/null
section final 'files from build' | while read -r from to; do cp "$folder/build$from" "$folder/final$to"; done
section final post | inside final
{ section final environment; section final test; } | inside final
