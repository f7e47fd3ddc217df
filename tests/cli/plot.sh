#!/bin/bash
# Tests beadswim-plot: its figures must be well-formed, equal on every run of the program, and contain the data of the input
# files.
source "$(dirname "$0")/harness.sh"
stored_documents

has_numbers() { # NUMBER FIGURE...   how many points the figure of these arguments has; figure_test draws each point once
  check "the figure does not have $1 points" test "$(beadswim-plot "${@:2}" -o x.svg --data - | sed 1d | wc -l)" -eq "$1"
}

# --- what it says of itself
kinds='stroke velocity-against-period against separation speed-against-error trajectories msd swarm flow swimmer mobility-products'
accepts beadswim-plot --help
check 'a kind is not listed with one line' test "$(sed -n '/^Subcommands:/,/^$/p' out | grep -vc '^$')" -eq 23
has_flags() { # KIND FLAG...   these alone, beside those of all kinds
  accepts beadswim-plot "$1" --help
  check "$1 has other flags" test "$(grep -oE '^  (-[a-z],)?--[a-z-]+' out | xargs)" = "$(echo -h,--help -o,--output "${@:2}")"
}
for kind in $kinds; do out_has "^  $kind$"; done
has_flags stroke --data --method --cycle --against --bonds
has_flags velocity-against-period --data --method --cycle --relative-to --axes
has_flags against --data --x --y --colour --x-label --group-by --mean-over --log --method --cycle
has_flags msd --data --method
has_flags separation --data --method --cycle --relative-to --axes
has_flags speed-against-error --data --method --cycle --reference --quantity
has_flags trajectories --data --swimmers --beads --along --against
has_flags swarm --data --frame --colours --colour --block-swimmers --repeat --mark --distances
has_flags flow --data --plane --quantity --style
has_flags swimmer --data --swimmers
has_flags mobility-products --data
accepts beadswim-plot --help-all
for flag in --against --relative-to --reference --beads --mark --swimmers; do out_has "^ +$flag "; done
accepts beadswim-plot --version
for flag in --help --version; do
  run bash -c "beadswim-plot $flag >/dev/full"
  has_status 3
done

# --- stroke
has_numbers 15 stroke run.json prediction.json # 3 cycles, and 2 ends of a level, of d1, d2 and the phase shift
accepts beadswim-plot stroke run.json prediction.json
well_formed out
out_has '>d₁, multipole-ode<'
out_has '>arm amplitude \(lattice units\)<'
notes_have 'Runs: T = 4800, δ/λ = 5.64, Re = 0.15; 4 cells per radius, τ = 1.5, cli, double; box 120 × 80 × 80'
has_numbers 21 stroke run.json prediction.json --method rpy-perturbation,oseen-force-closed
same_bytes 'beadswim-plot stroke run.json prediction.json' 'beadswim-plot stroke - prediction.json <run.json'
jq '.units = {length: {name: "um", si_factor: 1e-6}, time: {name: "s", si_factor: 1}, mass: {name: "pg", si_factor: 1e-15}}' \
  run.json >si.json
accepts beadswim-plot stroke si.json
out_has '>arm amplitude \(um\)<'

# A swarm of over 64 swimmers has none in its record.
jq '{mean: 0, deviation: 0, smallest: 0, largest: 0} as $same | del(.swimmers) | .swarm = [{index: 1, swimmers: 65, swimming: null, mean_axis: [1, 0, 0], polar_order: 1, nematic_order: 1, director: [1, 0, 0],
  rotation: $same, nearest_neighbour: $same, kinetic_energy: 0, momentum: [0, 0, 0]}]' run.json >swarm.json
for kind in stroke velocity-against-period separation; do
  refuses 'swarm.json: the run record contains only statistics of the swarm, .* more than 64 swimmers, and there is no swarm.h5md; name the trajectory' \
    beadswim-plot $kind swarm.json
done

# --- velocity against period
files='run.json run_shorter_period.json prediction.json prediction_shorter_period.json'
has_numbers 6 velocity-against-period $files --method multipole-ode,oseen-force-closed
accepts beadswim-plot velocity-against-period $files --method multipole-ode,oseen-force-closed
well_formed out
out_has '>velocity \(10⁻⁵ lattice units\)<'
out_has '>period T \(lattice units\)<'
# Runs of one setting are one series, and the label says what sets them apart.
jq -c '.driving.period = 3000' run.json >run3.json
jq -c '.resolution.bead_boundary = "staircase"' run.json >staircase.json
accepts beadswim-plot velocity-against-period run.json staircase.json run3.json
out_has '>lbm cli<'
out_has '>lbm staircase<'
jq -c '.model = "rpy" | .resolution = null' run3.json >model.json
accepts beadswim-plot velocity-against-period run.json model.json
out_has '>lbm cli, 4 cells per radius, τ = 1.5, double<'
out_has '>rpy<'
accepts beadswim-plot velocity-against-period run.json staircase.json run3.json
notes_have 'Runs: Re = 0\.15; 4 cells per radius, τ = 1.5, double; box 120 × 80 × 80'   # T is the abscissa
jq -c '.resolution.cells_per_radius = 3 | .resolution.relaxation_time = 0.8' run3.json >coarse3.json
accepts beadswim-plot separation run.json staircase.json coarse3.json
notes_have 'Runs: T = 3000 to 4800, Re = .*; 3 to 4 cells per radius, τ = 0.8 to 1.5, double; box'
jq -c '.driving += {amplitude: [0.2, 0.2], phase: 1.57}' run.json >usual.json
jq -c '.driving.phase = 1' usual.json >other.json
jq -c '.resolution.cells_per_radius = 3' other.json >three.json
accepts beadswim-plot stroke --against phase usual.json three.json other.json
out_has '>d₁, lbm 4 cells per radius<'
out_has '>d₂, lbm 3 cells per radius<'
check 'files are not told apart' test "$(grep -c 'json<' out)" -eq 0
accepts beadswim-plot velocity-against-period si.json --cycle 2
out_has '>velocity \(10⁻⁵ um/s\)<'

