#!/bin/bash
# Compares the speed of this working tree with the speed of another revision, as ratios, on this machine.
#   tests/performance/compare_revisions.sh REVISION [--rounds N] [--tolerance E] [--ranks N] [--scenes NAME,...]
# REVISION (a commit, tag or branch) is built in a temporary folder; "this" is the working tree, built in build/release. Both
# builds run the same scenes alternately in N rounds (default 7). The script prints the median over the rounds of the ratio of
# speeds, so that slow changes of the machine's speed affect both builds equally. The exit status is 1 if a scene has become
# slower by more than the fraction E (default 0.05). Speeds are million cell updates per second of lattice runs, and mobility
# products per second (product-*, 34,560 beads). Default: all scenes. This script is not one of the tests, because a benchmark
# needs an idle machine and takes minutes.
set -euo pipefail
self=$(realpath "$0")
cd "$(dirname "$self")/../.."

usage() { sed -n '2,10s/^# \{0,1\}//p' "$self"; }
fail() { echo "compare_revisions.sh: $2" >&2; exit "$1"; }
rounds=7 tolerance=0.05 ranks=1 revision=
scenes=small-periodic,dense-periodic,large-periodic,large-walled
scenes+=,product-periodic,product-open,product-unsteady,product-order-1,product-order-2
while [ $# -gt 0 ]; do
  case "$1" in
    --help) usage; exit 0 ;;
    --rounds | --tolerance | --ranks | --scenes)
      [ $# -ge 2 ] || fail 2 "$1 needs a value"
      declare "${1#--}=$2"; shift 2 ;;
    -*) fail 2 "unknown flag $1; --rounds, --tolerance, --ranks, --scenes and --help are known" ;;
    *) revision=$1; shift ;;
  esac
done
IFS=, read -ra scenes <<<"$scenes"
for scene in "${scenes[@]}"; do
  [[ $scene =~ ^((small|dense|large)-periodic|large-walled|product-(periodic|open|unsteady|order-[12]))$ ]] ||
    fail 2 "\"$scene\" is no scene of --scenes; see --help"
done
for count in "$rounds" "$ranks"; do
  [[ $count =~ ^[1-9][0-9]*$ ]] || fail 2 "\"$count\" is no count; --rounds and --ranks take whole numbers from 1"
done
[[ $tolerance =~ ^0?\.[0-9]+$ ]] || fail 2 "--tolerance $tolerance: a number between 0 and 1 is needed, such as 0.05"
[ -n "$revision" ] || { usage >&2; exit 2; }
commit=$(git rev-parse --verify --quiet "$revision^{commit}") ||
  fail 2 "\"$revision\" is no revision of this repository"

# Settings of Open MPI that allow runs as root, as in a container.
if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi
export OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_hwloc_base_binding_policy=none
export OMPI_MCA_rmaps_base_oversubscribe=1

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
git clone --quiet . "$scratch/other"
git -C "$scratch/other" checkout --quiet "$commit"

build() { # FOLDER
  (cd "$1" && cmake --preset release >/dev/null && cmake --build --preset release --target beadswim-layout beadswim-run beadswim-bench)
}
echo "Building this and $(git log -1 --format='%h (%s)' "$commit")" >&2
build . >"$scratch/this.log" 2>&1 || { tail -20 "$scratch/this.log" >&2; exit 3; }
build "$scratch/other" >"$scratch/other.log" 2>&1 || { tail -20 "$scratch/other.log" >&2; exit 3; }
this=$PWD/build/release/bin other=$scratch/other/build/release/bin

# Scenes that every revision can run: within and beyond the size of the caches, with few and many beads, with walls.
cd "$scratch"
scene() { # NAME FLAG...
  local name=$1
  shift
  "$other/beadswim-layout" swimmer --preset paper-single "$@" >"$name.json"
}
scene small-periodic --radius 4 --arm 20 --box 96,32,32 --boundary periodic --period 2000
scene dense-periodic --radius 6 --arm 32 --stiffness 0.2 --amplitude 2 --box 96,32,32 --boundary periodic --period 2000
scene large-periodic --radius 4 --arm 20 --box 128,128,128 --boundary periodic --period 2000
scene large-walled --radius 4 --arm 20 --box 128,128,128 --boundary free-slip,no-slip,free-slip --period 2000
declare -A cycles=([small-periodic]=0.2 [dense-periodic]=0.2 [large-periodic]=0.02 [large-walled]=0.02)

# Flags that fix the treatment of beads, so that all revisions compute the same although their defaults may differ.
declare -A beads
for programs in "$this" "$other"; do
  help=$("$programs/beadswim-run" --help)
  for flag in '--bead-boundary staircase' '--radius-correction off' '--delay-correction off'; do
    if [[ $help == *"${flag% *}"* ]]; then beads[$programs]+=" $flag"; fi
  done
done

mlups() { # PROGRAMS SCENE
  # shellcheck disable=SC2086
  mpirun -n "$ranks" "$1/beadswim-run" "$2.json" -o "$2.h5md" --cycles "${cycles[$2]}" --frames-per-cycle 4 \
    --progress none ${beads[$1]-} | jq -e '.cost.mlups | select(. > 0)'
}
products() { # PROGRAMS SCENE
  local surroundings=periodic flags=()
  case "$2" in
    product-open) surroundings=open ;;
    product-unsteady) flags=(--unsteady) ;;
    product-order-*) flags=(--multipole-order "${2##*-}") ;;
  esac
  mpirun -n "$ranks" "$1/beadswim-bench" --beads 34560 --rounds 1 --json "${flags[@]}" 2>bench.log |
    jq -e --arg surroundings "$surroundings" --argjson ranks "$ranks" \
      '.mobility_products[] | select(.surroundings == $surroundings and .ranks == $ranks) | 1 / .seconds'
}
speed() { # PROGRAMS SCENE
  if [[ $2 == product-* ]]; then products "$@"; else mlups "$@"; fi
}
for ((round = 1; round <= rounds; ++round)); do
  for name in "${scenes[@]}"; do
    if ((round % 2 == 1)); then  # neither is always the first
      a=$(speed "$this" "$name") && b=$(speed "$other" "$name") || fail 3 "$name cannot be run"
    else
      b=$(speed "$other" "$name") && a=$(speed "$this" "$name") || fail 3 "$name cannot be run"
    fi
    echo "$name $a $b"
  done
  echo "round $round of $rounds" >&2
done >speeds

awk -v tolerance="$tolerance" '
  function median(values, n,    i, j, t) {
    for (i = 2; i <= n; ++i)
      for (j = i; j > 1 && values[j] < values[j - 1]; --j) { t = values[j]; values[j] = values[j - 1]; values[j - 1] = t }
    return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2
  }
  { if (!($1 in n)) order[++scenes] = $1; k = ++n[$1]; a[$1, k] = $2; b[$1, k] = $3 }
  END {
    printf "%-16s %12s %12s %8s\n", "scene", "this speed", "other speed", "ratio"
    for (s = 1; s <= scenes; ++s) {
      name = order[s]
      for (k = 1; k <= n[name]; ++k) { x[k] = a[name, k]; y[k] = b[name, k]; r[k] = x[k] / y[k] }
      ratio = median(r, n[name])
      slower = ratio < 1 - tolerance
      if (slower) failed = 1
      printf "%-16s %12.4g %12.4g %8.3f%s\n", name, median(x, n[name]), median(y, n[name]), ratio, slower ? "  slower" : ""
    }
    exit failed
  }' speeds
