#!/bin/bash
# Tests that each program refuses nonsensical values of each flag, with a message that names the flag and does not come from a
# library.
source "$(dirname "$0")/harness.sh"

beadswim-layout swimmer --preset paper-single --unbounded >one.json
beadswim-layout swarm --preset paper-uniform --blocks 1,2,1 --block-swimmers 1,2,2 >swarm.json
beadswim-run one.json --model rpy --cycles 1 -o one.h5md --progress none >run.json
beadswim-theory one.json >theory.json
ls >before

flags_of() { # WITH-VALUE|WITHOUT COMMAND...   as --help lists them
  local form='^  (-[a-z],)?--[a-z-]+ [^ ]'
  [ "$1" = with-value ] || form='^  (-[a-z],)?--[a-z-]+$'
  shift
  "$@" --help | grep -oE "$form" | grep -oE -- '--[a-z-]+'
}

refused() { # COMMAND...   whose last word or last but one begins with $flag
  run timeout 20 "$@"
  has_status 2
  check "standard error does not begin with the program's name and the flag" grep -qE "^$1: ([^ ]*: )?$flag: " err
  check "it speaks in a library's words" bash -c '! grep -qE "sto[dil]|std::|[Cc]ould not convert|terminate|MPI_" err'
}

# Checks that the command refuses nonsensical values of all its flags. The input files are valid, so nothing else can be refused.
# Flags whose value is a file name are tested with an empty value only, because any other word may be a file name.
refuses_nonsense() { # COMMAND... -- INPUT...
  local command=() flag value
  while [ "$1" != -- ]; do command+=("$1"); shift; done
  shift
  check "flags of ${command[*]} are listed" test -n "$(flags_of with-value "${command[@]}")"
  for flag in $(flags_of with-value "${command[@]}"); do
    refused "${command[@]}" "$@" "$flag" ''
    [[ $flag =~ ^--(output|restart|with|flow|flow-points|stroke-from|reference|trace)$ ]] && continue
    for value in abc 1e999 ,; do refused "${command[@]}" "$@" "$flag=$value"; done
  done
  for flag in $(flags_of without "${command[@]}"); do
    [[ $flag =~ ^--(help|version)$ ]] || refused "${command[@]}" "$@" "$flag=abc"
  done
}

refuses_nonsense beadswim-layout swimmer -- --preset paper-single
refuses_nonsense beadswim-layout swarm -- --preset paper-uniform
refuses_nonsense beadswim-layout reduce -- swarm.json
for defect in vacancy interstitial jitter rotation domains phase amplitude frequency spacing mixture; do
  refuses_nonsense beadswim-layout defect $defect -- swarm.json
done
refuses_nonsense beadswim-run -- one.json -o new.h5md
refuses_nonsense beadswim-theory -- one.json
refuses_nonsense beadswim-optimise -- one.json --free phase=0:1 --maximise velocity
refuses_nonsense beadswim-compare -- run.json theory.json
for kind in stroke velocity-against-period separation; do refuses_nonsense beadswim-plot $kind -- run.json theory.json; done
refuses_nonsense beadswim-plot speed-against-error -- run.json --reference theory.json
for kind in trajectories flow; do refuses_nonsense beadswim-plot $kind -- one.h5md; done
for kind in swarm swimmer; do refuses_nonsense beadswim-plot $kind -- one.json; done
refuses_nonsense beadswim-plot mobility-products -- "$BEADSWIM_SOURCE/docs/results/mobility-products.json"
refuses_nonsense beadswim-view -- one.h5md -o page.html
refuses_nonsense beadswim-bench --
check "nothing was written" test "$(ls | grep -vx 'out\|err')" = "$(grep -vx 'out\|err' before)"
finish
