# Prints the tables of docs/figure-3.md from lines of figure-3-tables.sh.
def rounded($places): . * pow(10; $places) | round / pow(10; $places) + 0;
def signed($places): rounded($places) | if . > 0 then "+\(.)" elif . == 0 then "0" else tostring end;
def percent: if . == null then "" else . * 100 | signed(1) end;
def digits($n): if . == 0 then "0" else (fabs | log10 | floor) as $e | ($n - 1 - $e) as $places
  | rounded($places) | tostring end;
def small: . * 1e5 | rounded(3) | tostring;   # prints a velocity in units of 1e-5

# Velocity, arm amplitudes and sine of the phase shift: of a run (seen: mean over the last cycles, velocity relative to the mean
# flow) and of a prediction (foreseen).
def mean(f): map(f) | add / length;
def seen($cycles): .swimmers[0].cycles[-$cycles:] | {
  v: mean(.speed_along_axis - (.mean_flow[0] * .axis[0] + .mean_flow[1] * .axis[1] + .mean_flow[2] * .axis[2])),
  d1: mean(.arm_amplitudes[0]), d2: mean(.arm_amplitudes[1]), sine: mean(.arm_phases[0] - .arm_phases[1] | sin)};
def seen: seen(2);
def foreseen: {v: .velocity, d1: .arm_amplitudes[0], d2: .arm_amplitudes[1], sine: .sin_phase_shift};
def off($run; $theory; $what): ($run[$what] / $theory[$what]) - 1;
def box: .run.domain.lengths | map(tostring) | join(" x ");
def seconds: .run | .cost.core_seconds / .swimmers[0].cycles[-1].index;  # per cycle
def setting: {fine: "`mr`, 4 cells", staircase: "`staircase`, 4 cells", three: "`mr`, 3 cells, single", coarse: "`mr`, 2 cells, single"}[.];
def deviations: map("errors with " + setting) | .[0] |= "errors of d1, d2, v relative to `inertia-corrected` [%]" + ltrimstr("errors");
def row: "| " + join(" | ") + " |";
def rule: map("---") | "|" + join("|") + "|";
def table($head): ($head | row, rule), .[];
# d1, d2 and v of a run relative to `inertia-corrected` [%].
def errors: (.run | seen) as $r | (.theory["inertia-corrected"] | foreseen) as $t
  | ["d1", "d2", "v"] | map(off($r; $t; .) | percent) | join(", ");
def uncertainty: .theory["inertia-corrected"].uncertainty | . * 100 | rounded(1) | tostring;
# The runs of all settings at one point of a sweep, one setting per column.
def columns($settings): . as $runs | $settings | map(. as $name | $runs | map(select(.name == $name))[0] | if . then errors else "" end);
def pi: 3.141592653589793;

. as $all
| ["fine", "staircase", "three", "coarse"] as $settings | ["fine", "coarse"] as $sweeps
| def sweep($name): $all | map(select(.sweep == $name));

"\n### Period\n",
(sweep("by-period") | map(select(.run.driving.period != 7000)) | group_by(.run.driving.period)
 | map((.[] | select(.name == "fine")) as $fine
     | [($fine.run.driving.period | tostring)] + columns($settings) + [$fine | uncertainty] | row)
 | table(["period T [step]"] + ($settings | deviations) + ["uncertainty of predicted v [%]"])),
