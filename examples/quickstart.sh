#!/bin/bash
# Simulates a swimmer in a lattice-Boltzmann fluid, starting from a clean clone of the repository: installs missing packages,
# builds the programs, runs the simulation and compares it with theory. Writes the results and a figure to out/quickstart/. The
# simulation takes about 2 minutes on two cores.
set -euo pipefail
cd "$(dirname "$0")/.."

# Scene: the single swimmer of the paper (Pickl et al. 2017) in a smaller, periodic box. All numbers are in lattice units.
preset=paper-single
box=120,80,80
boundary=periodic
period=4800
amplitude=0.2
cycles=4        # velocities of the cycles after the second differ by 0.2 %
tolerance=0.1   # largest relative error between run and prediction that passes
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

step "Comparison of run and prediction in the last cycle"
verdict=0
beadswim-compare "$out/run.json" "$out/prediction.json" --tolerance "$tolerance" >"$out/verdict.json" || verdict=$?
if [ "$verdict" -gt 1 ]; then exit "$verdict"; fi
cat >&2 <<EOF

The method inertia-corrected decides the verdict: exact flow of three spheres with the inertia of fluid and beads,
corrected for finite amplitude and for the box. "validity" in prediction.json states what the other methods neglect.
EOF

step "Figure"
for figure in stroke.svg stroke.png; do
  beadswim-plot stroke "$out/run.json" "$out/prediction.json" -o "$out/$figure"
  echo "$out/$figure" >&2
done

step "To put the programs on PATH, run"
echo "  export PATH=\"$PWD/build/$build/bin:\$PATH\"" >&2
if [ "$(id -u)" -eq 0 ]; then
  echo "  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1   # mpirun as root" >&2
fi
