#!/bin/bash
# Runs the commands of a page that follow the comment <!-- tested -->, as one script in an empty folder, and looks up in their output
# the percentages of the paragraphs that follow <!-- printed -->.
#   tests/docs/commands.sh PAGE    with the programs on PATH; python3 is Debian's, for which there are packages of readers
set -euo pipefail
page=$(realpath "$1")

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export XDG_CACHE_HOME=$folder/cache # of the lattice speed, which other tests disturb
mkdir "$folder/python" "$folder/page"
ln -s /usr/bin/python3 "$folder/python/python3"
PATH=$folder/python:$PATH
cd "$folder/page"
awk '/<!-- tested -->/ { armed = 1; next }
     armed && /^```sh$/ { inside = 1; armed = 0; next }
     /^```$/ { inside = 0 }
     inside' "$page" >commands.sh
[ -s commands.sh ] || { echo "$page holds no block after <!-- tested -->" >&2; exit 1; }
if grep -q python3 commands.sh && [ -z "${BEADSWIM_NONE_SKIPPED:-}" ]; then
  python3 -c 'import h5py, pandas, MDAnalysis' || { echo "skipped: Python lacks h5py, pandas or MDAnalysis"; exit 77; }
fi
cat commands.sh
bash -euo pipefail commands.sh 2>&1 | tee printed

# Numbers that a reader is to find: each percentage in the paragraph after <!-- printed --> is one that the commands print.
awk '/<!-- printed -->/ { armed = 1; next } /^$/ { armed = 0 } armed' "$page" | grep -oE '[-+0-9.]+ %' >claimed || exit 0
missing=$(while read -r claim; do grep -qE "(^|[^0-9.])${claim/+/[+]}" printed || echo "$claim"; done <claimed)
[ -z "$missing" ] || { printf 'not printed:\n%s\n' "$missing" >&2; exit 1; }
