#!/bin/bash
# Builds the fuzz targets and runs them, each from its corpus of inputs (docs/fuzzing.md).
#   tests/fuzz/run.sh [EXECUTIONS|SECONDSs [TARGET...]]     default: 10000, all targets
# Inputs that reach new code are stored in out/fuzz/TARGET. Inputs that make a target fail are stored in out/fuzz/findings, with
# the log.
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

# Options of the address sanitizer that double the speed: short call stacks of allocations and a small quarantine. The option
# -entropic=0 below also doubles the speed, because counting how often each feature occurs takes longer than short inputs take to
# run.
asan=malloc_context_size=2:quarantine_size_mb=16
export UBSAN_OPTIONS=print_stacktrace=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1

cmake --preset fuzz
cmake --build --preset fuzz

mkdir -p out/fuzz/findings out/fuzz/unrepeated
# Dictionary for the fuzzer: keys of the schemas, and the words that values may have.
jq -r '.. | objects | (.properties // {} | keys[]), (.enum // [] | .[] | strings), (.const // empty | strings)' \
  schemas/*.json | sort -u | jq -R '@json | @json' -r >out/fuzz/words

documents="-max_len=8192 -dict=out/fuzz/words"
edits="-max_len=400 -detect_leaks=0"  # leaks of the HDF5 and MPI libraries are theirs
# Damaged metadata crash the HDF5 library itself. These targets therefore continue after a crash, and crashes in HDF5 are removed
# from the findings.
bytes="-max_len=30000 -detect_leaks=0 -malloc_limit_mb=1000000 -fork=1 -ignore_crashes=1"
declare -A options=(
  [layout]=$documents [prediction]=$documents [run_record]=$documents [swimming_file]=$documents
  [stream]=$documents [study]=$documents
  [lattice_speed]="-max_len=4096 -detect_leaks=0" [flow_file]="-max_len=4096 -detect_leaks=0" [trajectory]=$edits
  [restart]="$edits -fork=1"  # Open MPI keeps some memory of each file that was open
  [trajectory_bytes]=$bytes [checkpoint_bytes]=$bytes)

limits="-timeout=20 -rss_limit_mb=4096"

# Prints where a target fails for an input: "libhdf5" if the first known frame of the call stack is in HDF5; "here" if it is in
# Beadswim, or for a timeout or lack of memory; "nowhere" if the target does not fail again, because what HDF5 reads beyond its
# memory depends on earlier inputs.
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

# Returns success if the target completed its executions and its exit status reports only crashes that it was told to ignore.
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
