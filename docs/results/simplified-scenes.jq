# Prints how many errors are within their limits, from the records of simplified-scenes.sh, with the factor 2 of the limits and
# without it:   jq -rs -f docs/results/simplified-scenes.jq docs/results/simplified-scenes.jsonl
# A limit includes half of the limit of the reference. Strokes of other shapes are prescribed or stiff: only their velocities count.
def within($factor; $half): [.[] | select(([.expected * $factor, .reference * $half] | map(. * .) | add | sqrt) >= .error)] | length;
def row($name): "\($name): \(within(1; 0.5)) of \(length) (without the factor 2: \(within(0.5; 0.5))), median limit/error \(
  map(.expected / .error) | sort | .[length / 2 | floor] * 10 | round / 10)";
[.[] | .reference as $r | (.layout | test(" shape ")) as $shape | .runs[] | (.flags | test("lbm")) as $lattice | range(if $shape then 1 else 3 end) as $k
  | {$shape, $lattice, quantity: (if $k == 0 then "velocity" else "arm amplitudes" end), expected: .expected[$k], error: .error[$k], reference: $r[$k]}]
| (false, true) as $shape | (true, false) as $lattice | ("velocity", "arm amplitudes") as $quantity
| map(select(.shape == $shape and .lattice == $lattice and .quantity == $quantity)) | select(length > 0)
| row("\($quantity)\(if $shape then " of other shapes" else "" end), \(if $lattice then "lattice runs" else "mobility models" end)")
