#!/bin/bash
# Tests that the help of each program and command ends with two examples and the name of an existing page or section of docs/, and that
# all examples run, one after another in one folder. Then tests examples/shapes.sh.
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
for program in layout run theory compare bench plot; do run_examples beadswim-$program; done
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

# --- examples/shapes.sh: one kind that has a verdict and one that has none
run "$BEADSWIM_SOURCE/examples/shapes.sh" shapes triangle sphere
has_status 0
check "it does not print the motion of both kinds" cmp -s out - <<'EOT'
triangle rotates by 12.19 degrees about -y in a cycle (theory: 12.19)
sphere moves by 4 along its axis in a cycle (theory: 4)
EOT
check "the sphere has no verdict" test -s shapes/sphere/verdict.json -a ! -e shapes/triangle/verdict.json
for kind in triangle sphere; do
  check "the picture of $kind is no picture" grep -q '^<circle' shapes/$kind/picture.svg
  check "docs/shapes.md has no picture of $kind" grep -q '^<circle' "$BEADSWIM_SOURCE/docs/images/shape-$kind.svg"
done
finish
