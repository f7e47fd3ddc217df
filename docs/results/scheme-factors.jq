# Prints the errors of each bead boundary relative to those of `mr`, the factors of libs/plan/src/model_errors.cpp:
#   jq -rs -L docs/results --slurpfile resolution docs/results/resolution.jsonl -f docs/results/scheme-factors.jq docs/results/scheme-factors.jsonl
# cells: standard deviation of the velocity over places in all directions, from the records of resolution.sh with corrections, at a
# relaxation time of 1.5 in double precision; root mean square of the ratios at 2, 3 and 4 cells per radius.
# wander: standard deviation over places along the axis off the planes of the lattice, from the records of scheme-factors.sh.
include "percentages";
def one: . * 10 | round / 10;
($resolution | map(select(.resolution | .precision == "double" and .relaxation_time == 1.5 and .density_on_lattice != 1 and .cells_per_radius <= 4))
  | group_by(.resolution.bead_boundary)
  | map({key: .[0].resolution.bead_boundary, value: (group_by(.resolution.cells_per_radius) | map(map(seen.v) | spread))}) | from_entries
  | .mr as $mr | map_values([., $mr] | transpose | map(.[0] / .[1] | . * .) | mean | sqrt | one)) as $cells
| group_by(.scheme) | map({key: .[0].scheme, value: (group_by(.on_planes) | map(map(.velocity) | spread / mean))}) | from_entries
| .mr[0] as $mr | to_entries[]
| "\(.key): cells \($cells[.key]), wander \(.value[0] / $mr | one) (\(.value[0] | percent) %, on planes \(.value[1] | percent) %)"
