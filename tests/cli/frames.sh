#!/bin/bash
# Tests that the frames of a trajectory are evenly spaced in time with every model, and the same in a run that was restarted.
source "$(dirname "$0")/harness.sh"

beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic --period 100 \
  --amplitude 0.05 >layout.json

# Checks times and positions of the frames of FILE.h5md. The x coordinates of bead 1 in the last cycle are smooth: their fourth
# differences are far below those of a swing at uneven times.
frames_are_even() { # FILE FRAMES-PER-CYCLE CYCLES
  h5dump -y -m %.17g -d /particles/beads/position/time -o times -O "$1.h5md" >/dev/null
  h5dump -y -m %.9g -d /particles/beads/position/value -o positions -O "$1.h5md" >/dev/null
  check "the frames of $1 are not even" python3 - "$2" "$3" <<'EOF'
import sys
frames, cycles = int(sys.argv[1]), int(sys.argv[2])
numbers = lambda path: [float(word) for word in open(path).read().replace(",", " ").split()]
times, x = numbers("times"), numbers("positions")[::9]
assert len(times) == len(x) == frames * cycles + 1, f"{len(times)} frames"
uneven = max(abs(time - 100 * n / frames) for n, time in enumerate(times))
assert uneven < 1e-10, f"a frame is {uneven} from its time"
last = x[-frames - 1:]
for _ in range(4):
    last = [b - a for a, b in zip(last, last[1:])]
roughness = max(map(abs, last)) / (max(x) - min(x))
assert roughness < (6.3 / frames) ** 4 + 2e-4, f"roughness {roughness}"
EOF
}
small() { # RANKS ARGUMENT...
  mpirun -n "$1" beadswim-run "${@:2}" --progress none --no-provenance
}
lattice="--model lbm --cells-per-radius 2 --relaxation-time 1.5"

# --- the default flags: the lattice has 100 steps per cycle, the mobility models a multiple of the 40 frames
run small 1 layout.json -o lbm.h5md $lattice --cycles 2
has_status 0
check "the lattice has steps between frames" holds '.resolution.steps_per_cycle == 100' out
frames_are_even lbm 40 2
for model in rpy rpy+near oseen; do
  run small 1 layout.json -o $model.h5md --model $model --cycles 2
  has_status 0
  err_empty
  check "$model has three steps per frame" holds '.mobility.steps_per_cycle == 120' out
  frames_are_even $model 40 2
done
run small 1 layout.json -o twelve.h5md --model rpy --frames-per-cycle 12 --cycles 2
check "the steps follow the frames" holds '.mobility.steps_per_cycle == 108' out
frames_are_even twelve 12 2

# --- frames between steps; steps that are given stay as they are
run small 1 layout.json -o seven.h5md $lattice --frames-per-cycle 17 --cycles 2
frames_are_even seven 17 2
cp out seven.json
run small 1 layout.json -o ninety.h5md --model rpy --steps-per-cycle 90 --cycles 2
check "the steps are those of the flag" holds '.mobility.steps_per_cycle == 90' out
frames_are_even ninety 40 2
cp out ninety.json
run small 1 layout.json -o few.h5md --model rpy --steps-per-cycle 30 --cycles 2
err_has '^beadswim-run: warning: a cycle has only 30 time steps, so 30 frames per cycle are recorded instead of 40$'
frames_are_even few 30 2

# --- a restarted run has the same frames; the number of steps does not change
restart() { # NAME RANKS FLAG...
  run small "$2" layout.json -o part.h5md --cycles 0.9 --checkpoint-every 0.43 "${@:3}"
  run small "$2" --restart part.h5md --cycles 2
  has_status 0
  check "the record of $1 is that of an unbroken run" cmp -s out "$1.json"
  check "the frames of $1 are those of an unbroken run" h5diff "$1.h5md" part.h5md
}
restart seven 2 $lattice --frames-per-cycle 17
restart ninety 1 --model rpy --steps-per-cycle 90
refuses '^beadswim-run: --steps-per-cycle: the value 100 differs from 90, ' \
  beadswim-run --restart part.h5md --steps-per-cycle 100 --cycles 3
