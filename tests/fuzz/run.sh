#!/bin/bash
# Builds the fuzz targets and runs them, each from its corpus (docs/fuzzing.md).
#   tests/fuzz/run.sh [EXECUTIONS|SECONDSs [TARGET...]]     default: 10000, all targets
# Inputs that reach new code stay in out/fuzz/TARGET. What ends a target goes to out/fuzz/findings, with the log.
set -euo pipefail
cd "$(dirname "$0")/../.."

amount=${1:-10000}
shift $(($# > 0 ? 1 : 0))
targets=("$@")
if [ ${#targets[@]} -eq 0 ]; then
  for corpus in tests/fuzz/corpus/*/; do targets+=("$(basename "$corpus")"); done
fi
case $amount in
  *s) limit=-max_total_time=${amount%s} ;;
  *) limit=-runs=$amount ;;
esac

# Short stacks of allocations and a small quarantine make it twice as fast, and so does -entropic=0 below: how often
# each feature was seen takes longer to count than short inputs take to run.
asan=malloc_context_size=2:quarantine_size_mb=16
export UBSAN_OPTIONS=print_stacktrace=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

cmake --preset fuzz
cmake --build --preset fuzz

mkdir -p out/fuzz/findings out/fuzz/unrepeated
# Keys, and words that values may be, as the schemas have them.
jq -r '.. | objects | (.properties // {} | keys[]), (.enum // [] | .[] | strings), (.const // empty | strings)' \
  schemas/*.json | sort -u | jq -R '@json | @json' -r >out/fuzz/words

documents="-max_len=8192 -dict=out/fuzz/words"
edits="-max_len=400 -detect_leaks=0"  # leaks of the HDF5 and MPI libraries are theirs
# Damaged metadata crash HDF5 itself: these targets go on, and what crashed the library is left out of the findings.
bytes="-max_len=30000 -detect_leaks=0 -malloc_limit_mb=1000000 -fork=1 -ignore_crashes=1"
declare -A options=(
  [layout]=$documents [prediction]=$documents [run_record]=$documents [swimming_file]=$documents
  [lattice_speed]="-max_len=4096 -detect_leaks=0" [trajectory]=$edits
  [restart]="$edits -fork=1"  # Open MPI keeps some memory of each file that was open
  [trajectory_bytes]=$bytes [checkpoint_bytes]=$bytes)

limits="-timeout=20 -rss_limit_mb=4096"

# Where what the target does with a finding ends: in libhdf5, if its frame comes before any of ours; here; or nowhere, as
# what HDF5 reads beyond its memory hangs on what inputs before have left there. Hangs and memory are ours.
ends_in() { # TARGET FILE
  local said frame
  case $(basename "$2") in *-timeout-* | *-oom-*) echo here && return ;; esac
  # shellcheck disable=SC2086
  said=$(ASAN_OPTIONS=$asan:allocator_may_return_null=1:detect_leaks=0 build/fuzz/bin/fuzz_"$1" -malloc_limit_mb=1000000 $limits \
    "$2" 2>&1 || true)
  grep -aq '^Executed ' <<<"$said" && { echo nowhere; return; }
  frame=$(grep -am1 -oE 'libhdf5|/(libs|tools|tests)/[a-z0-9/_]*\.[ch]pp|broken promise' <<<"$said" || true)
  if [ "$frame" = libhdf5 ]; then echo libhdf5; else echo here; fi
}

# Whether crashes, which the target was told to ignore, are all that its exit status tells of.
went_on() { # TARGET LOG
  [[ ${options[$1]} == *-ignore_crashes=1* ]] && grep -q '^INFO: fuzzed for' "$2"
}

failed() { # TARGET LOG
  rm -rf /dev/shm/beadswim-fuzz.*
  tail -40 "$2" >&2
  echo "fuzz_$1 failed; see out/fuzz/findings and $2" >&2
  exit 1
}

for target in "${targets[@]}"; do
  mkdir -p "out/fuzz/$target"
  rm -f out/fuzz/findings/"$target"-*
  log=out/fuzz/$target.log
  of_target=$asan
  case ${options[$target]} in *detect_leaks=0*) of_target+=:detect_leaks=0:allocator_may_return_null=1 ;; esac
  echo "== $target, $limit"
  # shellcheck disable=SC2086
  ASAN_OPTIONS=$of_target build/fuzz/bin/fuzz_"$target" "$limit" ${options[$target]} -entropic=0 -len_control=0 $limits \
    -print_final_stats=1 -artifact_prefix="out/fuzz/findings/$target-" "out/fuzz/$target" \
    "tests/fuzz/corpus/$target" >"$log" 2>&1 || went_on "$target" "$log" || failed "$target" "$log"
  for finding in out/fuzz/findings/"$target"-*; do
    [ -e "$finding" ] || continue
    case $(ends_in "$target" "$finding") in
      libhdf5) rm "$finding" ;;
      nowhere) mv "$finding" out/fuzz/unrepeated/ && echo "$finding does not repeat by itself: it is in out/fuzz/unrepeated" ;;
      here) failed "$target" "$log" ;;
    esac
  done
  grep -aE '^#[0-9]+.*(DONE|cov)|number_of_executed_units|average_exec_per_sec|^INFO: fuzzed for' "$log" | tail -3
done
rm -rf /dev/shm/beadswim-fuzz.*
