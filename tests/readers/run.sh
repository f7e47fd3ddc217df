#!/bin/bash
# Opens the files that the programs write with software of other projects: h5py, MDAnalysis, ParaView, Ajv, python3-jsonschema.
#   tests/readers/run.sh    with the programs and by_valijson on PATH; 2 minutes
# Software that is not installed is skipped, with a message; if BEADSWIM_NONE_SKIPPED is set, this is a failure.
# .ci/install-packages.sh --with-readers installs all of this software.
set -uo pipefail
here=$(cd "$(dirname "$0")" && pwd)
schemas=$here/../../schemas

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/scenes"
cd "$work/scenes" || exit 1
export PYTHONDONTWRITEBYTECODE=1
python=(timeout 300 /usr/bin/python3 -W ignore) # Debian's own, which its reader packages are for

passed=0 skipped=0 failed=0
report() { # WHAT COMMAND...     exit status 77: skipped, with the reason on the last line
  local what=$1 status=0
  shift
  "$@" >../said 2>&1 || status=$?
  case $status in
    0) passed=$((passed + 1)); echo "passed   $what: $(tail -n 1 ../said)" ;;
    77) skipped=$((skipped + 1)); echo "skipped  $what: $(tail -n 1 ../said)" ;;
    *) failed=$((failed + 1)); echo "FAILED   $what, exit status $status:"; sed 's/^/    /' ../said | tail -n 20 ;;
  esac
}
skip() { echo "$1"; return 77; }
has_module() { "${python[@]}" -c "import $1" 2>/dev/null || skip "Debian's Python has no $1"; }
has_program() { type -P "$1" >/dev/null || skip "there is no $1"; }

by_h5py() { has_module h5py && "${python[@]}" "$here/h5md.py" "$1".{h5md,layout.json,run.json}; }
by_mdanalysis() { has_module MDAnalysis && "${python[@]}" "$here/mdanalysis.py" "$1".{h5md,layout.json,run.json}; }
by_numpy() { has_module h5py && "${python[@]}" "$here/flow.py" "$1.h5md" "$1.run.json"; }
by_paraview() { has_program pvbatch && has_module h5py && timeout 300 pvbatch "$here/$1" "$2"; }
by_jsonschema() { has_module jsonschema && "${python[@]}" "$here/by_jsonschema.py" "$schemas" documents faults; }
by_ajv() {
  has_program node && has_program npm || return
  cp -r "$here/ajv" ../ajv && (cd ../ajv && timeout 300 npm ci --no-audit --no-fund --silent) || skip "npm cannot install Ajv" || return
  node ../ajv/validate.js "$schemas" documents faults
}

for step in scenes documents faults; do
  report "what is read, $step.sh" timeout 600 "$here/$step.sh"
done
for scene in lattice walls swarm periods open units early restarted; do
  report "h5py, $scene" by_h5py $scene
  report "MDAnalysis, $scene" by_mdanalysis $scene
  report "ParaView, beads of $scene" by_paraview pvbatch_beads.py $scene.h5md
done
report "numpy, flow" by_numpy lattice
for scene in lattice levels; do report "ParaView, flow of $scene" by_paraview pvbatch_flow.py $scene.h5md; done
report "python3-jsonschema" by_jsonschema
report "Ajv" by_ajv
report "valijson" timeout 300 by_valijson documents faults
report "the programs themselves" timeout 300 "$here/programs.sh"

echo "$passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] || exit 1
[ -z "${BEADSWIM_NONE_SKIPPED:-}" ] || [ "$skipped" -eq 0 ] || { echo "run.sh: readers were skipped, which BEADSWIM_NONE_SKIPPED forbids" >&2; exit 1; }
