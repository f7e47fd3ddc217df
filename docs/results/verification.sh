#!/bin/bash
# Makes the records of docs/verification.md, and the page.
#   docs/results/verification.sh [SCHEME,...]      (an hour and a half on 2 idle cores; beadswim-verification on PATH)
# Two processes measure different cases. Records of schemes that are not named stay unchanged.
set -euo pipefail
cd "$(dirname "$0")"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
schemes=${1:-staircase,cli,mr,psm}
new=$(mktemp -d)
trap 'rm -rf "$new"' EXIT

measure() { beadswim-verification --scheme "$schemes" --case "$1" >"$new/$2"; }
measure array-drag,hydrodynamic-radius 1 &
measure torque,collinear-spheres,sedimentation,oscillation,galilean-invariance,conservation,near-contact 2
wait $!

touch verification.jsonl
for scheme in ${schemes//,/ }; do
  grep -v "\"scheme\":\"$scheme\"" verification.jsonl >"$new/kept" || true
  mv "$new/kept" verification.jsonl
done
cat "$new/1" "$new/2" >>verification.jsonl
beadswim-verification --report verification.jsonl >../verification.md
