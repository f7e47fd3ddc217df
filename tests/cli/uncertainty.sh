#!/bin/bash
# Tests what a run states about its errors: expected error, uncertainty by cause, warnings, and power in the fluid with inertia.
source "$(dirname "$0")/harness.sh"

beadswim-layout swimmer --preset paper-single --box 60,40,40 --boundary periodic --period 2000 --amplitude 0.2 >layout.json

# --- a lattice run: its error is that which the plan states, and its power is that of theory
run beadswim-run layout.json -o run.h5md --cells-per-radius 2 --relaxation-time 1 --cycles 5 --progress none
has_status 0
err_empty
cp out run.json
run beadswim-run layout.json --plan --model lbm --cells-per-radius 2 --relaxation-time 1 --precision double --cycles 5
check "the plan expects the same error" holds --slurpfile run run.json '.runs[0].error == $run[0].expected_error' out
check "the parts make the total" holds '.warnings == [] and (.swimmers[0].uncertainty | [.velocity, .arm_amplitudes]
  | all(((.resolution | . * .) + (.wander | . * .) + (.transient | . * .) | sqrt) / .total - 1 | fabs < 1e-12)
    and .[0].wander > 0 and .[1].wander == 0)' run.json
beadswim-theory layout.json --method inertia-corrected >theory.json
run beadswim-compare run.json theory.json
has_status 0
cp out verdict.json
err_has 'velocity .*± [0-9.]+ %  pass'
check "rows have the uncertainties of both" holds --slurpfile run run.json --slurpfile theory theory.json '.rows[0] |
  .run_uncertainty == $run[0].swimmers[0].uncertainty.velocity.total and .reference_uncertainty == $theory[0].predictions[0].uncertainty' verdict.json
check "the error is within the uncertainties" holds '.rows | map(select(.quantity != "sin_phase_shift")) |
  all((.relative_error | fabs) <= .run_uncertainty + .reference_uncertainty)' verdict.json
check "the box changes the velocity" holds '.swimmers[0].uncertainty.velocity.box | . > 0.05 and . < 0.2' run.json
check "the power is that of theory" holds --slurpfile theory theory.json \
  '.swimmers[0].cycles[-1].power / $theory[0].predictions[0].power - 1 | fabs < 0.02' run.json

# --- in a wide box and at a short period, images hardly matter: the power is the exact one of unbounded fluid
beadswim-layout swimmer --preset paper-single --box 64,48,48 --boundary periodic --period 700 --amplitude 0.2 >wide.json
beadswim-theory wide.json --method unsteady-multipole >wide-theory.json
run beadswim-run wide.json -o wide.h5md --cells-per-radius 3 --relaxation-time 1 --cycles 4 --progress none
has_status 0
check "the power is the exact one" holds --slurpfile theory wide-theory.json \
  '.swimmers[0].cycles[-1].power / $theory[0].predictions[0].power - 1 | fabs < 0.02' out

# --- the first cycle alone does not show how far it is from the next
run beadswim-run layout.json -o one.h5md --model rpy+near --cycles 1 --progress none
has_status 0
check "the transient is not known" holds '.swimmers[0].uncertainty.velocity | .transient == null and .total == null and .resolution > 0' out
cp out one.json
run beadswim-compare one.json theory.json --tolerance 0.9
check "neither is the uncertainty of its row" holds '.rows[0].run_uncertainty == null' out

# --- an error above 10 % is a warning, on standard error and in the record; so is an unknown one
run beadswim-run layout.json -o far.h5md --model oseen --cycles 1 --progress none
has_status 0
err_has '^beadswim-run: warning: the velocity is expected to be wrong by [0-9.]+ % and the arm amplitudes by [0-9.]+ %; beadswim-run --plan lists runs with smaller errors$'
check "the record has the warning" holds '.expected_error.velocity > 0.1 and (.warnings | map(.code)) == ["expected-error"]' out
beadswim-layout swimmer --preset paper-single --unbounded --period 2000 --amplitude 0.2 >open.json
run beadswim-run open.json -o far.h5md --model auto --tolerance 0.9 --cycles 1 --progress none
has_status 0
# Three models cost about the same here; the plan may choose any of them.
check "a run that a plan chose within a larger tolerance has none" \
  holds '(.expected_error.velocity > 0.1 or .model != "oseen") and .warnings == []' out
beadswim-layout swimmer --preset paper-single --box 60,60,60 --boundary periodic --period 2000 --axis 0,1,0 >across.json
run beadswim-run across.json -o across.h5md --model rpy --cycles 2 --progress none
has_status 0
err_has '^beadswim-run: warning: the error of this run is not known: theory cannot predict the motion: the driving forces are perpendicular'
check "the record says so" holds '.expected_error == null and (.warnings | map(.code) | sort) == ["error-unknown", "forces-fixed-in-box"]
  and (.swimmers[0].uncertainty.velocity | .resolution == null and .wander == null and .box == null and .total == null and .transient != null)' out

finish
