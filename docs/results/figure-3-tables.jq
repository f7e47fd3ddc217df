# The tables of docs/figure-3.md, from lines of figure-3-tables.sh.
def rounded($places): . * pow(10; $places) | round / pow(10; $places) + 0;
def signed($places): rounded($places) | if . > 0 then "+\(.)" elif . == 0 then "0" else tostring end;
def percent: if . == null then "" else . * 100 | signed(1) end;
def digits($n): if . == 0 then "0" else (fabs | log10 | floor) as $e | ($n - 1 - $e) as $places
  | rounded($places) | tostring end;
def small: . * 1e5 | rounded(3) | tostring;   # a velocity, in 1e-5

# A run's numbers as means over its last cycles, velocity against the mean flow; a prediction's.
def mean(f): map(f) | add / length;
def seen($cycles): .swimmers[0].cycles[-$cycles:] | {
  v: mean(.speed_along_axis - (.mean_flow[0] * .axis[0] + .mean_flow[1] * .axis[1] + .mean_flow[2] * .axis[2])),
  d1: mean(.arm_amplitudes[0]), d2: mean(.arm_amplitudes[1]), sine: mean(.arm_phases[0] - .arm_phases[1] | sin)};
def seen: seen(2);
def foreseen: {v: .velocity, d1: .arm_amplitudes[0], d2: .arm_amplitudes[1], sine: .sin_phase_shift};
def off($run; $theory; $what): ($run[$what] / $theory[$what]) - 1;
def box: .run.domain.lengths | map(tostring) | join(" x ");
def seconds: .run | .cost.core_seconds / .swimmers[0].cycles[-1].index;  # a cycle
def setting: {fine: "mr, 4", staircase: "staircase, 4", three: "mr, 3, single", coarse: "mr, 2, single"}[.name];

. as $all
| def sweep($name): $all | map(select(.sweep == $name));
  def against_exact($first; f):
    .[] | (.run | seen) as $r | (.theory["inertia-corrected"] | foreseen) as $t
    | "| \($first) | \(f) | \($r.d1 | digits(4)), \($r.d2 | digits(4)), \($r.sine | rounded(3)) | \(off($r; $t; "d1") | percent), \(off($r; $t; "d2") | percent), \($r.sine - $t.sine | signed(3)) | \($r.v | small) | "
      + (if ($t.v | fabs) < 1e-9 then "" else off($r; $t; "v") | percent end)
      + " | \(.theory["inertia-corrected"].uncertainty | if . == null or . > 1 then "" else . * 100 | rounded(1) | tostring end) |";

"\n### Against the period\n",
"| beads | T | d1, d2, sin β | against `inertia-corrected`: d1, d2 [%], sin β | v [1e-5] | v against it [%] | its uncertainty [%] |",
"|---|---|---|---|---|---|---|",
(["fine", "staircase", "three", "coarse"][] as $name
 | sweep("by-period") | map(select(.name == $name)) | if . == [] then empty else against_exact(.[0] | setting; .run.driving.period) end),

"\n### Against A/B and α\n",
"| beads | A/B or α/π | d1, d2, sin β | against `inertia-corrected`: d1, d2 [%], sin β | v [1e-5] | v against it [%] | its uncertainty [%] |",
"|---|---|---|---|---|---|---|",
(["fine", "three", "coarse"][] as $name
 | (sweep("by-amplitude-ratio") | map(select(.name == $name)) | if . == [] then empty else against_exact(.[0] | setting; .run.driving.amplitude | "A/B = \(.[0] / .[1] | rounded(2))") end),
   (sweep("by-phase") | map(select(.name == $name)) | if . == [] then empty else against_exact(.[0] | setting; .run.driving.phase / 3.141592653589793 | "α = \(rounded(2)) π") end)),

"\n### Hardly any inertia\n",
"| cells a radius | v [1e-6] | exact, quasi-static, in this box | difference [%] | `inertia-corrected` | difference [%] | d1, d2 against it [%] |",
"|---|---|---|---|---|---|---|",
($all[] | select(.name == "slow") | (.run | seen(1)) as $r | (.theory["inertia-corrected"] | foreseen) as $t
 | (.theory["multipole-ode"].velocity * .theory["rpy-box-ode"].velocity / .theory["rpy-ode"].velocity) as $exact
 | "| \(.run.resolution.cells_per_radius) | \($r.v * 1e6 | rounded(3)) | \($exact * 1e6 | rounded(3)) | \($r.v / $exact - 1 | percent) | \($t.v * 1e6 | rounded(3)) | \(off($r; $t; "v") | percent) | \(off($r; $t; "d1") | percent), \(off($r; $t; "d2") | percent) |"),

