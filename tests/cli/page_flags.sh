#!/bin/bash
# Tests that each --flag that README.md, the pages in docs/ and the texts of the sources mention is a flag of a program of Beadswim,
# or one of a few known flags of other software.
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
printf '%s\n' --build --install --prefix --array --mpi --signal --oversubscribe --slurpfile --quiet --report --with-readers --list >>known
# Of rsvg-convert, and wrong names of --beads, for which beadswim-layout has a message.
printf '%s\n' --format --bead-count --num-beads --number-of-beads >>known
python3 -B "$BEADSWIM_SOURCE/tests/docs/messages.py" "$BEADSWIM_SOURCE" --list >texts
check "the sources have texts" test "$(wc -l <texts)" -gt 500

while read -r flag; do
  check "$flag, which a page or a message names, is no flag of any program" grep -qx -- "$flag" known
done < <(cd "$BEADSWIM_SOURCE" && flags README.md docs/*.md docs/*/*.md libs/*/README.md "$OLDPWD/texts")
finish