run small 1 layout.json -o part.h5md --model rpy --cycles 0.5 --checkpoint-every 0.5
refuses '^beadswim-run: --steps-per-cycle: the value 100 differs from the default, ' \
  beadswim-run --restart part.h5md --steps-per-cycle 100 --cycles 3

# --- with forces: without inertia, force of the fluid, drive and springs of a bead sum to zero; with inertia, those of a swimmer as
# heavy as the fluid sum to its acceleration; a restart continues the frames
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.3 --period 2000 >open.json
beadswim-layout swimmer --preset paper-single --box 64,48,48 --amplitude 0.3 --period 400 >box.json
forces_balance() { # FILE STIFFNESS PERIOD TOLERANCE MASS
  for name in position force drive; do
    h5dump -y -m %.9g -d /particles/beads/$name/value -o $name -O "$1.h5md" >/dev/null
  done
  h5dump -y -m %.9g -d /particles/beads/velocity/value -o velocity -O "$1.h5md" >/dev/null
  check "the forces of $1 do not balance" python3 - "$2" "$3" "$4" "$5" <<'EOF'
import sys
stiffness, period, tolerance, mass = map(float, sys.argv[1:])
x, force, drive, v = ([float(word) for word in open(name).read().replace(",", " ").split()][::3]
                      for name in ("position", "force", "drive", "velocity"))
frames = len(x) // 3
size = max(map(abs, drive))
assert size > 0.2, size
worst = 0
for n in range(45, frames - 1):
    left, right = (stiffness * (x[3 * n + b + 1] - x[3 * n + b] - 20) for b in (0, 1))
    springs = left, right - left, -right
    for b in range(3):
        acceleration = (v[3 * n + 3 + b] - v[3 * n - 3 + b]) / (2 * period / 40)
        worst = max(worst, abs(force[3 * n + b] + drive[3 * n + b] + springs[b] - mass * acceleration))
assert worst < tolerance * size, worst / size
EOF
}
run small 1 open.json -o rpy.h5md --model rpy --frames-with forces --cycles 3
has_status 0
forces_balance rpy 0.0347 2000 1e-4 0
run small 1 open.json -o near.h5md --model rpy+near --frames-with forces --cycles 3
forces_balance near 0.0347 2000 1e-4 0
run small 1 box.json -o unsteady.h5md --model unsteady --frames-with forces --cycles 3
forces_balance unsteady 0.0347 400 0.01 268.08
# On the lattice, forces are means since the frame before, on beads with the mass that corrects their delay.
run small 1 box.json -o lattice.h5md --model lbm --cells-per-radius 2 --relaxation-time 1 --frames-with forces --cycles 2
has_status 0
for name in position force drive velocity; do h5dump -y -m %.9g -d /particles/beads/$name/value -o $name -O lattice.h5md >/dev/null; done
check "the forces of the lattice do not balance" python3 - "$(jq .resolution.density_on_lattice out)" <<'EOF'
import sys
mass, stiffness, step = 268.08 * float(sys.argv[1]), 0.0347, 400 / 40
x, force, drive, v = ([float(word) for word in open(name).read().replace(",", " ").split()][::3]
                      for name in ("position", "force", "drive", "velocity"))
others = []  # forces of drives and springs
for n in range(0, len(x), 3):
    left, right = (stiffness * (x[n + b + 1] - x[n + b] - 20) for b in (0, 1))
    others += [drive[n] + left, drive[n + 1] + right - left, drive[n + 2] - right]
worst = max(abs(force[k] + (others[k] + others[k - 3]) / 2 - mass * (v[k] - v[k - 3]) / step) for k in range(6, len(x)))
assert worst < 0.01 * max(map(abs, drive)) and max(map(abs, force)) > 0.2, (worst, max(map(abs, force)))
EOF
run small 1 open.json -o part.h5md --model rpy --frames-with forces --cycles 1.4 --checkpoint-every 0.7
run small 1 --restart part.h5md --cycles 3
check "the frames with forces are those of an unbroken run" h5diff rpy.h5md part.h5md

finish