"\n### Boxes\n",
($all | map(select(.name == "walls")) | . as $walls
 | "| box | walls | v of the run [1e-5] | `inertia-corrected` | difference [%] | by theory: the box, with inertia [%] | without [%] | cell updates [1e9] |",
   "|---|---|---|---|---|---|---|---|",
   ($walls[] | (.run | seen) as $r | .theory as $t | $t["inertia-corrected"] as $i
    | ($i.velocity - $i.settings.velocity_by_box) as $open
    | "| \(box) | \(.run.domain.boundary[0]) | \($r.v | small) | \($i.velocity | small) | \($r.v / $i.velocity - 1 | percent) | \($i.velocity / $open - 1 | percent) | \($t["rpy-box-ode"].velocity / $t["rpy-ode"].velocity - 1 | percent) | \(.run.cost.cell_updates / 1e9 | digits(2)) |")),

"\n### Cost\n",
"| beads | core s a cycle of 4800 | all of (a), (b): core s | minutes on two cores |",
"|---|---|---|---|",
(["fine", "staircase", "three", "coarse"][] as $name
 | (sweep("by-period") | map(select(.name == $name) | .run.driving.period * .run.swimmers[0].cycles[-1].index) | add) as $steps
 | ($all | map(select(.name == "cost-" + $name)) | .[0]) | select(. != null)
 | "| \({"cost-fine": "mr, 4", "cost-staircase": "staircase, 4", "cost-three": "mr, 3, single", "cost-coarse": "mr, 2, single"}[.name]) | \(seconds | digits(2)) | \(seconds * $steps / 4800 | digits(2)) | \(seconds * $steps / 4800 / 120 | digits(2)) |"),

"\n### What the paper compares\n",
"v of the runs over each theory, less one [%]; the box's part of v, by `inertia-corrected`, is taken out, as the paper's box has\nnone.\n",
"| beads | T | (4.3) | (4.23) repaired | equal weights | Rotne-Prager | exact, second order | exact |",
"|---|---|---|---|---|---|---|---|",
(["fine", "staircase"][] as $name | sweep("by-period")[] | select(.name == $name)
 | (.theory["inertia-corrected"] | .velocity / (.velocity - .settings.velocity_by_box)) as $box | (.run | seen.v / $box) as $v
 | "| \(setting) | \(.run.driving.period) | " + ([.theory[("oseen-force-closed", "rpy-force-repaired", "rpy-equal-weight", "rpy-perturbation", "multipole-perturbation", "multipole-ode")]
   | $v / .velocity - 1 | percent] | join(" | ")) + " |"),

"\n### From the theory of equal weights to the paper's run, step by step\n",
"Each the change of v that it makes to what stands left of it [%].\n",
"| T | truncation and weights | inertia | amplitude | box | mr run over `inertia-corrected` | staircase over mr | together |",
"|---|---|---|---|---|---|---|---|",
(sweep("by-period")[] | select(.name == "fine" and .run.driving.period > 4000) | .run.driving.period as $T | .theory as $t
 | ($t["inertia-corrected"] | .settings) as $s | (.run | seen.v) as $mr
 | (sweep("by-period")[] | select(.name == "staircase" and .run.driving.period == $T) | .run | seen.v) as $stairs
 | $t["rpy-equal-weight"].velocity as $start
 | ($s.velocity_quasi_static + $s.velocity_by_stroke + $s.velocity_by_drift + $s.velocity_by_reynolds_stress) as $inert
 | [$start, $s.velocity_quasi_static, $inert, $inert + $s.velocity_by_amplitude, $t["inertia-corrected"].velocity, $mr, $stairs] as $steps
 | "| \($T) | " + ([range(1; 7) as $n | $steps[$n] / $steps[$n - 1] - 1 | percent] | join(" | ")) + " | \($stairs / $start - 1 | percent) |")
