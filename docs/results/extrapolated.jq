# Extrapolates runs of two bead boundaries, each at two resolutions, to zero cell size, and prints a prediction: jq -s -L docs/results -f extrapolated.jq RUNS
# Errors are assumed proportional to the square of the cell size. The prediction is the mean of both extrapolations. Its
# uncertainty is the largest difference of an extrapolation or a finest run from this mean.
include "percentages";
def numbers: seen as {$v, $sine} | .swimmers[0].cycles[-1]
  | [$v] + .arm_amplitudes + .arm_phases + .arm_means + [$sine];
def to_no_cell: sort_by(.resolution.cells_per_radius) | (map(.resolution.cells_per_radius) | .[-1] / .[-2] | . * .) as $square
  | [map(numbers)[-2:] | transpose[] | .[1] + (.[1] - .[0]) / ($square - 1)];

. as $runs
| (group_by(.resolution.bead_boundary) | map(to_no_cell)) as $limits
| ([$limits | transpose[] | add / length]) as $best
| ($runs | sort_by(.resolution.cells_per_radius) | map(numbers)[-2:]) as $finest
| def spread($i): [($limits + $finest)[] | .[$i] / $best[$i] - 1 | fabs] | max;
{ schema: "beadswim/prediction/1", units: $runs[0].units, swimmer: $runs[0].swimmers[0].id,
  predictions: [{
    method: "extrapolated", usable: true,
    validity: "runs of \($runs | map(.resolution.bead_boundary) | unique | join(" and ")) at \($runs | map(.resolution.cells_per_radius) | unique | map(tostring) | join(" and ")) cells a radius, to no cell",
    velocity: $best[0], uncertainty: spread(0),
    arm_amplitudes: $best[1:3], arm_phases: $best[3:5], sin_phase_shift: $best[7],
    stroke_uncertainty: {arm_amplitudes: [spread(1), spread(2)], sin_phase_shift: (spread(7) * $best[7])},
    arm_means: $best[5:7],
    settings: {mobility: "lattice Boltzmann", fluid: "the layout's box", period: $runs[0].driving.period}}],
  left_out: [], warnings: []}
