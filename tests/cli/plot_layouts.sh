#!/bin/bash
# Tests beadswim-plot swarm and beadswim-plot swimmer for layouts: positions, names, distances and forces in the figures.
source "$(dirname "$0")/harness.sh"

drawn() { # NUMBER REGEX   on how many lines of out it is
  check "there are not $1 lines like $2" test "$(grep -cE -- "$2" out)" -eq "$1"
}
plain() { sed -E 's/<\/?tspan[^>]*>//g' out; } # subscripts as plain letters, a shift after them
labelled() { # TEXT...   each once
  for label in "$@"; do check "not once: $label" test "$(plain | grep -cF ">$label<")" -eq 1; done
}

beadswim-layout swarm --preset paper-defect >defect.json

# --- swarm
accepts beadswim-plot swarm defect.json
well_formed out
out_has '>Swarm as laid out<'
notes_have '9 swimmers in a box of 120 × 120 × 120 \(lattice units\)'
same_bytes 'beadswim-plot swarm defect.json' 'beadswim-plot swarm - <defect.json'
accepts beadswim-plot swarm defect.json --repeat 2,2,2 --distances --mark A=0,B=3
well_formed out
labelled 'Dx= 56' 'Cy= 37' 'Dy= 46' 'Cz= 37' 'Dz= 46' A B
drawn 108 '<circle class="b0"'
drawn 108 '<circle class="b1"'
# A single block has no D, and blocks of two along y have other Cs and Ds.
accepts beadswim-plot swarm defect.json --distances
labelled 'Cy= 37' 'Cz= 37'
check 'a block has a distance to the next' bash -c '! grep -q ">D<" out'
accepts beadswim-plot swarm defect.json --distances --block-swimmers 1,1,3
labelled 'Dy= 37' 'Cz= 37'
# Along x from the end bead of one swimmer to that of the next.
beadswim-layout swarm --preset paper-uniform --blocks 2,1,1 --block-swimmers 1,1,1 --block-gap 50,60,60 --arm 25,30 >row.json
accepts beadswim-plot swarm row.json --distances
labelled 'Dx= 50'
# In physical units, open space, under any name.
beadswim-layout swimmer --preset paper-single --unbounded | jq '.units = {
  length: {name: "um", si_factor: 1e-6}, time: {name: "s", si_factor: 1}, mass: {name: "pg", si_factor: 1e-15}}' >open
accepts beadswim-plot swarm open
notes_have '1 swimmer in open space, a box drawn around \(um, s, pg\)'

refuses '--distances: there is no distance to draw, because no swimmer has a neighbour along an axis; draw periodic copies too' beadswim-plot swarm open --distances
refuses '--distances: distances between neighbours along an axis need the number of swimmers of a block along each axis; give --block-swimmers as NX,NY,NZ' \
  beadswim-plot swarm defect.json --distances --block-swimmers 9
refuses '--mark: there is no swimmer with the id 12 in defect.json; the nearest id is 8, and the ids range from 0 to 8' beadswim-plot swarm defect.json --mark A=12
for mark in A A= =3 A=x A=-1; do
  refuses "--mark: \"$mark\": the value must be a label and a swimmer's id, such as A=3" beadswim-plot swarm defect.json "--mark=$mark"
done
refuses '--frame: defect.json is a layout, and layouts have no frames; leave the flag out' beadswim-plot swarm defect.json --frame 3
refuses 'none.json: the file cannot be read' beadswim-plot swarm none.json

