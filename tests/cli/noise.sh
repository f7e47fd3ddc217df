#!/bin/bash
# Tests thermal noise in runs: keys of layouts, flags, records, restarts, and what is refused.
source "$(dirname "$0")/harness.sh"

quiet=(--progress none --no-provenance)
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.4 --thermal-energy 0.02 >warm.json
check 'the layout lacks its thermal energy' holds '.fluid.thermal_energy == 0.02' warm.json
accepts beadswim-layout check warm.json

# --- the noise is that of the seed; the steps are as short as contacts need, and frames lie on them
run beadswim-run warm.json -o one.h5md --model rpy --cycles 0.5 "${quiet[@]}"
has_status 0
cp out one.json
check 'the record lacks the noise' holds '.thermal | .thermal_energy == 0.02 and .seed == 1 and .noise_tolerance == 1e-3 and .noise_error <= 1e-3' one.json
check 'the steps are too long for contacts' holds '.mobility | .steps_per_cycle % 40 == 0 and .steps_per_cycle >= 1194 and .steps_per_cycle < 1240' one.json
run beadswim-run warm.json -o two.h5md --model rpy --cycles 0.5 --seed 2 "${quiet[@]}"
check 'seeds have the same noise' holds --slurpfile one one.json '.thermal.seed == 2 and .state_sha256 != $one[0].state_sha256' out
run bash -c 'beadswim-layout vary warm.json --over /seed=1:2:2 | tail -n 1 | beadswim-run - -o two.h5md --model rpy --cycles 0.5 --progress none --no-provenance'
check 'the seed of the layout counts' holds '.thermal.seed == 2' out
run mpirun -n 2 beadswim-run warm.json -o ranks.h5md --model rpy --cycles 0.5 "${quiet[@]}"
check 'ranks change the noise' holds --slurpfile one one.json '.state_sha256 == $one[0].state_sha256' out

# --- a restart goes on with the same noise
run beadswim-run warm.json -o part.h5md --model rpy --cycles 0.5 --checkpoint-every 0.3 "${quiet[@]}"
run beadswim-run --restart part.h5md.ckpt.0 -o part.h5md --cycles 0.5 "${quiet[@]}"
has_status 0
check 'a restart changes the noise' holds --slurpfile one one.json '.state_sha256 == $one[0].state_sha256' out
refuses '^beadswim-run: --seed: the value 3 differs from' beadswim-run --restart part.h5md.ckpt.0 --cycles 1 --seed 3

# --- little noise changes little: the step is of second order
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.4 --thermal-energy 1e-14 >cold.json
jq 'del(.fluid.thermal_energy)' cold.json >still.json
for scene in cold still; do
  run beadswim-run $scene.json -o $scene.h5md --model rpy --cycles 3 --steps-per-cycle 400 "${quiet[@]}"
  has_status 0
  cp out $scene.run
done
check 'little noise changes the motion' holds --slurpfile still still.run '.swimmers[0].cycles[-1] as $cold | $still[0].swimmers[0].cycles[-1]
  | ($cold.speed_along_axis / .speed_along_axis - 1 | fabs < 1e-3) and ($cold.arm_amplitudes[0] / .arm_amplitudes[0] - 1 | fabs < 1e-3)' cold.run

# --- each model in each domain
for domain in "--unbounded" "--box 120,80,80 --boundary periodic" "--box 120,80,80 --boundary periodic,periodic,free-slip" "--half-space z --position 0,0,40"; do
  beadswim-layout swimmer --preset paper-single $domain --amplitude 0.4 --thermal-energy 0.02 >warm2.json
  for model in rpy rpy+near "multipole --multipole-order 1"; do
    run beadswim-run warm2.json -o x.h5md --model $model --cycles 0.02 "${quiet[@]}"
    has_status 0
  done
done

# --- a temperature: 300 K are 4.141947e-21 J, and pg um^2/s^2 are 1e-27 J
si=(--unbounded --units um,s,pg --radius 1 --viscosity 1e6 --density 1 --period 1)
accepts beadswim-layout shape sphere "${si[@]}" --temperature 300K
check 'the thermal energy is wrong' holds '.fluid.thermal_energy / 4.141947e6 - 1 | fabs < 1e-12' out
refuses 'units "lattice" have no kelvin; give --units' beadswim-layout swimmer --preset paper-single --unbounded --temperature 300K
refuses '"300": the value must be a temperature in kelvin, such as 300K' beadswim-layout shape sphere "${si[@]}" --temperature 300
refuses '"-3K": the value must be a temperature' beadswim-layout shape sphere "${si[@]}" --temperature=-3K
refuses '--temperature' beadswim-layout shape sphere "${si[@]}" --temperature 300K --thermal-energy 1

