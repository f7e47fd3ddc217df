#!/bin/bash
# Tests that a swarm whose swimmers cross the boundaries between ranks gives the same bytes on any number of ranks.
source "$(dirname "$0")/harness.sh"

# Middle beads, whose ranks own the swimmers, go to and fro across the planes in which ranks meet in a box of 48: 24 between
# 2, 4 and 8 ranks, along all axes for 8, and 16 along z between 3.
beadswim-layout swarm --preset paper-uniform --blocks 2,2,2 --block-swimmers 1,1,1 --radius 2 --arm 8 --core-gap 12 \
  --block-gap 8,24,24 --period 200 --amplitude 0.4 --frame initial-axis |
  beadswim-layout defect rotation --sigma 0.6 --seed 3 | beadswim-layout defect frequency --sigma 0.1 --seed 4 |
  beadswim-layout defect phase --random --seed 5 |
  jq '.swimmers[].position |= map(. + 12) | .swimmers[:2][].position[2] = 16' >swarm.json
check "the swarm is laid out" test "$(jq '.swimmers | length' swarm.json)" -eq 8
for scheme_and_ranks in 'mr 1' 'mr 3' 'mr 8' 'psm 1' 'psm 2' 'psm 4'; do
  read -r scheme ranks <<<"$scheme_and_ranks"
  run mpirun -n $ranks beadswim-run swarm.json -o $scheme$ranks.h5md --cells-per-radius 2 --cycles 2 \
    --bead-boundary $scheme --checkpoint-every 1 --progress none --no-provenance
  has_status 0
  mv out $scheme$ranks.json
  check "a state" grep -q '"state_sha256": "[0-9a-f]\{64\}"' $scheme$ranks.json
  [ $ranks -eq 1 ] && continue
  check "$ranks ranks: record" cmp -s ${scheme}1.json $scheme$ranks.json
  check "$ranks ranks: trajectory" cmp -s ${scheme}1.h5md $scheme$ranks.h5md
  for part in lattice swimmers record trajectory layout settings; do  # all but the cost
    check "$ranks ranks: checkpoint" h5diff ${scheme}1.h5md.ckpt.1 $scheme$ranks.h5md.ckpt.1 /$part
  done
done

# 40 x 12 x 12 cells: of the grids of 14 blocks, the cheapest has blocks of one cell, too thin for mr, and 7 x 1 x 2 fits.
beadswim-layout swimmer --preset paper-single --box 80,24,24 --boundary periodic --position 40,12,12 >thin.json
thin=(--cells-per-radius 2 --cycles 0.01 --progress none --no-provenance)
run beadswim-run thin.json -o thin.h5md "${thin[@]}"
has_status 0
one=$(jq .state_sha256 out)
run mpirun -n 14 beadswim-run thin.json -o thin.h5md "${thin[@]}"
has_status 0
check "14 ranks change the state" test "$one" = "$(jq .state_sha256 out)"
run mpirun -n 23 beadswim-run thin.json -o x.h5md "${thin[@]}"
has_status 2
err_has '^beadswim-run: mpirun -n: 23 ranks cannot share 40 x 12 x 12 cells, because each block needs at least 2 along each axis; use mpirun -n 22 or another --bead-boundary$'

# Prints how many middle beads have been on both sides of the plane at PLACE across AXIS. h5dump prints positions bead by bead, in
# the order x, y, z.
crossings() { # AXIS PLACE
  h5dump -d /particles/beads/position/value -w 0 -y -m %.6f mr1.h5md | awk -v axis="$1" -v place="$2" '
    /^ *[-0-9.]+,?$/ {
      bead = int(n / 3) % 24
      if (n++ % 3 != axis || bead % 3 != 1) next
      if ($1 + 0 < place && $1 + 0 > place - 6) below[bead] = 1
      if ($1 + 0 > place && $1 + 0 < place + 6) above[bead] = 1
    }
    END { for (bead in below) if (bead in above) ++count; print count + 0 }'
}
for plane in "0 24" "1 24" "2 24" "2 16"; do
  command_line="crossings $plane"
  check "swimmers change hands there" test "$(crossings $plane)" -gt 0
done
# What two ranks send each other in a step (docs/scaling.md): two faces with their edges, of 15 or 5 numbers a cell, and the
# four bytes of a message that names no bead, none being near a seam; one message more before the first step.
beadswim-layout swimmer --preset paper-single --radius 2 --arm 9 --box 32,16,16 --boundary periodic --period 100 \
  --amplitude 0.02 --position 16,8,4 >off_seams.json
sends() { # NUMBERS-A-CELL BYTES-A-NUMBER FLAG...
  run mpirun -n 2 beadswim-run off_seams.json -o sent.h5md --cells-per-radius 2 --cycles 1 --progress none "${@:3}"
  has_status 0
  check "as many bytes as two faces have" \
    holds ".cost.communication | .neighbours == 1 and (.bytes_per_step - $((2 * 34 * 18 * $1 * $2 + 4)) | fabs) < 0.1" out
}
sends 15 8 --bead-boundary mr
sends 15 4 --bead-boundary mr --precision single
sends 5 8 --bead-boundary cli
sends 5 8 --bead-boundary psm
run beadswim-run off_seams.json -o sent.h5md --cells-per-radius 2 --cycles 1 --progress none
check "one rank sends nothing" holds '.cost.communication.bytes_per_step == 0' out

records=$BEADSWIM_SOURCE/docs/results/scaling.jsonl
check "the page has the records' tables" cmp -s <(bash "$BEADSWIM_SOURCE/docs/results/scaling-tables.sh" "$records") \
  <(sed -n '/^<!-- from the records -->$/,$p' "$BEADSWIM_SOURCE/docs/scaling.md" | sed 1d)

finish