# --- sweeps: documents made of prediction.json, one a line, in no order
swept() { # KEY VALUE JQ-EDIT   the settings have that number, and the edit knows it as $x
  jq -c --argjson x "$2" "(.predictions[].settings.$1 = \$x) | .predictions |= map($3)" prediction.json
}
series() { # COLOUR   the coordinates of its first line in out, one point a line
  grep -oE "<polyline points=\"[^\"]*\".* stroke=\"$1\"" out | head -1 | cut -d'"' -f2 | tr ' ' '\n'
}
colour() { # METHOD   of its key, the line before its name
  grep -B1 ">$1<" out | grep -oE 'stroke="#[0-9A-F]+"' | cut -d'"' -f2
}
straight() { # points on standard input, to the rounding of their coordinates
  python3 -c 'import sys
p = [tuple(map(float, line.split(","))) for line in sys.stdin]
(a, b), (c, d) = p[0], p[-1]
sys.exit(len(p) < 3 or max(abs(b + (x - a) * (d - b) / (c - a) - y) for x, y in p) > 0.02)'
}

# --- separation: v = 1/x^2, over two decades, is a straight line
for x in 20 2 12 30 5; do swept separation_ratio $x '.velocity = 1 / ($x * $x)'; done >by_separation.jsonl
accepts beadswim-plot separation by_separation.jsonl --method multipole-ode,oseen-force-closed
well_formed out
out_has '>separation of neighbouring beads over their radius, l/λ<'
check 'a power law is not straight' straight < <(series "$(colour multipole-ode)")
check 'predictions are not joined in order' sort -cn < <(series "$(colour multipole-ode)" | cut -d, -f1)
check 'methods are out of order' \
  test "$(grep -oE '>(multipole-ode|oseen-force-closed)<' out | tr -d '<>' | xargs)" = 'multipole-ode oseen-force-closed'
run beadswim-plot separation by_separation.jsonl --method multipole-ode --axes linear
check 'a power law is straight on linear axes' bash -c '! "$@"' - test "$(series '#0072B2' | straight; echo $?)" = 0
accepts beadswim-plot separation by_separation.jsonl --method all
out_has '>rpy-force-printed<'
notes_have 'Predictions: T = 4800, unbounded fluid'
notes_have 'Thin and pale: unusable predictions'
in_fluid() { # FLUID METHODS   of which the others are for unbounded fluid
  jq -c --arg fluid "$1" --arg methods "$2" '.predictions |= map(.settings.fluid =
    if .method | test($methods) then $fluid else "unbounded" end)' by_separation.jsonl
}
in_fluid "box: 80 x 48 x 48" multipole-ode >boxed.jsonl
accepts beadswim-plot separation boxed.jsonl --method multipole-ode,oseen-force-closed
notes_have "Predictions: T = 4800, unbounded fluid; multipole-ode in the layout's box"
accepts beadswim-plot separation boxed.jsonl --method multipole-ode
notes_have "Predictions: T = 4800, in the layout's box"
accepts beadswim-plot separation boxed.jsonl --method oseen-force-closed
notes_have 'Predictions: T = 4800, unbounded fluid'
in_fluid "half-space, with background flow" multipole-ode >flowing.jsonl
accepts beadswim-plot separation flowing.jsonl --method multipole-ode,oseen-force-closed
notes_have 'Predictions: T = 4800, unbounded fluid; multipole-ode in fluid over a wall, with background flow'
{ head -n 1 flowing.jsonl; tail -n +2 by_separation.jsonl; } >mixed.jsonl
accepts beadswim-plot separation mixed.jsonl --method multipole-ode
notes_have 'Predictions: T = 4800, unbounded fluid; fluid over a wall, with background flow'
has_numbers 6 separation by_separation.jsonl run.json --method multipole-ode
same_bytes 'beadswim-plot separation by_separation.jsonl' 'beadswim-plot separation - <by_separation.jsonl'
split -l 1 by_separation.jsonl one.
same_bytes 'beadswim-plot separation by_separation.jsonl' 'beadswim-plot separation one.*'

# --- what is not usable may have poles: it moves no axis, and is thin
swept separation_ratio 4 '(.velocity = 1) | (select(.method == "rpy-force-printed") | .velocity) = 1e30' >poles.jsonl
cat by_separation.jsonl >>poles.jsonl
swept separation_ratio 4 '.velocity = 1' | cat - by_separation.jsonl >no_poles.jsonl
lines() { beadswim-plot separation "$1" --method multipole-ode,rpy-force-printed | grep -v 'opacity=\|^<path'; }
export -f lines
same_bytes 'lines poles.jsonl' 'lines no_poles.jsonl'
run beadswim-plot separation poles.jsonl --method multipole-ode,rpy-force-printed
out_has '<polyline .* opacity="0\.'
swept separation_ratio 4 '.velocity = (if .usable then 1 else -1 end)' | cat - by_separation.jsonl >negative.jsonl
accepts beadswim-plot separation negative.jsonl --method all
notes_have 'Lines break where the velocity is not positive'

