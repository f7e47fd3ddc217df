#!/bin/bash
# Performs the runs of figure 3 of the paper (Pickl et al. 2017): its single swimmer, in a small periodic box, with the
# lattice-Boltzmann model.
#   examples/figure-3-runs.sh FOLDER [NAME...] [FLAGS of beadswim-run...]   writes the named files (default: all) to FOLDER:
#     by-period.jsonl            driving period T from 1000 to 10000, amplitudes A = B = 0.2, driving phase α = π/2
#     by-amplitude-ratio.jsonl   amplitude ratio A/B from 0.25 to 2, T = 4800
#     by-phase.jsonl             α from -3π/4 to π, T = 4800
# Each line of a file is one run record. All runs take half an hour on 2 idle cores at the paper's resolution, and half a minute
# with --cells-per-radius 2 --precision single. Existing files are kept. examples/figure-3.sh draws the runs and the theory.
# Environment variables: BOX and BOUNDARY of the runs, PERIODS of by-period. In the paper's own box, with levels of cells
# (ten minutes):
#     BOX=1200,800,800 BOUNDARY=free-slip examples/figure-3-runs.sh FOLDER --refine auto
set -euo pipefail

box=${BOX:-120,80,80}     # all numbers are in lattice units
boundary=${BOUNDARY:-periodic}
periods=${PERIODS:-1000 2000 3000 4800 7000 10000}
amplitude=0.2     # A = B; in by-amplitude-ratio only B
period=4800       # driving period, except in by-period
ranks=2

out=${1:?a folder for the records}
shift
mkdir -p "$out"
command -v beadswim-run >/dev/null || PATH=$(cd "$(dirname "$0")/.." && pwd)/build/release/bin:$PATH
if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
if [ "$(nproc)" -lt "$ranks" ]; then export OMPI_MCA_rmaps_base_oversubscribe=1; fi

names=()
while [[ ${1:-} == by-* ]]; do
  names+=("$1")
  shift
done
flags=("$@")
middle=$(jq -nr "[$box] | map(. / 2) | join(\",\")")
# Runs a swimmer and prints the run record as one line. The run must be longer than the transients, which take about 4000 steps.
# In this box, the transients of the springs take longer than those of the fluid.
simulate() { # PERIOD LAYOUT-FLAGS...
  local period=$1 cycles=$((3 + 4000 / $1))
  shift
  echo "T = $period $* (${flags[*]})" >&2
  beadswim-layout swimmer --preset paper-single --box "$box" --boundary "$boundary" --position "$middle" --period "$period" "$@" |
    mpirun -n "$ranks" beadswim-run - -o "$out/run.h5md" --cycles "$cycles" --progress none "${flags[@]}" | jq -c .
  rm "$out"/run.h5md{,.xdmf2}
}

# Writes the run records of one sweep to a file, which appears only after all runs of the sweep have succeeded.
keep() { # NAME
  [ ! -e "$out/$1.jsonl" ] || return 0
  "$1" >"$out/$1.part"
  mv "$out/$1.part" "$out/$1.jsonl"
}
by-period() { for T in $periods; do simulate $T --amplitude $amplitude; done; }
by-amplitude-ratio() {
  for ratio in 0.25 0.5 1 1.5 2; do
    simulate $period --amplitude "$(jq -nr "$ratio * $amplitude"),$amplitude"
  done
}
by-phase() {
  for quarter in -3 -2 -1 0 1 2 3 4; do
    simulate $period --amplitude $amplitude --phase="$(jq -nr "$quarter * 0.7853981633974483")"
  done
}
[ ${#names[@]} -gt 0 ] || names=(by-period by-amplitude-ratio by-phase)
for name in "${names[@]}"; do keep "$name"; done
