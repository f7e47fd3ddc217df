# shellcheck shell=bash
# Functions to test programs from outside: standard output, standard error, exit status, pipes. Scripts source this file.
#
#   run COMMAND...           runs the command; sets $status and writes the files out and err, which the checks below use
#   has_status N             checks the exit status
#   out_is TEXT              checks that standard output, without its last newline, is TEXT
#   out_has REGEX, err_has REGEX   checks that a line of standard output or standard error matches (grep -E)
#   out_empty, err_empty     checks that standard output or standard error is empty
#   notes_have REGEX         checks that the notes of the figure in the file out, as one line, match REGEX, that they have at
#                            most 60 words, and that they are below the drawing and inside the page (figure_notes.py)
#   well_formed FILE         checks that FILE is well-formed XML
#   accepts COMMAND...       runs the command; checks for exit status 0 and nothing on standard error
#   refuses REGEX COMMAND... runs the command; checks for exit status 2, nothing on standard output, and standard error that
#                            matches REGEX and begins with the name of the program
#   valid SCHEMA FILE        checks that python3-jsonschema, a validator of another project, accepts FILE by SCHEMA.schema.json
#   same_bytes A B           checks that two shell commands, given as text, write the same bytes, and not nothing
#   stored_documents         copies the documents of tests/data/compare, and makes NAME_shorter_period.json of both, with another period
#   views FILE PAGE          runs beadswim-view FILE -o PAGE and checks for exit status 0; returns failure, with a notice, where npm
#                            could not install what pages are made with (with BEADSWIM_NONE_SKIPPED, this is a failed check)
#   skip REASON              ends the script as skipped, or as failed if BEADSWIM_NONE_SKIPPED is set
#   rest_is_long             ends the script like finish, unless it runs as cli.NAME.long, a test that is labelled slow
#   finish                   ends the script, with exit status 1 if a check failed; must be its last line
#
# Each script runs in an empty folder of its own, which is removed at the end.

set -uo pipefail

checks=0
failures=0
status=0
command_line=

this_script=$(realpath "$0")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work" || exit 1
export PYTHONPATH=$BEADSWIM_SOURCE/tests/cli PYTHONDONTWRITEBYTECODE=1 # flow_files.py and flow_figures.py, for every script

passed() { checks=$((checks + 1)); }

failed() {
  checks=$((checks + 1))
  failures=$((failures + 1))
  printf 'FAILED (line %s): %s\n' "$(caller_line)" "$1"
  printf '  command: %s\n  status: %s\n' "$command_line" "$status"
  sed 's/^/  stderr: /' err | head -5
}

# Prints the line number of the script, outside this file, that is running.
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
# A warning of the expected error of a run, which depends on the scene, may stand there.
err_empty() { check "standard error is not empty" test -z "$(grep -vE ': warning: the (velocity is expected|error of this run|run is too short)' err)"; }

well_formed() { # FILE
  check "$1 is not well-formed XML" python3 -c 'import sys, xml.dom.minidom as xml; xml.parse(sys.argv[1])' "$1"
}

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

valid() {
  check "$2 is not valid by the schema of $1" \
    /usr/bin/python3 -W ignore -m jsonschema -i "$2" "$BEADSWIM_SOURCE/schemas/$1.schema.json"
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

# holds [JQ-FLAG...] CONDITION FILE   returns success if the jq condition is true for the JSON document in FILE.
holds() { jq -e "$@" >/dev/null; }

stored_documents() {
  cp "$BEADSWIM_SOURCE"/tests/data/compare/*.json .
  jq '.driving.period = 2000 | .swimmers[].cycles[].velocity[0] *= 0.85' run.json >run_shorter_period.json
  jq '.predictions[] |= (.settings.period = 2000 | .velocity *= 0.9)' prediction.json >prediction_shorter_period.json
}

views() {
  run beadswim-view "$1" -o "$2"
  if [ -z "${BEADSWIM_NONE_SKIPPED:-}" ] && [ "$status" -eq 2 ] && grep -q 'npm\|Node.js' err; then
    echo "without pages of beadswim-view: $(cat err)"
    return 1
  fi
  has_status 0
}

skip() {
  echo "skipped: $1"
  [ -z "${BEADSWIM_NONE_SKIPPED:-}" ] || exit 1
  exit 77
}

rest_is_long() { [ -n "${BEADSWIM_LONG:-}" ] || finish; }

finish() {
  check "checks below finish are never made" test "$(tail -n 1 "$this_script")" = finish
  echo "$((checks - failures)) of $checks checks passed"
  [ "$failures" -eq 0 ]
  exit
}
