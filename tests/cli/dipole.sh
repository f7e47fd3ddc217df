#!/bin/bash
# Tests the force dipole of runs and predictions. The reference numbers are those of an independent integration
# of three beads on a line with Rotne-Prager pairs (Runge-Kutta of order 4, 400 steps per period).
source "$(dirname "$0")/harness.sh"

paper() { beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.2 --period 4800 "$@"; }
settings=(--progress none --no-provenance)

# --- Runs by rpy agree with theory, and both with the reference. A wrong sign or a factor of a missing mean
# force fails: the mean of the springs is a half of the dipole of the paper's swimmer.
row() { # NAME DIPOLE FLAGS...
  paper "${@:3}" >"$1.json"
  run beadswim-run "$1.json" -o "$1.h5md" --model rpy --cycles 5 "${settings[@]}"
  has_status 0
  mv out "$1-run.json"
  run beadswim-theory "$1.json" --method rpy-ode,rpy-perturbation
  has_status 0
  mv out "$1-theory.json"
  check "the dipole of the run of $1 is wrong" \
    holds --argjson p "$2" '.swimmers[0].cycles[-1].dipole | (.axial / $p - 1 | fabs) < 0.01
      and (.axial - 1.5 * .tensor[0] | fabs) < 1e-9 and (.tensor[0:3] | add | fabs) < 1e-9' "$1-run.json"
  check "the dipole of rpy-ode of $1 is wrong" \
    holds --argjson p "$2" '.predictions[] | select(.method == "rpy-ode").dipole.axial / $p - 1 | fabs < 1e-3' "$1-theory.json"
  check "the dipole to second order of $1 is wrong" \
    holds --argjson p "$2" '.predictions[] | select(.method == "rpy-perturbation").dipole.axial / $p - 1 | fabs < 0.1' "$1-theory.json"
}
row large 0.0595303 --radius 4,4,8
row short 0.0457449 --arm 14,26
row long -0.0469999 --arm 26,14
run beadswim-compare large-run.json large-theory.json --method rpy-ode --quantity dipole --tolerance 0.01
has_status 0

# --- the table of a trajectory has the numbers of the record, but not the efficiency
accepts beadswim-compare short.h5md --table file.csv
accepts beadswim-compare short-run.json --table record.csv
check 'the tables differ' python3 -c '
import csv
file, record = (list(csv.DictReader(open(name))) for name in ("file.csv", "record.csv"))
assert len(file) == 5 and file[0].pop("efficiency") == "" and record[0].pop("efficiency") != ""
for a, b in zip(file, record):
    for name in set(a) - {"efficiency"}: assert a[name] == b[name] or abs(float(a[name]) - float(b[name])) < 1e-12 * abs(float(b[name])), (name, a[name], b[name])
assert all(any(name.startswith(known) and row[name] for name in row) for row in file for known in ("dipole", "power", "angular_velocity_z"))'

# --- the equal swimmer has nearly none: below 0.05 of 6 pi eta lambda v l
paper >equal.json
run beadswim-run equal.json -o equal.h5md --model rpy --cycles 5 "${settings[@]}"
has_status 0
mv out equal-run.json
check 'the dipole of the equal swimmer is too large' \
  holds '.swimmers[0].cycles[-1] | (.dipole.axial | fabs) < 0.05 * 6 * 3.14159 / 3 * 4 * .speed_along_axis * 20' equal-run.json

# --- stresslets of beads: exact theory of spheres on a line against a model that contains force moments of beads, and one that
# corrects close pairs
beadswim-theory large.json --method multipole-ode >exact.json
exact() { # TOLERANCE MODEL...
  run beadswim-run large.json -o model.h5md --cycles 4 "${settings[@]}" --model "${@:2}"
  has_status 0
  mv out model.json
  run beadswim-compare model.json exact.json --method multipole-ode --quantity dipole --tolerance "$1"
  has_status 0
}
exact 0.05 rpy+near
exact 0.02 multipole --multipole-order 2
check 'exact motion to second order differs too much from that at finite amplitude' \
  holds -n --slurpfile exact exact.json --slurpfile second <(beadswim-theory large.json --method multipole-perturbation) \
  '$second[0].predictions[0].dipole.axial / $exact[0].predictions[0].dipole.axial - 1 | fabs < 0.1'

# --- a restart keeps the bits
run beadswim-run large.json -o part.h5md --model rpy --cycles 2.3 --checkpoint-every 2.3 "${settings[@]}"
has_status 0
run beadswim-run --restart part.h5md -o on.h5md --cycles 5 "${settings[@]}"
has_status 0
check 'a restart changes the dipole' \
  holds '[., input] | map(.swimmers[0].cycles | map(.dipole)) | .[0] == .[1]' large-run.json out

