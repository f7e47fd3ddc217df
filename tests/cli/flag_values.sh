#!/bin/bash
# Each flag of each program that takes a value, given values that nobody means: refused in the program's own words.
source "$(dirname "$0")/harness.sh"

value_flags() { # as --help lists them
  "$@" --help | grep -oE '^  (-[a-z],)?--[a-z-]+ [^ ]' | grep -oE -- '--[a-z-]+'
}

refuses_nonsense() { # COMMAND... -- INPUT...
  local command=()
  while [ "$1" != -- ]; do command+=("$1"); shift; done
  shift
  local flags
  flags=$(value_flags "${command[@]}")
  check "flags of ${command[*]} are listed" test -n "$flags"
  for flag in $flags; do
    for value in abc '' 1e999 99999999999999999999 ,; do
      run timeout 20 "${command[@]}" "$@" "$flag=$value"
      has_status 2
      check "standard error does not begin with the program's name" grep -q "^${command[0]}: " err
      check "it speaks in a library's words" bash -c '! grep -qE "sto[dil]|std::|[Cc]ould not convert|terminate|MPI_" err'
    done
  done
}

for command in swimmer swarm; do refuses_nonsense beadswim-layout $command -- ; done
refuses_nonsense beadswim-layout reduce -- none.json
for defect in vacancy interstitial jitter rotation domains phase amplitude frequency spacing mixture; do
  refuses_nonsense beadswim-layout defect $defect -- none.json
done
refuses_nonsense beadswim-run -- none.json
refuses_nonsense beadswim-theory -- none.json
refuses_nonsense beadswim-compare -- none.json none.json
refuses_nonsense beadswim-plot -- stroke none.json
refuses_nonsense beadswim-view -- none.h5md
refuses_nonsense beadswim-bench --
check "something was written" test "$(find . -type f | sort | xargs)" = './err ./out'
finish