"\nCost at T = 4800, in core-seconds per cycle: " + ($settings | map(. as $name
   | $all | map(select(.name == "cost-" + $name)) | .[0] // empty | "\(seconds | digits(2)) (\($name | setting))") | join(", ")) + ".",

"\n### Amplitude ratio and phase\n",
([(sweep("by-amplitude-ratio") | group_by(.run.driving.amplitude[0])[]
    | {at: (.[0].run.driving.amplitude | .[0] / .[1] | rounded(2)), runs: .} | select(.at != 1 and .at != 1.5) | .at |= "A/B = \(.)"),
   (sweep("by-phase") | group_by(.run.driving.phase)[]
    | {at: (.[0].run.driving.phase / pi | rounded(2)), runs: .} | select(.at == 0.25) | .at |= "α = \(.) π")]
 | map([.at] + (.runs | columns($sweeps) + [.[0] | uncertainty]) | row)
 | table(["driving amplitudes A/B or phase α"] + ($sweeps | deviations) + ["uncertainty of predicted v [%]"])),

"\n### Almost no inertia\n",
($all | map(select(.name == "slow") | (.run | seen(1)) as $r | (.theory["inertia-corrected"] | foreseen) as $t
   | (.theory["multipole-ode"].velocity * .theory["rpy-box-ode"].velocity / .theory["rpy-ode"].velocity) as $exact
   | ["\(.run.resolution.cells_per_radius)", ($r.v / $exact - 1 | percent), (off($r; $t; "v") | percent)] | row)
 | table(["cells per radius", "error of velocity v relative to exact quasi-static theory [%]", "error of v relative to `inertia-corrected` [%]"])),

"\n### Boxes\n",
($all | map(select(.name == "walls" and (.run.domain | .lengths[0] == 60 or .lengths[0] == 600 or (.lengths[0] == 120 and .boundary[0] == "periodic")))
   | (.run | seen) as $r | .theory as $t | $t["inertia-corrected"] as $i
   | ($i.velocity - $i.settings.velocity_by_box) as $open
   | [box, .run.domain.boundary[0], ($r.v / $i.velocity - 1 | percent), ($i.velocity / $open - 1 | percent),
      ($t["rpy-box-ode"].velocity / $t["rpy-ode"].velocity - 1 | percent)] | row)
 | table(["box (bead radius 4)", "boundary", "error of velocity v relative to `inertia-corrected` [%]", "change of v by the box, `inertia-corrected` [%]", "change of v by the box, theory without inertia [%]"])),

"\n### The paper's box\n",
"Runs with `mr`, 4 cells per radius and levels of cells in the free-slip box 1200 x 800 x 800.\n",
($all | map(select(.name == "levels" and (.run.driving.period | IN(4000, 5000, 6000, 7000, 8000, 9000) | not))) | sort_by(.run.driving.period)
 | map((.run | seen) as $r | ["\(.run.driving.period)", "\($r.d1 | digits(4)), \($r.d2 | digits(4)), \($r.sine | rounded(3)), \($r.v | small)",
     errors, uncertainty] | row)
 | table(["period T [step]", "arm amplitudes d1, d2 [cell], sin β, velocity v [1e-5 cell/step]", "errors of d1, d2, v relative to `inertia-corrected` [%]", "uncertainty of predicted v [%]"])),

"\n### Levels of cells\n",
"Free-slip boxes, runs with `mr`, 2 cells per radius and single precision.\n",
($all | map(select(.name == "walls-levels" and (box | IN("160 x 80 x 80", "200 x 120 x 120", "400 x 260 x 260") | not))
   | box as $box | (.run | seen) as $r
   | ([$all[] | select(.name == "walls" and box == $box and .run.domain.boundary[0] == "free-slip")][0]) as $one | ($one | if . then (.run | seen) else null end) as $u
   | [$box, "\(.run.resolution.levels | length)", ($r.v | small),
      (if $u then ["v", "d1", "d2"] | map(($r[.] / $u[.] - 1) * 100 | signed(3)) | join(", ") else "-" end)]
   + [(.run | .cost.core_seconds | digits(2))] | row)
 | table(["box", "levels", "v [1e-5 cell/step]", "change of v, d1, d2 by levels [%]", "core-seconds for three cycles"])),

"\n### Staircase runs and equal weights\n",
"Columns 2 and 3 exclude the effect of the box. \"Equal weights\" is Rotne-Prager theory with equal bead weights. The other columns contain the changes of v that lead from this theory to the `staircase` run.\n",
(sweep("by-period") | map(select(.name == "fine" and .run.driving.period > 4000) | .run.driving.period as $T | .theory as $t
   | ($t["inertia-corrected"] | .settings) as $s | (.run | seen.v) as $mr
   | (sweep("by-period")[] | select(.name == "staircase" and .run.driving.period == $T) | .run | seen.v) as $stairs
   | ($t["inertia-corrected"] | .velocity / (.velocity - .settings.velocity_by_box)) as $box
   | $t["rpy-equal-weight"].velocity as $start
   | ($s.velocity_quasi_static + $s.velocity_by_stroke + $s.velocity_by_drift + $s.velocity_by_reynolds_stress) as $inert
   | [$start, $s.velocity_quasi_static, $inert, $inert + $s.velocity_by_amplitude, $t["inertia-corrected"].velocity, $mr, $stairs] as $steps
   | ["\($T)"] + [$t["oseen-force-closed"].velocity, $start | $stairs / $box / . - 1 | percent]
     + [range(1; 7) as $n | $steps[$n] / $steps[$n - 1] - 1 | percent] | row)
 | table(["period T [step]", "v of `staircase` run relative to equation (4.3) [%]", "relative to equal weights [%]", "change of v [%] by exact flow", "by inertia", "by finite amplitude", "by the box", "by the lattice (`mr`)", "by `staircase` instead of `mr`"]))
