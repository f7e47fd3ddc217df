#!/bin/bash
# Tests that each --flag that README.md and the pages in docs/ mention is a flag of a program of Beadswim, or one of a few known
# flags of other software.
source "$(dirname "$0")/harness.sh"

for program in layout run theory compare optimise plot view bench; do "beadswim-$program" --help; done >help
for program in layout plot; do beadswim-$program --help-all; done >>help
flags() { grep -ohE -- '(^|[^-[:alnum:]])--[a-z][a-z-]+' "$@" | grep -oE -- '--[a-z-]+' | sort -u; }
check "the programs have flags" test "$(flags help | wc -l)" -gt 50

: >err
lengthy() { # lines beyond 100 columns, and flags with over two lines of text
  awk 'length > 100 && !/^  [$>] /
       /^  [^ ]/ { flag = $1; lines = 0 }
       /^        / { if (++lines == 3) print flag }' help
}
check "help is too long: $(lengthy | head -3)" test -z "$(lengthy)"
flags help >known
# Flags of scripts, cmake, srun, sbatch, mpirun, jq and beadswim-verification.
printf '%s\n' --build --install --prefix --array --mpi --signal --oversubscribe --slurpfile --quiet --report --with-readers >>known

while read -r flag; do
  check "$flag, which a page names, is no flag of any program" grep -qx -- "$flag" known
done < <(cd "$BEADSWIM_SOURCE" && flags README.md docs/*.md docs/*/*.md libs/*/README.md)
finish