# --- relative to a method: at the same abscissa, in percent
for x in 3000 1000 4800; do
  swept period $x '.velocity = $x * (if .method == "multipole-ode" then 1.5 else 1 end)'
done >by_period.jsonl
accepts beadswim-plot velocity-against-period by_period.jsonl --method multipole-ode --relative-to oseen-force-closed
out_has '>Swimming velocity relative to oseen-force-closed, against driving period<'
out_has '>difference in velocity \(%\)<'
out_has '>50<'     # the level of the line: a tick of it
check 'the line is not level' test "$(series '#0072B2' | cut -d, -f2 | sort -u | wc -l)" -eq 1
has_numbers 4 velocity-against-period by_period.jsonl run.json --relative-to oseen-force-closed
refuses 'run_shorter_period.json: there is no prediction by oseen-force-closed at period = 2000' \
  beadswim-plot velocity-against-period by_period.jsonl run_shorter_period.json --relative-to oseen-force-closed
refuses 'the predicted velocity differs from the velocity in prediction.json, although both predictions are by multipole-ode' \
  beadswim-plot velocity-against-period prediction.json by_period.jsonl --relative-to multipole-ode
accepts beadswim-plot separation by_separation.jsonl --relative-to oseen-force-closed
refuses 'run.json: the file is a run record, and with --relative-to run records can be drawn only with --against period' \
  beadswim-plot separation by_separation.jsonl run.json --relative-to oseen-force-closed

# --- a map of what no document states
swept period 3000 . | jq -c '.study = {period: 3000, phase: 1}' >study.jsonl
refuses 'figure: there is no point with a finite value of "smallest gap of an arm" to draw' \
  beadswim-plot against study.jsonl --x period --y phase --colour gap

# --- stroke against the driving
for x in 2 0.5 1; do swept amplitude_ratio $x '.arm_amplitudes = [2 * $x, 5]'; done >by_ratio.jsonl
accepts beadswim-plot stroke --against amplitude-ratio by_ratio.jsonl --method multipole-ode,oseen-force-closed
well_formed out
out_has '>d₁, multipole-ode<'
out_has '>ratio of the driving amplitudes, A/B<'
check 'd1 is not proportional to A/B' straight < <(series '#0072B2')
for x in -3.14 0 1.57; do swept phase $x '.sin_phase_shift = 0.3 * $x'; done >by_phase.jsonl
accepts beadswim-plot stroke --against phase by_phase.jsonl
out_has '>phase of the driving, α \(rad\)<'
check 'the sine is not proportional to the phase' straight < <(series '#009E73')
refuses 'run.json: the run record lacks the phase of the driving, α, the abscissa of the figure; leave the run out' \
  beadswim-plot stroke --against phase by_phase.jsonl run.json
refuses 'line 1: the prediction by multipole-ode lacks the setting "amplitude_ratio".*left out where B = 0' \
  beadswim-plot stroke --against amplitude-ratio by_phase.jsonl

