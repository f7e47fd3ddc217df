# Extrapolates run records of one scene to zero cell size, and prints a run record:  jq -s -f extrapolated-record.jq RECORDS
# Each bead boundary has two records with different cells. Errors are assumed proportional to the square of the cell size. With two
# bead boundaries the result is the mean of both extrapolations. The uncertainty of a swimmer is the largest change from an
# extrapolation or a finer run to the result, of the velocity along the axis and of both arms.
def numbers: [.velocity, .mean_flow, .arm_amplitudes, .arm_phases, .arm_means, [.speed_along_axis]];
def combined(f): transpose | map(transpose | map(f));
def mean: add / length;
def axial: .speed_along_axis - ([.mean_flow, .axis] | transpose | map(.[0] * .[1]) | add);
def with($n): . + {velocity: $n[0], mean_flow: $n[1], arm_amplitudes: $n[2], arm_phases: $n[3], arm_means: $n[4],
                   speed_along_axis: $n[5][0]};
def by_cells: {resolution: ., wander: null, transient: null, total: ., box: null};
def largest_change(f; $result): [.[] | [[f], [$result | f]] | transpose[] | .[0] / .[1] - 1 | fabs] | max;

(group_by(.resolution.bead_boundary) | map(sort_by(.resolution.cells_per_radius))) as $pairs
| ($pairs | map(.[1])) as $fine
| $fine[0]
| .swimmers = [range(.swimmers | length) as $s
    | $pairs | map((.[1].resolution.cells_per_radius / .[0].resolution.cells_per_radius | . * .) as $square
                   | map(.swimmers[$s].cycles[-1]) | . as [$c, $f]
                   | $f | with([$c, $f | numbers] | combined(.[1] + (.[1] - .[0]) / ($square - 1)))) as $limits
    | ($fine[0].swimmers[$s].cycles[-1] | with([$limits[] | numbers] | combined(mean))) as $result
    | ($limits + [$fine[].swimmers[$s].cycles[-1]]) as $others
    | $fine[0].swimmers[$s] + {cycles: [$result],
        uncertainty: {velocity: ($others | largest_change(axial; $result) | by_cells),
                      arm_amplitudes: ($others | largest_change(.arm_amplitudes[]; $result) | by_cells)}}]
| .state_sha256 = null | del(.expected_error, .warnings)
