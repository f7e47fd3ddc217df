# Extrapolates run records of one scene to zero cell size, and prints a run record:  jq -s -f extrapolated-record.jq RECORDS
# Each bead boundary has two or more records with different cells. Records with equal cells, for beads at different places within
# cells, are averaged. Errors are assumed proportional to the square of the cell size.
# The result is the extrapolation of the coarsest and the finest record; with two bead boundaries it is the mean of both. The
# uncertainty of a swimmer is the largest change to the result from an extrapolation, also of a record in between with the finest,
# or from a finest record, of the velocity along the axis and of both arms.
def numbers: [.velocity, .mean_flow, .arm_amplitudes, .arm_phases, .arm_means, [.speed_along_axis]];
def combined(f): transpose | map(transpose | map(f));
def mean: add / length;
def axial: .speed_along_axis - ([.mean_flow, .axis] | transpose | map(.[0] * .[1]) | add);
def with($n): . + {velocity: $n[0], mean_flow: $n[1], arm_amplitudes: $n[2], arm_phases: $n[3], arm_means: $n[4],
                   speed_along_axis: $n[5][0]};
def by_cells: {resolution: ., wander: null, transient: null, total: ., box: null};
def largest_change(f; $result): [.[] | [[f], [$result | f]] | transpose[] | .[0] / .[1] - 1 | fabs] | max;

# Returns the last cycle of the swimmer with the index $s, extrapolated to zero cell size.
def limit($s; $coarse; $fine): ($fine.resolution.cells_per_radius / $coarse.resolution.cells_per_radius | . * .) as $square
  | [$coarse, $fine | .swimmers[$s].cycles[-1]] as [$c, $f]
  | $f | with([$c, $f | numbers] | combined(.[1] + (.[1] - .[0]) / ($square - 1)));

# Returns the mean of records with equal resolution.
def averaged: . as $records | $records[0] | .swimmers = [range(.swimmers | length) as $s
  | [$records[].swimmers[$s].cycles[-1]] as $cycles
  | $records[0].swimmers[$s] + {cycles: [$cycles[0] | with($cycles | map(numbers) | combined(mean))]}];

(group_by(.resolution.bead_boundary) | map(group_by(.resolution.cells_per_radius) | map(averaged))) as $groups
| ($groups | map(.[-1])) as $fine
| $fine[0]
| .swimmers = [range(.swimmers | length) as $s
    | ($groups | map(limit($s; .[0]; .[-1]))) as $limits
    | [$groups[] | .[-1] as $finest | .[1:-1][] | limit($s; .; $finest)] as $between
    | ($fine[0].swimmers[$s].cycles[-1] | with([$limits[] | numbers] | combined(mean))) as $result
    | ($limits + $between + [$fine[].swimmers[$s].cycles[-1]]) as $others
    | $fine[0].swimmers[$s] + {cycles: [$result],
        uncertainty: {velocity: ($others | largest_change(axial; $result) | by_cells),
                      arm_amplitudes: ($others | largest_change(.arm_amplitudes[]; $result) | by_cells)}}]
| .state_sha256 = null | del(.expected_error, .warnings)
