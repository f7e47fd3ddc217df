# Errors of run records in percent, as the tables of docs/ print them.
def mean: add / length;
def spread: mean as $m | (map(. - $m | . * .) | add) / (length - 1) | sqrt;  # standard deviation of single values, not of their mean
def median: sort | (.[(length - 1) / 2 | floor] + .[length / 2 | floor]) / 2;
def two_digits: . * 100 | round | "\(. / 100 | floor).\("0\(. % 100)" | .[-2:])";
def percent: (if . < 0 then "-" else "+" end) + (100 * fabs | two_digits);
def percent_and_spread: "\(mean | percent)" + (if length > 1 then " ± \(100 * spread | two_digits)" else "" end);

# Returns results of a run: velocity relative to the mean flow, arm amplitudes, sine of the phase shift, core-seconds per cycle.
def seen: .swimmers[0].cycles[-1] as $c | {
  v: ($c.velocity[0] - ($c.mean_flow[0] // 0)), d1: $c.arm_amplitudes[0], d2: $c.arm_amplitudes[1],
  sine: ($c.arm_phases[0] - $c.arm_phases[1] | sin), cost: (.cost.core_seconds / $c.index) };