# --- theory and checks state what noise does: kT/(k l^2), the momentum time, the Peclet number
beadswim-layout swimmer --preset paper-single --unbounded --amplitude 0.2 --frame body --thermal-energy 0.02 >theory.json
accepts beadswim-layout check theory.json
out_has '^  kT/\(k l\^2\), arms 1, 2 +0.001441, 0.001441$'
out_has '^  momentum time lambda\^2/nu over the period +0.01'
run beadswim-layout check --json theory.json
valid layout-check out
cp out check.json
beadswim-theory theory.json --method rpy-perturbation >prediction.json 2>err
err_has 'predicted motions leave out the thermal noise'
valid prediction prediction.json
check 'the Peclet numbers differ' holds -n --slurpfile c check.json --slurpfile p prediction.json \
  '$c[0].types.a.peclet / $p[0].predictions[0].thermal.peclet - 1 | fabs < 0.01'
check 'the effective diffusion is not that of its parts' holds '.predictions[0] | .velocity as $v | .thermal
  | (.passive_diffusion + $v * $v / (6 * .rotational_diffusion)) / .effective_diffusion - 1 | fabs < 1e-12' prediction.json

# --- a run states means with standard errors, by which compare judges it; means over seeds
run bash -c 'beadswim-layout vary theory.json --over thermal-energy=0.01,0.02 --over /seed=1:3:3 |
  beadswim-run --model rpy --cycles 24 --progress none --no-provenance -o noisy-{}.h5md'
has_status 0
cp out noisy.jsonl
check 'a run lacks the diffusion' holds -s 'length == 6 and all(.[]; .thermal | .effective_diffusion.standard_error > 0
  and .rotational_diffusion.mean > 0 and .lag == 4800)' noisy.jsonl
sed -n 4p noisy.jsonl >one.run
run beadswim-compare one.run prediction.json --quantity velocity,rotational_diffusion,arm_amplitudes
has_status 0
check 'the verdict is not by the standard error' holds '.rows | length == 4 and all(.[]; .run_uncertainty > 0 and .tolerance >= 2 * .run_uncertainty * .run / .reference - 1e-9)' out
check 'the rotational diffusion is not that of theory' holds '.rows[] | select(.quantity == "rotational_diffusion") | .run / .reference | . > 0.4 and . < 2' out
accepts beadswim-plot against noisy.jsonl --x thermal-energy --mean-over seed --data means.csv -o means.svg
check 'a mean of three seeds is wrong' python3 -c '
import csv, json
rows = list(csv.reader(open("means.csv")))[1:]
assert len(rows) == 2, rows
speeds = [[c["speed_along_axis"] for c in json.loads(line)["swimmers"][0]["cycles"][1:]] for line in open("noisy.jsonl")]
mean = sum(sum(s) / len(s) for s in speeds[:3]) / 3
assert abs(float(rows[0][-2]) / mean - 1) < 1e-9 and float(rows[0][-1]) > 0, (rows, mean)'
refuses '"colour" is not varied in any file' beadswim-plot against noisy.jsonl --x thermal-energy --mean-over colour
accepts beadswim-plot msd noisy-4.h5md prediction.json --data msd.csv -o msd.svg
well_formed msd.svg
check 'theory begins with other displacements than it predicts' holds -n --slurpfile p prediction.json \
  --argjson y "$(grep theory msd.csv | grep square | head -1 | awk -F, '{print $(NF-1)}')" \
  '$p[0].predictions[0] | 4800 as $t | (6 * .thermal.passive_diffusion * $t + .velocity * .velocity * $t * $t) / $y - 1 | fabs < 0.02'
refuses 'cycles of 1 swimmers are too few for a mean' beadswim-plot msd one.h5md --data x.csv

# --- shapes without driving do not swim
for shape in dumbbell triangle prescribed-three-bead purcell-chain; do
  beadswim-layout shape $shape --amplitude 0 --unbounded --thermal-energy 0.01 >rest.json
  run beadswim-run rest.json -o rest.h5md --model rpy --cycles 12 "${quiet[@]}"
  has_status 0
  check "$shape swims without driving" holds '.thermal.mean_velocity | [.mean, .standard_error] | transpose | all(.[]; (.[0] | fabs) < 4 * .[1])' out
done

# --- what cannot be is refused
beadswim-layout swimmer --preset paper-single --box 120,80,80 --thermal-energy 0.02 >boxed.json
refuses 'boxed.json:/fluid/thermal_energy: the lattice lacks thermal noise; use --model rpy, rpy\+near or multipole, which neglect .* within 0.01 periods' \
  beadswim-run boxed.json -o x.h5md --model lbm
refuses 'warm.json:/fluid/thermal_energy: the model unsteady lacks thermal noise; use --model rpy' beadswim-run warm.json -o x.h5md --model unsteady
refuses 'warm.json:/fluid/thermal_energy: the mobility of the model oseen is not positive' beadswim-run warm.json -o x.h5md --model oseen
refuses '^beadswim-run: --steps-per-cycle: contacts do not hold against .*; use at least 1194 --steps-per-cycle' beadswim-run warm.json -o x.h5md --model rpy --steps-per-cycle 100
for energy in -1 nan inf; do
  refuses '--thermal-energy' beadswim-layout swimmer --preset paper-single --unbounded --thermal-energy=$energy
done
jq '.fluid.thermal_energy = -1' warm.json >bad.json
refuses 'bad.json:/fluid/thermal_energy' beadswim-run bad.json -o x.h5md --model rpy

finish
