#!/bin/bash
# From a clean clone to a simulated swimmer beside its prediction: installs what is missing, builds, runs one
# swimmer resolved in the fluid, and ends with a table and a figure in out/quickstart/. The run takes some 2 minutes
# on two cores; a smaller box, shorter period or fewer cycles less.
set -euo pipefail
cd "$(dirname "$0")/.."

# The scene: the paper's single swimmer in a smaller, periodic box. Lattice units.
preset=paper-single
box=120,80,80
boundary=periodic
period=4800
amplitude=0.2
cycles=4   # from the third on they differ by 0.2 % in velocity
tolerance=0.1   # relative, of the final verdict
ranks=2

out=out/quickstart
step() { printf '\n== %s\n' "$*" >&2; }

step "Packages"
.ci/install-packages.sh

build=${BEADSWIM_PRESET:-release}
step "Build (build/$build)"
cmake --preset "$build"
cmake --build --preset "$build" --target programs
PATH=$PWD/build/$build/bin:$PATH

if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
if [ "$(nproc)" -lt "$ranks" ]; then export OMPI_MCA_rmaps_base_oversubscribe=1; fi

mkdir -p "$out"

step "Scene: one swimmer in a box of $box cells, period $period steps"
beadswim-layout swimmer --preset "$preset" --box "$box" --boundary "$boundary" --period "$period" \
  --amplitude "$amplitude" >"$out/layout.json"

step "Run: $cycles cycles on $ranks ranks"
mpirun -n "$ranks" beadswim-run "$out/layout.json" -o "$out/run.h5md" --cycles "$cycles" >"$out/run.json"

step "Theory"
beadswim-theory "$out/layout.json" >"$out/prediction.json"

step "Simulated against predicted, in the last cycle"
verdict=0
beadswim-compare "$out/run.json" "$out/prediction.json" --tolerance "$tolerance" >"$out/verdict.json" || verdict=$?
if [ "$verdict" -gt 1 ]; then exit "$verdict"; fi
cat >&2 <<EOF

The prediction that decides, inertia-corrected, is exact Stokes flow of three spheres at finite amplitude, with the inertia
of fluid and beads and with this box. The others leave out some of that: "validity" in prediction.json says what.
EOF

step "Figure"
for figure in stroke.svg stroke.png; do
  beadswim-plot stroke "$out/run.json" "$out/prediction.json" -o "$out/$figure"
  echo "$out/$figure" >&2
done