# --- Prescribed strokes: mirror and time reversal together keep the velocity and turn the dipole over. Equal arms and beads have
# p(d1, d2) = -p(d2, d1), of fourth order in the amplitude; the rest is the error of the time steps.
prescribed() { # AMPLITUDES   writes a layout
  beadswim-layout shape prescribed-three-bead --amplitude "$1" --unbounded
}
for d in 2,4 4,2 1,2 2,1 2,2; do prescribed $d | beadswim-theory --method rpy-ode >"$d.json"; done
check 'prescribed strokes lack the symmetry' holds -s 'map(.predictions[0] | [.dipole.axial, 6 * 3.14159 / 3 * 4 * 20 * .velocity])
  | (.[0][1] / 1000) as $small
  | (.[0][0] + .[1][0] | fabs) < $small and (.[2][0] + .[3][0] | fabs) < $small and (.[4][0] | fabs) < $small
    and .[1][0] > 10 * $small and ((.[1][0] - .[0][0]) / (.[3][0] - .[2][0]) / 16 - 1 | fabs) < 0.02' \
  2,4.json 4,2.json 1,2.json 2,1.json 2,2.json
for d in 2,4 4,2; do
  prescribed $d >stroke.json
  run beadswim-run stroke.json -o stroke.h5md --model rpy --cycles 2 --steps-per-cycle 200 "${settings[@]}"
  has_status 0
  mv out "$d-run.json"
done
check 'runs of swapped amplitudes have dipoles that are not opposite' \
  holds -s 'map(.swimmers[0].cycles[-1].dipole.axial) | .[0] / .[1] + 1 | fabs < 0.02' 2,4-run.json 4,2-run.json

# --- the dipole in searches and figures
run beadswim-optimise large.json --free amplitude=0.1:0.2 --maximise dipole --evaluations 10 --method rpy-ode
has_status 0
check 'the largest dipole is not that of the layout' \
  holds --slurpfile theory <(beadswim-theory out --method rpy-ode) '.study.dipole == $theory[0].predictions[0].dipole.axial' out
beadswim-layout vary large.json --over amplitude=0.1,0.2 | beadswim-theory --method rpy-ode >study.jsonl
run beadswim-plot against study.jsonl --x amplitude --y dipole -o figure.svg --data -
has_status 0
check 'the figure has other dipoles' cmp <(sed 1d out | cut -d, -f7) <(jq '.predictions[0].dipole.axial' study.jsonl)

# --- The lattice: the same bits on any number of ranks
box=(--box 80,48,48 --boundary periodic --position 40,24,24)
lattice() { # RANKS LAYOUT CELLS SCHEME CYCLES
  run mpirun -n "$1" beadswim-run "$2" -o lattice.h5md --cells-per-radius "$3" --bead-boundary "$4" --cycles "$5" "${settings[@]}"
  has_status 0
}
beadswim-layout swimmer --preset paper-single --amplitude 0.2 --period 600 "${box[@]}" --radius 4,4,8 >fast.json
for scheme in mr psm; do
  for ranks in 1 2 3; do
    lattice $ranks fast.json 2 $scheme 1
    cp out "$ranks-ranks.json"
  done
  check "the dipole depends on the number of ranks with $scheme" holds -n '[inputs.swimmers[0].cycles] | unique | length == 1' {1,2,3}-ranks.json
done

rest_is_long

beadswim-layout swimmer --preset paper-single --amplitude 0.2 --period 4800 "${box[@]}" --radius 4,4,8 >box.json

# --- against a model of the same box with inertia
beadswim-layout swimmer --preset paper-single --amplitude 0.2 --period 4800 "${box[@]}" --arm 26,14 >arms.json
for scene in box arms; do
  run beadswim-run $scene.json -o unsteady.h5md --model unsteady --multipole-order 2 --cycles 3 "${settings[@]}"
  has_status 0
  mv out $scene-unsteady.json
done
differs() { # SCENE   prints the relative difference of the run in the file out
  jq --slurpfile unsteady "$1-unsteady.json" '.swimmers[0].cycles[-1].dipole.axial / $unsteady[0].swimmers[0].cycles[-1].dipole.axial - 1' out
}
close_to() { # SCENE LIMIT
  check "the dipole of $1 differs by $(differs "$1")" holds -n --argjson d "$(differs "$1")" --argjson limit "$2" '$d | fabs < $limit'
}
lattice 2 arms.json 3 mr 3
close_to arms 0.05
for scheme in cli mr; do
  lattice 2 box.json 3 $scheme 3
  close_to box 0.05
done

finish
