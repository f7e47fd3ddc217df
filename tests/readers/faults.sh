#!/bin/bash
# Makes the invalid documents that faults.txt describes, in the folder of documents.sh: faults/SCHEMA/NAME-LINE.json.
set -euo pipefail

list=$(dirname "$0")/faults.txt
number=0
while IFS=' ' read -r document filter; do
  number=$((number + 1))
  [[ -z $document || $document == '#'* ]] && continue
  mkdir -p "faults/${document%/*}"
  jq "$filter" "documents/$document.json" >"faults/$document-line$number.json"
  if cmp -s <(jq -S . "documents/$document.json") <(jq -S . "faults/$document-line$number.json"); then
    echo "faults.txt:$number: changes nothing" >&2
    exit 1
  fi
done <"$list"
echo "$(ls faults/*/*.json | wc -l) faults"