# --- swimmer
beadswim-layout swimmer --preset paper-single >single.json
accepts beadswim-plot swimmer single.json
well_formed out
labelled 'F₁ = A sin ωt' 'F₂ = −F₁ − F₃' 'F₃ = B sin(ωt + α)'
notes_have 'Bead density 1, KA = .*'
notes_have 'A = B = 0.2, α = 1.571 rad, T = 4800, along x; ω = 2π/T'
notes_have 'Fluid: ρ = 1, ν = 0.3333; box 1200 × 800 × 800'
same_bytes 'beadswim-plot swimmer single.json' 'beadswim-plot swimmer - <single.json'
# To scale: centres are apart as the arms are long, radii as the beads are large.
beadswim-layout swimmer --preset paper-single --radius 2,4,3 --arm 20,30 --damping 0.5,0 --stiffness 0.1,0.2 >uneven.json
accepts beadswim-plot swimmer uneven.json
labelled 'λ₁ = 2' 'λ₂ = 4' 'λ₃ = 3' 'l₁ = 20' 'l₂ = 30' 'k₁ = 0.1' 'k₂ = 0.2' 'c₁ = 0.5'
check 'not to scale' python3 - <<'PYTHON'
import re, sys
(a, r), (b, s), (c, t) = [(float(x), float(r)) for x, r in re.findall(r'<circle cx="([\d.]+)" cy="[\d.]+" r="([\d.]+)"', open("out").read())]
scale = (c - a) / 50
sys.exit(max(abs(b - a - 20 * scale), abs(r - 2 * scale), abs(s - 4 * scale), abs(t - 3 * scale)) > 0.02)
PYTHON
# A swimmer's own driving and place, units at the parts, the field at its angle to the axis.
jq '.swimmers[7].driving = {amplitude: [1, 3], phase: 0.5, period: 900, frame: "body"}' defect.json >own.json
accepts beadswim-plot swimmer own.json --swimmers 7
out_has '>Swimmer 7 of type '
notes_have 'A = 1, B = 3, α = 0.5 rad, T = 900, along the arms; ω = 2π/T'
accepts beadswim-plot swimmer open
out_has '>k = 0.0347 pg/s²<'
notes_have 'to scale, in um, s, pg'
refuses '--swimmers: there is no swimmer with the id 12 in own.json; the nearest id is 8, and the ids range from 0 to 8' beadswim-plot swimmer own.json --swimmers 12
refuses '--swimmers: 2 ids are given, but a sketch shows one swimmer; give one id' beadswim-plot swimmer own.json --swimmers 1,2
refuses 'FILES: 2 files are given; a swimmer is drawn from one layout' beadswim-plot swimmer own.json single.json
refuses 'FILES: 0 files are given' beadswim-plot swimmer

# --- notes of layouts with many parameters: at most 60 words, below the drawing, inside the page
jq '.swimmers[7].driving = {amplitude: [1, 3], phase: 0.5, period: 900, frame: "initial-axis", phase_offset: 0.2}
  | .types[].beads[0].density = 2 | .types[].springs[0].damping = 0.5' defect.json >full.json
accepts beadswim-plot swimmer full.json --swimmers 7
notes_have 'Bead density 1 to 2'
notes_have 'Arm 1 trails, arm 2 leads'   # no note is left out
accepts beadswim-plot swarm full.json --repeat 2,2,2
notes_have 'Blocks of swimmers alternate in colour'
notes_have 'λ = 6, '
notes_have '1 driven otherwise'
jq '.types as {$a} | .types = ([range(9) | {key: "type \(.)", value: ($a | .springs[].stiffness *= 1.5)}] | from_entries + {"a": $a})
  | .swimmers |= [range(length) as $i | .[$i] | .type = "type \($i)"]' full.json >types.json
accepts beadswim-plot swarm types.json --colours types
notes_have '10 types: λ = 6, l = 32, k = 0\.2 to 0\.3, A, B = 2, T = 2000; 1 driven otherwise'

jq '(.types | keys[0]) as $a | .types["\u0001&<\u001f\uffff\"_é"] = .types[$a] | .swimmers[0].type = "\u0001&<\u001f\uffff\"_é"' full.json >odd.json
for figure in "swarm odd.json --colours types" "swarm odd.json" "swimmer odd.json --swimmers 0"; do
  accepts beadswim-plot $figure
  well_formed out
done

# --- the pictures of docs/figures.md are those of the examples
examples=$BEADSWIM_SOURCE/examples
for figure in 1 4; do
  run "$examples/figure-$figure.sh" folder
  has_status 0
  out_empty
  err_has "^folder/figure-$figure.svg$"
  same_bytes "cat folder/figure-$figure.svg" "cat $BEADSWIM_SOURCE/docs/images/figure-$figure.svg"
done
run "$examples/figure-4.sh" uniform --preset paper-uniform
has_status 0
cp uniform/figure-4.svg out
labelled 'Dx= 32' 'Cy= 32' 'Dz= 32'

accepts beadswim-plot swimmer single.json -o swimmer.png
check 'swimmer.png is no PNG' test "$(head -c 8 swimmer.png | od -An -tx1 | tr -d ' \n')" = 89504e470d0a1a0a

finish
