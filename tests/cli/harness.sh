# shellcheck shell=bash
# Checks of programs from outside: standard output, standard error, exit status, pipes. Source this file.
#
#   run COMMAND...           runs it; then $status, and the files out and err, are there for the checks
#   has_status N             the exit status
#   out_is TEXT              standard output, without its last newline, is TEXT
#   out_has REGEX, err_has REGEX   some line of it matches (grep -E)
#   out_empty, err_empty
#   notes_have REGEX         the notes of the figure in out, as one line, match; they have at most 60 words, are below the
#                            drawing and inside the page (figure_notes.py)
#   accepts COMMAND...       runs it; exit status 0, nothing on standard error
#   refuses REGEX COMMAND... runs it; exit status 2, nothing on standard output, REGEX on standard error, which
#                            starts with the program's name
#   same_bytes A B           two shell commands (given as text) write the same, and something
#   skip REASON              ends the script as skipped
#   finish                   ends the script: exit status 1 if a check failed
#
# The script works in an empty folder of its own, which goes when it ends.

set -uo pipefail

checks=0
failures=0
status=0
command_line=

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1

passed() { checks=$((checks + 1)); }

failed() {
  checks=$((checks + 1))
  failures=$((failures + 1))
  printf 'FAILED (line %s): %s\n' "$(caller_line)" "$1"
  printf '  command: %s\n  status: %s\n' "$command_line" "$status"
  sed 's/^/  stderr: /' err | head -5
}

# The line of the script, outside this file, that is running.
caller_line() {
  local frame=0 line file
  while read -r line _ file < <(caller $frame); do
    [[ $file == */harness.sh ]] || { echo "$line"; return; }
    frame=$((frame + 1))
  done
}

check() { # MESSAGE TEST...
  local message=$1
  shift
  if "$@"; then passed; else failed "$message"; fi
}

run() {
  command_line="$*"
  status=0
  "$@" >out 2>err || status=$?
}

has_status() { check "exit status is not $1" test "$status" -eq "$1"; }
out_is() { check "standard output is not \"$1\"" test "$(cat out)" = "$1"; }
out_has() { check "standard output has no line like $1" grep -qE -- "$1" out; }
err_has() { check "standard error has no line like $1" grep -qE -- "$1" err; }
notes_have() {
  check "the notes of the figure have a fault" python3 "$BEADSWIM_SOURCE/tests/cli/figure_notes.py" out >notes
  check "the notes do not match $1: $(cat notes)" grep -qE -- "$1" notes
}
out_empty() { check "standard output is not empty" test ! -s out; }
err_empty() { check "standard error is not empty" test ! -s err; }

accepts() {
  run "$@"
  has_status 0
  err_empty
}

refuses() {
  local regex=$1
  shift
  run "$@"
  has_status 2
  out_empty
  err_has "$regex"
  check "standard error does not start with the program's name" grep -qE "^$1: " err
}

same_bytes() {
  command_line="$1 | cmp - <($2)"
  bash -o pipefail -c "$1" >out 2>err
  status=$?
  bash -o pipefail -c "$2" >out.other 2>>err || status=$?
  check "one of the commands failed" test "$status" -eq 0
  check "no output to compare" test -s out
  check "the outputs differ" cmp -s out out.other
}

# A condition on a JSON document, to check.
holds() { jq -e "$1" "$2" >/dev/null; }

skip() {
  echo "skipped: $1"
  exit 77
}

finish() {
  echo "$((checks - failures)) of $checks checks passed"
  [ "$failures" -eq 0 ]
  exit
}