# --- files
accepts beadswim-plot stroke run.json prediction.json -o figure.svg
out_empty
same_bytes 'cat figure.svg' 'beadswim-plot stroke run.json prediction.json'
accepts beadswim-plot stroke run.json prediction.json -o figure.png
check 'figure.png is no PNG' test "$(head -c 8 figure.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a
run env PATH=/nowhere "$(command -v beadswim-plot)" stroke run.json prediction.json -o other.png
has_status 2
err_has '^beadswim-plot: other.png: .*install the package librsvg2-bin'
check 'a refused figure left a file behind' test ! -e other.png
refuses '/no/such/folder/x.svg: the file cannot be created' beadswim-plot stroke run.json -o /no/such/folder/x.svg
refuses '--output: the file name "x.gif" does not end in .svg, .png or .pdf' beadswim-plot stroke run.json -o x.gif
accepts beadswim-plot stroke run.json -o x.pdf --data x.csv
beadswim-layout swimmer --preset paper-single --radius 4,5,6 --arm 20,24 --box 100,50,50 --boundary periodic >drawn.json
accepts beadswim-plot swarm drawn.json --repeat 1,2,1 -o drawn.svg --data drawn.csv
check 'the beads of a picture and of its copies' cmp drawn.csv <(echo swimmer,bead,x,y,z,radius,unit
  for y in 0 50; do jq -r --argjson copy $y '.swimmers[0].position as $p |
    [[1, -20, 4], [2, 0, 5], [3, 24, 6]][] | "0,\(.[0]),\($p[0] + .[1]),\($p[1] + $copy),\($p[2]),\(.[2]),\"lattice units\""' drawn.json; done)
beadswim-layout swimmer --preset paper-single --half-space z --position=100,-50,30 >over.json
accepts beadswim-plot swarm over.json -o drawn.svg --data over.csv
check 'places over a wall are those of the layout' test "$(sed -n 3p over.csv)" = '0,2,100,-50,30,4,"lattice units"'
accepts beadswim-plot swimmer drawn.json -o drawn.svg --data drawn.csv
check 'the beads of a sketch' cmp drawn.csv <(printf '%s\n' bead,x,radius,unit '1,0,4,"lattice units"' '2,20,5,"lattice units"' '3,44,6,"lattice units"')
check 'a PDF file' test "$(head -c 5 x.pdf)" = %PDF-
check 'the numbers drawn' grep -qE '^"arm amplitude[^"]*","[^"]*","cycle[^"]*","","[^"]+",1,[0-9.]+,$' x.csv
refuses '--data: the file name "x.svg" does not end in .csv' beadswim-plot stroke run.json -o x.svg --data x.svg
refuses '--data: figure and data have the same file name' beadswim-plot stroke run.json -o - --data -

# --- speed against error: rms of errors and median of costs of runs at one resolution, joined by setting
scaled() { # FACTOR CELLS SECONDS [JQ]   the run with a stroke and velocity so many times as large, and that cost
  jq -c --argjson f "$1" --argjson cells "$2" --argjson seconds "$3" '
    .swimmers[].cycles[] |= (.velocity |= map(. * $f) | .mean_flow |= map(. * $f) | .speed_along_axis *= $f
      | .arm_amplitudes |= map(. * $f))
    | .resolution.cells_per_radius = $cells | .cost.core_seconds = $seconds'" ${4:-}" run.json
}
{ scaled 1.03 2 10; scaled 0.96 2 30; scaled 1.01 2 20; scaled 1.01 4 100; } >several.jsonl
{ scaled "$(jq -n '1 + ((9 + 16 + 1) / 30000 | sqrt)')" 2 20; scaled 0.99 4 100; } >one_each.jsonl
accepts beadswim-plot speed-against-error several.jsonl --reference run.json
well_formed out
out_has '>error of the velocity \(%\)<'
out_has '>cli, τ = 1.5, double<'
notes_have 'relative to the reference \(lbm, cli, 4 cells per radius\)'
notes_have 'Lines join runs with 2 to 4 cells per radius'
same_bytes 'beadswim-plot speed-against-error several.jsonl --reference run.json' \
  'beadswim-plot speed-against-error one_each.jsonl --reference run.json'
{ cat several.jsonl; scaled 1.02 2 5 '| .resolution.precision = "single"'; } >two_settings.jsonl
accepts beadswim-plot speed-against-error two_settings.jsonl --reference prediction.json
out_has '>cli, τ = 1.5, single<'
notes_have 'relative to the reference \(multipole-ode\)'
accepts beadswim-plot speed-against-error two_settings.jsonl --reference run.json   # 2 cells, double: slower and worse
notes_have 'Most accurate velocity: cli, τ = 1.5, double, 4 cells'
check 'the front is not 2 cells, single, and 4 cells, double' \
  cmp -s <(series '#000000') <(series '#D55E00' && series '#0072B2' | tail -1)
check "a run has no uncertainty" bash -c '! grep -q uncertainty out'
refuses '--reference: no reference is given' beadswim-plot speed-against-error several.jsonl
refuses 'several.jsonl: the file contains several runs or predictions' \
  beadswim-plot speed-against-error several.jsonl --reference several.jsonl
refuses 'this figure draws only run records; name run records as files, and a prediction with --reference' \
  beadswim-plot speed-against-error run.json prediction.json --reference prediction.json
accepts beadswim-plot speed-against-error several.jsonl --reference prediction.json --method rpy-perturbation
notes_have 'relative to the reference \(rpy-perturbation\)'
jq '.predictions |= map(select(.method == "rpy-perturbation") | .uncertainty = 0.1)' prediction.json >uncertain.json
accepts beadswim-plot speed-against-error several.jsonl --reference uncertain.json
out_has '>uncertainty of the reference<'
run beadswim-plot speed-against-error several.jsonl --reference uncertain.json --quantity velocity -o x.svg --data -
check 'the uncertainty is no level in percent' test "$(grep '"uncertainty of the reference"' out | awk -F, '{ print $(NF - 1) }' | xargs)" = '10 10'
# Errors below the uncertainty of the reference are not ranked: the cheapest of them counts.
jq '.predictions[].velocity = 6.9e-05' uncertain.json >as_uncertain.json
{ scaled 1.01 2 20; scaled 1.005 4 100; scaled 1.3 1 10; } >ranked.jsonl
accepts beadswim-plot speed-against-error ranked.jsonl --reference as_uncertain.json --quantity velocity
notes_have 'Cheapest within the uncertainty of the reference, velocity: cli, τ = 1.5, double, 2 cells'
check 'the front goes on to 4 cells' test "$(series '#000000' | wc -l)" -eq 2
# An error of 0 has no place on a logarithmic axis, and is counted.
{ cat several.jsonl; scaled 1 3 50; } >exact.jsonl
accepts beadswim-plot speed-against-error exact.jsonl --reference run.json --quantity velocity
notes_have 'Most accurate velocity: cli, τ = 1.5, double, 4 cells; not drawn for lack of an error: 1'
refuses 'prediction.json: the file contains several runs or predictions' \
  beadswim-plot speed-against-error run.json --reference prediction.json --method all
refuses 'prediction_shorter_period.json: the scene differs from the scene of run.json: period 2000 instead of 4800' \
  beadswim-plot speed-against-error run.json --reference prediction_shorter_period.json
refuses 'the scene differs from the scene of .*: period 4800 instead of 2000' \
  beadswim-plot speed-against-error run.json run_shorter_period.json --reference prediction.json
refuses 'run.json: the run has an error of 0 in the velocity.*leave this file out if it is the reference itself' \
  beadswim-plot speed-against-error run.json --reference run.json
{ cat several.jsonl; scaled 1.02 2 5 '| .resolution.density_on_lattice = 2'; } >corrections.jsonl
refuses 'corrections.jsonl line 5: this run differs from .* line 1 only in --radius-correction or --delay-correction' \
  beadswim-plot speed-against-error corrections.jsonl --reference run.json
# Swimmers without arms have no error of arm amplitudes.
jq '.swimmers[].cycles[] |= (.arm_amplitudes = [] | .arm_phases = [] | .arm_means = [])' run.json >sphere.json
jq '.swimmers[].cycles[].velocity[0] *= 1.1' sphere.json >faster.json
accepts beadswim-plot speed-against-error sphere.json --reference faster.json
out_has '>error of the velocity \(%\)<'
refuses '--quantity: the swimmers have no arms, and so no arm amplitudes; leave the flag out' \
  beadswim-plot speed-against-error sphere.json --reference faster.json --quantity arm_amplitudes
# A prediction is for one swimmer.
jq '.swimmers += [.swimmers[0] | .id = 1 | .cycles[].velocity[0] *= 2]' run.json >two_swimmers.json
same_bytes 'beadswim-plot speed-against-error run.json --reference prediction.json' \
  'beadswim-plot speed-against-error two_swimmers.json --reference prediction.json'
# --- several scenes: runs belong to the reference of their box; each scene has a panel, all have one legend
jq -c '.domain.lengths[0] += 8' several.jsonl >longer_runs.jsonl
jq '.domain.lengths[0] += 8' run.json >longer.json
accepts beadswim-plot speed-against-error several.jsonl longer_runs.jsonl --reference run.json,longer.json --quantity velocity
well_formed out
out_has '>1 swimmer, box [0-9]+ x [0-9]+ x [0-9]+<'
check 'there is not one legend' test "$(grep -c '>cli, τ = 1.5, double<' out)" -eq 1
check 'a setting differs between scenes' test "$(grep '<polyline.*stroke-width="1.80"' out | grep -oE 'stroke="#[0-9A-F]+"' | sort -u | wc -l)" -eq 1
run beadswim-plot speed-against-error several.jsonl longer_runs.jsonl --reference run.json,longer.json --quantity velocity -o x.svg --data -
errors_of() { grep "box $1 x.*cli" out | awk -F, '{ print $(NF - 1) }'; }   # the cost per period depends on the box
check "a scene has the errors relative to its own reference" test "$(errors_of 120)" = "$(errors_of 128)"
check "these are the errors of two resolutions" test "$(errors_of 128 | wc -l)" -eq 2
jq '.domain.lengths[0] += 16' run.json >longest.json
jq -c '.domain.lengths[0] += 16' several.jsonl >longest_runs.jsonl
refuses 'longer_runs.jsonl line 1: the scene of this run is that of no reference; add its reference' \
  beadswim-plot speed-against-error several.jsonl longer_runs.jsonl longest_runs.jsonl --reference run.json,longest.json
refuses 'several.jsonl line 1: two references have the scene' beadswim-plot speed-against-error several.jsonl --reference run.json,run.json
refuses 'longer.json: no run has the scene of this reference' \
  beadswim-plot speed-against-error several.jsonl --reference run.json,longer.json
refuses 'uncertain.json: with several references, each must be a run record' \
  beadswim-plot speed-against-error several.jsonl --reference run.json,uncertain.json
# Records that contain their scene: all of it is compared, but for translations that change nothing.
head -2 "$BEADSWIM_SOURCE/docs/results/speed-against-error/swimmer.jsonl" >staged.jsonl
head -1 staged.jsonl | jq -c '.swimmers[].cycles[].velocity[0] *= 1.1' >stage.json
edited_stage() { jq -c "$1" stage.json >edited.json; }
edited_stage '.scene.swimmers[0].position[0] += 0.5'
accepts beadswim-plot speed-against-error staged.jsonl --reference edited.json --quantity velocity
edited_stage '.scene.swimmers[0].axis = [-1, 0, 0]'
refuses 'edited.json: the scene differs from the scene of staged.jsonl line 1: placing swimmer 0 with axis' \
  beadswim-plot speed-against-error staged.jsonl --reference edited.json
edited_stage '.scene.types[].beads[].radius = 5'
refuses 'edited.json: the scene differs from the scene of staged.jsonl line 1: radius 5 instead of 4' \
  beadswim-plot speed-against-error staged.jsonl --reference edited.json
edited_stage '.scene.domain.lengths[1] += 1'
refuses 'edited.json: the scene differs from the scene of staged.jsonl line 1: domain 60 x 41 x 40' \
  beadswim-plot speed-against-error staged.jsonl --reference edited.json
edited_stage 'del(.scene) | .swimmers[].cycles[] |= (.arm_amplitudes += [1] | .arm_phases += [1] | .arm_means += [20])'
refuses 'staged.jsonl line 1: swimmer 0 has 2 arms, but 3 in the reference' beadswim-plot speed-against-error staged.jsonl --reference edited.json
jq -c 'select(.model == "rpy")' "$BEADSWIM_SOURCE/docs/results/speed-against-error/swimmer.jsonl" >mobility.json
accepts beadswim-plot separation mobility.json   # the bead radius is that of the scene
# The cost is per base period that the run has completed, also of a part of a cycle.
csv_cost() { jq -c ".cost.cycles = $1 | .cost.core_seconds = 12" stage.json >costed.json
  run beadswim-plot speed-against-error costed.json --reference staged.json --quantity velocity -o x.svg --data - && awk -F, 'END { print $(NF - 2) }' out; }
head -1 staged.jsonl >staged.json
check 'costs per cycle' test "$(csv_cost 1.5) $(csv_cost 3)" = '8 4'
refuses '--quantity: is for run records' beadswim-plot speed-against-error cheap.verdict.json --quantity velocity

jq 'del(.cost)' run.json >free.json
refuses 'free.json: the run record does not contain the cost of the run, for example because the run had the flag --no-provenance; leave this file out' beadswim-plot speed-against-error free.json --reference run.json
refuses 'si.json: the units of the reference differ from the units of run.json' beadswim-plot speed-against-error run.json --reference si.json
refuses '--reference: the command "stroke" does not have this flag; only these commands have the flag: speed-against-error; remove the flag' beadswim-plot stroke run.json --reference run.json

# --- verdicts: a point each, its error as the verdict has it, of arms the root mean square
verdict_of() { # VELOCITY ARM1 ARM2 SECONDS   relative errors, by multipole-ode; those by another method are ten times as large
  jq -nc --argjson e "[$1, $2, $3]" --argjson seconds "$4" '
    def row($q; $e; $m): {quantity: $q, run_file: "run.json", swimmer: 0, run: 1, reference_file: "prediction.json",
      reference: 1, method: $m, usable: true, relative_error: $e, tolerance: 0.05, pass: false, decides: ($m == "multipole-ode")};
    {schema: "beadswim/verdict/1", pass: false, decided_by: "multipole-ode",
     cost: {wall_seconds: 1, core_seconds: $seconds, cell_updates: 1},
     rows: ([{m: "multipole-ode", f: 1}, {m: "oseen-force-closed", f: 10}] | map(
       row("velocity"; $e[0] * .f; .m), row("arm_amplitudes"; $e[1] * .f; .m) + {arm: 1},
       row("arm_amplitudes"; $e[2] * .f; .m) + {arm: 2}))}'
}
verdict_of -0.1 0.03 -0.04 10 >cheap.verdict.json
verdict_of 0.01 0.003 0.004 1000 >dear.verdict.json
accepts beadswim-plot speed-against-error cheap.verdict.json dear.verdict.json
well_formed out
out_has '>core-seconds \(s\)<'
notes_have 'Marks are verdicts: root mean square of errors relative to multipole-ode'
notes_have 'Most accurate arm amplitudes: dear.verdict.json'
cat cheap.verdict.json dear.verdict.json >both.jsonl
accepts beadswim-plot speed-against-error both.jsonl
out_has '>both.jsonl line 2<'
positions() { grep -oE 'c[xy]="[0-9.]+"|text-anchor="end">[^<]*' <(beadswim-plot speed-against-error "$@"); }
export -f positions verdict_of
# Ten times the error by the other method, and as large an error of one arm as the root mean square of two.
verdict_of 1 "$(jq -n '(9 + 16) / 2 | sqrt / 10')" "$(jq -n '(9 + 16) / 2 | sqrt / 10')" 10 >other.verdict.json
verdict_of 0.1 0.03 0.04 1000 >dear_other.verdict.json
same_bytes 'positions cheap.verdict.json dear.verdict.json --method oseen-force-closed' \
  'positions other.verdict.json dear_other.verdict.json'
refuses '--method: the verdict cheap.verdict.json has no method "oseen-force"; did you mean "oseen-force-closed"' \
  beadswim-plot speed-against-error cheap.verdict.json --method oseen-force
refuses '--method: 2 methods are given; name the one' beadswim-plot speed-against-error cheap.verdict.json --method a,b
refuses '--cycle: each verdict already states which cycle was compared' beadswim-plot speed-against-error cheap.verdict.json --cycle 2
jq '.cost = null' cheap.verdict.json >free.verdict.json
refuses 'free.verdict.json: the verdict does not contain the costs of the runs, for example because a run had the flag --no-provenance; leave this file out' beadswim-plot speed-against-error free.verdict.json
refuses '--reference: no reference is given; .* errors of run.json' beadswim-plot speed-against-error cheap.verdict.json run.json
refuses 'prediction.json: the document has the schema "beadswim/prediction/1"; give verdicts' beadswim-plot speed-against-error prediction.json
refuses 'cheap.verdict.json: the document is a verdict; verdicts are drawn only by beadswim-plot speed-against-error, without --reference; leave this file out' \
  beadswim-plot speed-against-error cheap.verdict.json --reference run.json
jq '.rows |= map(.quantity = "sin_phase_shift" | del(.arm))' cheap.verdict.json >phases.verdict.json
refuses 'phases.verdict.json: the verdict compares neither velocity nor arm_amplitudes' beadswim-plot speed-against-error phases.verdict.json
jq '.rows[0].relative_error = null' cheap.verdict.json >infinite.verdict.json
refuses 'infinite.verdict.json: the run has an error of inf in the velocity' beadswim-plot speed-against-error infinite.verdict.json

# --- the figures and tables of docs/resolution.md and docs/speed-against-error.md are those of the records
results=$BEADSWIM_SOURCE/docs/results
jq -c 'select(.resolution.density_on_lattice != 1)' "$results/resolution.jsonl" >corrected.jsonl
same_bytes "beadswim-plot speed-against-error corrected.jsonl --reference $results/resolution-reference.json" \
  "cat $BEADSWIM_SOURCE/docs/images/speed-against-error.svg"
records=$results/speed-against-error
references=$records/swimmer-reference.json,$records/nine-reference.json,$records/many-reference.json
for picture in velocity arm_amplitudes; do
  same_bytes "beadswim-plot speed-against-error $records/{swimmer,nine,many}.jsonl --reference $references --quantity $picture" \
    "cat $BEADSWIM_SOURCE/docs/images/speed-against-error-$picture.svg"
done
same_bytes "beadswim-plot speed-against-error $records/cell.jsonl --reference $records/cell-reference.json" \
  "cat $BEADSWIM_SOURCE/docs/images/speed-against-error-cell.svg"
same_bytes "jq -sc -f $results/extrapolated-record.jq $records/cell-reference.jsonl" "cat $records/cell-reference.json"
same_bytes "$results/speed-against-error-tables.sh $records 3 | grep '^|'" \
  "sed -n '/^## What to use/,/^## Results/p; /^## Runs with/,\$p' $BEADSWIM_SOURCE/docs/speed-against-error.md | grep '^|'"
same_bytes "jq -rs -L $results --slurpfile reference $results/resolution-reference.json -f $results/resolution.jq $results/resolution.jsonl" \
  "sed -n '/^| bead boundary/,/^$/p' $BEADSWIM_SOURCE/docs/resolution.md | grep '^|'"

# --- notes of figures with many runs, predictions and methods: at most 60 words, below the drawing, inside the page
many() { # DOCUMENT JQ   40 documents, one per line; the edit knows their number as $i
  jq -c "range(40) as \$i | $2" "$1"
}
# Runs differ in every setting that the notes state.
many run.json '.driving = {period: (1000 + 100 * $i), amplitude: [(0.2 + $i / 50), 0.3], phase: (0.1 * $i)}
  | .resolution.cells_per_radius = 2 + $i / 10 | .resolution.relaxation_time = 0.6 + $i / 20
  | .resolution.bead_boundary = ["cli", "mr", "psm", "staircase"][$i % 4] | .resolution.precision = ["single", "double"][$i % 2]
  | .domain.lengths[0] += $i | .dimensionless.reynolds_bead *= 1 + $i
  | .dimensionless.penetration_depth_over_radius *= 1 + $i' >many_runs.jsonl
many prediction.json '(.predictions[].settings) |= (. + {period: (1000 + 100 * $i), separation_ratio: (4 + $i / 10), amplitude: (0.2 + $i / 50),
    amplitude_ratio: (0.5 + $i / 20), phase: (0.1 * $i), fluid: (if $i % 2 == 0 then "unbounded" else "box: 80 x 48 x 48" end)})
  | .predictions[].velocity *= 1 - $i / 20' >many_predictions.jsonl
