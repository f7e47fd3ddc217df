#!/bin/bash
# Tests pages of beadswim-view in headless Chromium.
#   tests/view/run.sh MODULES
# The programs must be on PATH. MODULES is the folder with node_modules that the build has made from tools/view/page. If the
# browser or Node.js is missing, the exit status is 77 and the last line states the reason. If BEADSWIM_NONE_SKIPPED is set, this is a
# failure.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
modules=$1

absent() {
  echo "skipped: $1"
  [ "${BEADSWIM_NONE_SKIPPED:-}" ] && exit 1
  exit 77
}
command -v node >/dev/null || absent "no Node.js; install nodejs and npm"
[ -d "$modules/node_modules/playwright-core" ] || absent "the page was not built: $modules has no node_modules"
chromium=$(command -v chromium) || absent "no Chromium; .ci/install-packages.sh --with-readers installs it"

(cd "$modules" && node_modules/.bin/tsc --noEmit)
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
page() { # NAME FLAGS...   layout on standard input
  local name=$1
  shift
  beadswim-run - --model rpy -o "$name.h5md" --progress none "$@" >"$name.json" 2>"$name.log"
  beadswim-view "$name.h5md" -o "$name.html" --block-swimmers 1,1,1
}
beadswim-layout swimmer --preset paper-single --unbounded --radius 3,4,5 --arm 18,27 --period 300 --amplitude 0.2 |
  jq '.swimmers[0].id = 7' | page alone --cycles 2
beadswim-layout swarm --preset paper-uniform --blocks 1,2,2 --block-swimmers 1,1,1 |
  beadswim-layout defect amplitude --sigma 0.2 --seed 1 | page swarm --cycles 1
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 60,40,40 --boundary periodic --period 300 --amplitude 0.1 |
  jq '.swimmers[0].position[0] = 0' | page outside --cycles 1
jq -n '{schema: "beadswim/layout/2", units: "lattice", fluid: {density: 1, kinematic_viscosity: 1}, domain: null,
  types: {triangle: {beads: [[-12, 0, -8], [12, 0, -8], [0, 0, 14]] | map({radius: 3, density: 1, at: .}),
      bonds: [[1, 2], [2, 3], [3, 1]] | map({beads: ., stiffness: 1}),
      driving: {period: 300, bonds: [range(3) | {bond: (. + 1), rest_length: [{amplitude: (1 + .), phase: (3.141592653589793 * .)}]}]}},
    sphere: {beads: [{radius: 8, density: 1, at: [0, 0, 0]}], driving: {period: 300}}},
  swimmers: [{id: 0, type: "triangle", position: [0, 0, 0]}, {id: 1, type: "sphere", position: [40, 0, 0]}]}' | page shapes --cycles 2
beadswim-layout shape sphere --unbounded | page flow --cycles 1 --flow-every 1 --flow-region=0:0,0:0,30:30 --flow-spacing 16
beadswim-view flow.h5md -o flow.html --flow flow.h5md.flow/*.vti # one arrow, above the sphere
beadswim-view alone.h5md -o ends.html --every 1000
node "$here/page_test.mjs" "$folder" "$modules" "$chromium"
