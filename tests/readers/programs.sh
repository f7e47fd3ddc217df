#!/bin/bash
# Tests the programs that read documents, in the folder of documents.sh and faults.sh: they must accept valid documents, and
# refuse each invalid document with exit status 2 and a message that names the file and the place in it.
set -uo pipefail

wrong=0 taken=0 refused=0
takes() { # COMMAND...
  taken=$((taken + 1))
  local status=0
  "$@" >said.out 2>said || status=$?
  [ "$status" -le 1 ] && return # 1: a negative verdict
  wrong=$((wrong + 1))
  echo "$*: exit status $status: $(tail -n 1 said)" >&2
}
refuses() { # FILE COMMAND...
  refused=$((refused + 1))
  local file=$1 status=0
  shift
  "$@" >said.out 2>said || status=$?
  [ "$status" -eq 2 ] && [ ! -s said.out ] && grep -qF "$1: $file:" said && return
  wrong=$((wrong + 1))
  echo "$*: exit status $status: $(head -n 1 said)" >&2
}

for layout in documents/layout/*.json documents/layout-2/*.json; do takes beadswim-layout check "$layout"; done
for file in faults/layout/*.json faults/layout-2/*.json; do refuses "$file" beadswim-layout check "$file"; done

takes beadswim-compare documents/run/lattice.json documents/prediction/box.json
for run in lattice walls open swarm restarted; do takes beadswim-plot stroke "documents/run/$run.json" -o said.svg; done
for file in faults/run/*.json; do
  refuses "$file" beadswim-compare "$file" documents/prediction/box.json
  refuses "$file" beadswim-theory documents/layout/single.json --stroke-from "$file"
done
for file in faults/prediction/*.json; do refuses "$file" beadswim-compare documents/run/lattice.json "$file"; done

takes beadswim-plot mobility-products documents/bench/products.json -o said.svg
for file in faults/bench/*.json; do refuses "$file" beadswim-plot mobility-products "$file"; done

[ "$wrong" -eq 0 ] || exit 1
echo "$taken documents taken, $refused faults refused"
