#!/bin/bash
# Tests what `cmake --install` and the Debian package install: programs that work from the installed folder, manual pages, command
# completion, documents.
source "$(dirname "$0")/harness.sh"

# Runs a scene with the programs that are installed under PREFIX, without any file of the build folder.
scene_from() { # PREFIX
  local path=$1/bin:/usr/bin:/bin
  run env PATH="$path" bash -euo pipefail -c '
    beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic --period 100 \
      --amplitude 0.02 >layout.json
    beadswim-run layout.json -o run.h5md --cells-per-radius 2 --relaxation-time 1.5 --cycles 2 --progress none >run.json
    beadswim-theory layout.json >theory.json
    beadswim-compare run.json theory.json --quantity arm_amplitudes --tolerance 0.9 >verdict.json
    beadswim-plot stroke run.json theory.json -o stroke.svg'
  has_status 0
  check "the verdict is there" holds '.pass' verdict.json
  check "the figure is there" test -s stroke.svg
  rm -f layout.json run.h5md run.json theory.json verdict.json stroke.svg
}

programs=(layout run theory optimise compare plot view bench)
run cmake --install "$BEADSWIM_BUILD" --prefix "$PWD/prefix"
has_status 0
for program in "${programs[@]}"; do
  check "beadswim-$program is installed" test -x "prefix/bin/beadswim-$program"
  if command -v help2man >/dev/null; then
    check "beadswim-$program has a page" grep -q 'SYNOPSIS' "prefix/share/man/man1/beadswim-$program.1"
    check "the page of beadswim-$program has no examples" test "$(grep -c '(CW\$ ' "prefix/share/man/man1/beadswim-$program.1")" -ge 2
  fi
done
if command -v help2man >/dev/null; then
  check "subcommands have no section" grep -q '^.SH "BEADSWIM-LAYOUT DEFECT VACANCY"' prefix/share/man/man1/beadswim-layout.1
fi
check "schemas are" test -s prefix/share/beadswim/schemas/layout.schema.json
check "documents are" test -s prefix/share/doc/beadswim/docs/tutorial.md -a -x prefix/share/doc/beadswim/examples/figure-2.sh
run python3 -B "$BEADSWIM_SOURCE/tests/docs/links.py" prefix/share/doc/beadswim
has_status 0
out_has ' pages, 0 faults$'
scene_from "$PWD/prefix"

# --- the libraries, by a program of somebody else's
run cmake -S "$BEADSWIM_SOURCE/examples/library" -B "$PWD/library" -DCMAKE_PREFIX_PATH="$PWD/prefix" -DCMAKE_BUILD_TYPE=Release
has_status 0
run cmake --build "$PWD/library"
has_status 0
run library/best-phase
has_status 0
out_has '^phase [0-9]+ degrees, velocity [0-9.e-]+ cells per step$'
out_has '^at this amplitude [0-9.e-]+$'
# Messages name settings in words where no program has put flags in their place.
run library/best-phase 1000
has_status 2
err_has 'a gap between beads becomes smaller .*; reduce amplitude, or increase stiffness, damping or arm'

# --- completion
completions() { # WORDS...   what stands for the last of them
  PATH=$PWD/prefix/bin:$PATH bash -c 'source "$1/share/bash-completion/completions/beadswim-run"; shift
    COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _beadswim; printf "%s\n" "${COMPREPLY[@]}"' _ "$PWD/prefix" "$@"
}
completed() { # EXPECTED WORDS...   as one line
  local expected=$1
  shift
  check "completion of $* is $expected, not $(completions "$@" | xargs)" test "$(completions "$@" | xargs)" = "$expected"
}
completed "--cells-per-radius" beadswim-run --cells
completed "rpy rpy+near" beadswim-run --model rp
completed "mr" beadswim-run layout.json --bead-boundary m
completed "swimmer swarm" beadswim-layout sw
completed "vacancy" beadswim-layout defect va
completed "--fraction" beadswim-layout defect vacancy --fr
touch some-layout.json
completed "some-layout.json" beadswim-run --cycles 2 some
completed "some-layout.json" beadswim-run --restart some

# --- the Debian package
command -v dpkg-shlibdeps >/dev/null || { echo "no dpkg-dev: the Debian package is not tried"; finish; }
run cpack --config "$BEADSWIM_BUILD/CPackConfig.cmake" -G DEB -B "$PWD/package"
has_status 0
package=$(echo package/*.deb)
dpkg-deb -f "$package" Depends >depends
for library in openmpi-bin libhdf5-openmpi libopenmpi libfftw3-double3 libfmt9; do
  check "it depends on $library" grep -q "$library" depends
done
dpkg-deb -x "$package" unpacked
scene_from "$PWD/unpacked/usr"

finish
