#!/bin/bash
# Tests that the help of each program and command ends with two examples and the name of an existing page or section of docs/, and that
# all examples run, one after another in one folder. Then tests the examples of docs/shapes.md.
source "$(dirname "$0")/harness.sh"

examples_of() { # COMMAND...   one per line
  "$@" --help | sed -n '/^Examples:$/,/^$/p' | sed -e '1d' -e '/^$/d' | sed -e :a -e '/\\$/N; s/\\\n  > //; ta' | sed 's/^  \$ //'
}

subcommands_of() { # COMMAND...
  "$@" --help | sed -n '/^Subcommands:$/,/^$/p' | grep -oE '^  [a-z-]+$'
}

run_examples() { # COMMAND...
  local example page
  examples_of "$@" >examples
  check "the help of $* has not two examples" test "$(wc -l <examples)" -eq 2
  check "the examples of $* are of another program" grep -q "$1" examples
  page=$("$@" --help | tail -n 2 | sed -n 's/^Read more: //p')
  check "$*: there is no page $page" test -n "$page" -a -f "$BEADSWIM_SOURCE/${page%#*}"
  [[ $page != *"#"* ]] || check "$*: ${page%#*} has no section ${page#*#}" grep -qx "## ${page#*#}" "$BEADSWIM_SOURCE/${page%#*}"
  while IFS= read -r example; do
    grep -qxF -- "$example" done && continue
    run timeout 60 bash -euo pipefail -c "$example" </dev/null
    has_status 0
    echo "$example" >>done
  done <examples
  for subcommand in $(subcommands_of "$@"); do run_examples "$@" "$subcommand"; done
}

: >done
: >err
for program in layout run theory compare optimise bench plot; do run_examples beadswim-$program; done
beadswim-view run.h5md -o page.html 2>err
grep -q 'npm\|Node.js' err || run_examples beadswim-view
check "commands have no help" test "$(wc -l <done)" -gt 40

# The help of all commands together, from which the manual pages are made, must contain the examples of each command.
for program in layout plot; do
  beadswim-$program --help-all >all
  while IFS= read -r example; do
    example=${example%% >*}
    check "--help-all lacks \"$example\"" grep -qF -- "  \$ ${example:0:60}" all
  done < <(grep "^beadswim-$program" done)
done

# --- each kind of shape has an example: one that has a verdict and one that has none
check "a kind of shape has no example" cmp -s <(subcommands_of beadswim-layout shape | tr -d ' ' | sort) \
  <(for example in "$BEADSWIM_SOURCE"/examples/shapes/*.sh; do basename "$example" .sh; done | grep -vx shape | sort)
run "$BEADSWIM_SOURCE/examples/shapes/triangle.sh" shapes/triangle
has_status 0
out_has '^triangle rotates by 12.19 degrees about -y in a cycle \(theory: 12.19\)$'
run "$BEADSWIM_SOURCE/examples/shapes/sphere.sh" shapes/sphere
has_status 0
out_has '^sphere moves by 4 along its axis in a cycle \(theory: 4\)$'
check "the sphere has no verdict" test -s shapes/sphere/verdict.json -a ! -e shapes/triangle/verdict.json
for kind in triangle sphere; do
  check "the picture of $kind is no picture" grep -q '^<circle' shapes/$kind/picture.svg
  check "docs/shapes.md has no picture of $kind" grep -q '^<circle' "$BEADSWIM_SOURCE/docs/images/shape-$kind.svg"
done
finish
