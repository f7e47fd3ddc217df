#!/bin/bash
# Tests docs/swarm-figures.md: repeats the first cycles of both swarms with the scripts in examples/, and checks that the page
# agrees with the stored records.
source "$(dirname "$0")/harness.sh"
results=$BEADSWIM_SOURCE/docs/results
records=$results/swarms

well_formed() { # FILE
  check "$1 is not well-formed XML" python3 -c 'import sys, xml.dom.minidom as xml; xml.parse(sys.argv[1])' "$1"
}
# Extracts the data of a run that are stored in the records, as docs/results/swarms.sh does.
kept() { # LAYOUT RUN
  jq -c --arg name new --slurpfile layouts "$1" '$layouts[0] as $layout | '"$(cat "$results/swarms.jq")" "$2"
}

run "$BEADSWIM_SOURCE/examples/figure-5.sh" five --cells-per-radius 3 --cycles 4 --progress none
has_status 0
out_empty
for part in a b; do well_formed five/figure-5$part.svg; done
check 'there are not 243 swimmers, in two colours' test "$(grep -cE '<circle class="b[01]"' five/figure-5a.svg)" -eq 729
beadswim-layout swarm --preset paper-uniform | beadswim-layout reduce >cell.json 2>err
kept cell.json five/uniform.json >new.json
jq -c 'select(.name == "one cell" and .cells_per_radius == 3)' "$records/uniform.jsonl" >old.json
check 'the uniform swarm leaves its line' holds '.largest | .y < 1e-9 and .z < 1e-9 and .tilt < 1e-9' new.json
jq -s 'map(.paths["0"].x[0])' new.json old.json >both.json
check 'the uniform swarm is not where it was on record' holds '(.[0] - .[1] | fabs) < 0.002 and .[0] > 1' both.json

run "$BEADSWIM_SOURCE/examples/figure-6.sh" six --cells-per-radius 3 --precision single --cycles 4 --progress none
has_status 0
out_empty
for part in 6a 6b 6c 6-swarm; do well_formed six/figure-$part.svg; done
for part in 6a:2 6b:3 6c:3; do
  check "figure ${part%:*} has not ${part#*:} curves" \
    test "$(grep -c '<polyline' "six/figure-${part%:*}.svg")" -eq $((2 * ${part#*:}))
done
beadswim-layout swarm --preset paper-defect >swarm.json
kept swarm.json six/defect.json >new.json
jq -c 'select(.name == "reference" and .cells_per_radius == 3)' "$records/defect.jsonl" >old.json
# To a thousandth of a cell: single precision.
jq -s 'map(.paths | [.["0", "3", "4"] | .x[0], .y[0], .z[0]])' new.json old.json >both.json
check 'the defect swarm is not where it was on record' \
  holds '[.[0], .[1]] | transpose | length == 9 and (map((.[0] - .[1] | fabs) < 0.002) | all)' both.json
check 'A moves otherwise along y than along z' holds '.paths["0"] | (.y[0] - .z[0] | fabs) < 0.001 and .z[0] < -0.1' new.json
check 'B moves along z' holds '.paths["3"] | (.z[0] | fabs) < 0.001 and .y[0] < -0.1' new.json

check "the page has not the records' tables" cmp -s <("$results/swarms-tables.sh" "$records") \
  <(sed -n '/^<!-- from the records -->$/,$p' "$BEADSWIM_SOURCE/docs/swarm-figures.md" | sed 1d)

finish