for figure in 'stroke' 'stroke --against amplitude-ratio' 'velocity-against-period' 'separation --axes log-log'; do
  accepts beadswim-plot $figure many_runs.jsonl many_predictions.jsonl --method all
  notes_have '[Mm]arks .* line agree with .* prediction'
  notes_have 'Re = 0\.15 to '
done
accepts beadswim-plot velocity-against-period many_predictions.jsonl --method all --relative-to oseen-force-closed
notes_have 'Marks and lines at 0 % agree with oseen-force-closed'
many several.jsonl '.resolution.relaxation_time = 0.6 + $i / 20 | .resolution.precision = ["single", "double"][$i % 2]' >many_settings.jsonl
accepts beadswim-plot speed-against-error many_settings.jsonl --reference uncertain.json
notes_have 'On the front, no other run is both cheaper and more accurate'
for i in $(seq 30); do
  jq --arg name "method-$i" --argjson i "$i" '.decided_by = $name | .rows |= map(.method = $name) | .cost.core_seconds += $i' \
    cheap.verdict.json >"a verdict with a long name $i.json"
done
accepts beadswim-plot speed-against-error a\ verdict*.json
notes_have 'relative to 30 methods'
jq '.mobility_products |= map(.tolerance *= 10)' "$BEADSWIM_SOURCE/docs/results/mobility-products.json" >rough.json
jq '.processor = "a processor with a name of many words"' rough.json >other_processor.json
accepts beadswim-plot mobility-products "$BEADSWIM_SOURCE/docs/results/mobility-products.json" rough.json other_processor.json
notes_have '2 processors; tolerance 0.0001 to 0.001'
# The figures of the pages have such notes.
for figure in "$BEADSWIM_SOURCE"/docs/images/*.svg; do
  cp "$figure" out
  command_line=$figure
  notes_have .
done

# --- what it refuses
refuses 'a command is needed: stroke, velocity-against-period, against, separation, speed-against-error' beadswim-plot
refuses 'strok: unknown command; did you mean "stroke"' beadswim-plot strok run.json
refuses '^beadswim-plot: run.json: unknown command. One of these must come first: stroke, velocity-against-period' beadswim-plot run.json -o x.svg
refuses '^beadswim-plot: strok: unknown command; did you mean "stroke"' beadswim-plot strok run.json --method all
refuses '--method: the flag is in the wrong place; write the flag after "beadswim-plot stroke"' beadswim-plot --method all stroke run.json
refuses '--metod: unknown flag; did you mean --method' beadswim-plot stroke run.json --metod all
refuses 'no file is given' beadswim-plot stroke
refuses 'no run with a complete cycle' beadswim-plot stroke prediction.json
refuses 'the units of this file differ from the units of ' beadswim-plot stroke si.json run.json
refuses '--method: no prediction has the method "multipol"; did you mean "multipole-ode"' \
  beadswim-plot stroke run.json prediction.json --method multipol
refuses '--method: no prediction has the method "foo"\. The predictions have the methods rpy-force-printed, oseen' \
  beadswim-plot stroke run.json prediction.json --method foo
refuses '--method: the method "foo" names the predictions to draw, but no file of predictions is given' beadswim-plot stroke run.json --method foo
refuses '--relative-to: no prediction has the method "multipol"; did you mean "multipole-ode"' \
  beadswim-plot velocity-against-period prediction.json --relative-to multipol
refuses '--against: unknown value "phas"; did you mean "phase"' beadswim-plot stroke prediction.json --against phas
jq 'del(.predictions[].settings.period)' prediction.json >timeless.json
refuses 'timeless.json: the prediction by multipole-ode lacks the setting "period"' beadswim-plot velocity-against-period timeless.json
refuses 'prediction.json: .* lacks the setting "separation_ratio"' beadswim-plot separation prediction.json
(cat by_period.jsonl && echo && echo '{ "schema": ') >cut.jsonl
refuses 'cut.jsonl line 5: line 1, column' beadswim-plot velocity-against-period cut.jsonl
(head -1 by_period.jsonl && jq -c '.swimmer = "x"' prediction.json) >typo.jsonl
refuses 'typo.jsonl line 2:/swimmer: ' beadswim-plot velocity-against-period typo.jsonl
refuses 'standard input line 2:/swimmer: ' beadswim-plot velocity-against-period - < <(cat typo.jsonl)
echo '{ "schema": "beadswim/layout/1" }' >layout.json
refuses 'layout.json: the document has the schema "beadswim/layout/1"; a run record .* or a prediction' beadswim-plot stroke layout.json
: >empty.json
refuses 'empty.json: the input is empty' beadswim-plot stroke empty.json
refuses 'standard input can be read only once' beadswim-plot stroke - -

# --- series of swimmers and types, and names of what varies
jq -c '.swimmers += [(.swimmers[0] | .id = 1 | .cycles[].velocity[0] *= 2), (.swimmers[0] | .id = 2)] | .units = {length: {name: "um", si_factor: 1e-6}, time: {name: "s", si_factor: 1}, mass: {name: "pg", si_factor: 1e-15}}
  | .study = {"/types/a/driving/period": (4800, 2400)}' run.json >three.jsonl
drawn_against() { beadswim-plot against --y speed_along_axis "$@" -o x.svg --data - | sed 1d; } # ARGUMENTS...   the lines of the numbers
check 'a series per swimmer' test "$(drawn_against three.jsonl --x /types/a/driving/period --group-by swimmer | cut -d, -f1-8 | sort | head -2)" = \
  '"speed along the axis","um/s","period","s","lbm, swimmer = 0",2400,7.25e-05
"speed along the axis","um/s","period","s","lbm, swimmer = 0",4800,7.25e-05'
check 'six points' test "$(drawn_against three.jsonl --x /types/a/driving/period --group-by swimmer | wc -l)" -eq 6
check 'the axis has a name' bash -c "grep -q '>period (s)<' x.svg && ! grep -q '/types' x.svg"
refuses 'three.jsonl line 1: the document does not state the types' beadswim-plot against three.jsonl --x /types/a/driving/period --group-by type
jq -c --slurpfile layout drawn.json '.scene = ($layout[0] | {fluid, domain, types, swimmers}) | .scene.types.b = (.scene.types | to_entries[0].value)
  | .scene.swimmers = ([0, 1, 2] as $ids | [$ids[] as $id | $layout[0].swimmers[0] | .id = $id | .position[1] = 10 + 15 * $id]) | .scene.swimmers[2].type = "b"' three.jsonl >typed.jsonl
type=$(jq -r '.swimmers[0].type' drawn.json)
check 'a mean per type' test "$(drawn_against typed.jsonl --x /types/a/driving/period --group-by type | grep ,4800, | cut -d, -f5-8 | tr '\n' ' ')" = \
  "\"lbm, type = $type\",4800,0.00010875 \"lbm, type = b\",4800,7.25e-05 "
beadswim-plot against typed.jsonl --x /types/a/driving/period --group-by type >out
notes_have 'Marks are means over the swimmers of a type in a run'
accepts beadswim-plot against three.jsonl --x /types/a/driving/period --x-label 'period T [s]' -o x.svg --data x.csv
check 'a label' bash -c "grep -q '>period T \[s\]<' x.svg && grep -q '\"period T \[s\]\",\"\",' x.csv"
while IFS=: read -r pointer name; do
  sed "s,/types/a/driving/period,$pointer," three.jsonl >named.jsonl
  check "$pointer is not $name" test "$(drawn_against named.jsonl --x "$pointer" | head -1 | cut -d'"' -f6,8)" = "$name"
done <<'END'
/types/a/beads/1/radius:radius, bead 2"um
/types/a/springs/0/stiffness:stiffness, spring 1"pg/s²
/types/a/angles/1/stiffness:stiffness, angle 2"pg um²/s²
/types/a/driving/amplitude/1:amplitude B"pg um/s²
/types/a/driving/bonds/0/rest_length/0/amplitude:amplitude, bond 1"um
/swimmers/3/position/2:position z, /swimmers/3"um
/swimmers/3/rotate/z:rotation about z, /swimmers/3"rad
/flow/velocity_gradient/0/2:velocity gradient xz"1/s
/fluid/kinematic_viscosity:kinematic viscosity"um²/s
/types/a/beads/0/density:density, bead 1"pg/um³
/types/a/net_force:/types/a/net_force"
stiffness:stiffness"pg/s²
END

# What products of a mobility cost: the page's figure.
same_bytes "beadswim-plot mobility-products $BEADSWIM_SOURCE/docs/results/mobility-products.json -o -" \
  "cat $BEADSWIM_SOURCE/docs/images/mobility-products.svg"
refuses 'the document has no key "mobility_products"; make a document with' beadswim-plot mobility-products "$BEADSWIM_SOURCE/docs/results/bench.json"
refuses 'run.h5md: the file cannot be read' beadswim-plot stroke run.h5md

finish
