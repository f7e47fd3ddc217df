# Prints the table of docs/stated-uncertainty.md:  jq -rs -f docs/results/stated-uncertainty.jq stated-uncertainty.jsonl
# An error is inside if it is at most the root of the sum of squares of the stated uncertainty and that of the reference.
def root: map(. * .) | add | sqrt;
def median: sort | if length == 0 then null elif length % 2 == 1 then .[length / 2 | floor] else (.[length / 2 - 1] + .[length / 2]) / 2 end;
def percent: . * 1000 | round / 10;
# Numbers {error, stated, reference}, all relative, of the quantities with the indices $ks; the largest counts.
def row($name; $numbers): ($numbers | length) as $n
  | ([$numbers[] | select((.error | fabs) <= ([.stated, .reference] | root))] | length) as $inside
  | "| \($name) | \($inside) of \($n) | \([$numbers[].error | fabs] | median | percent) | \([$numbers[].stated] | median | percent) | \(
      [$numbers[] | ([.stated, 0.002] | max) / ([.error | fabs, 0.002] | max)] | median * 10 | round / 10) |";
def predictions($ks): [.[] | .reference.uncertainty as $r | .prediction | $ks[] as $k | {error: .error[$k], stated: .stated[$k], reference: $r[$k]}];
def runs($model; $ks): [.[] | .reference.uncertainty as $r | .runs[] | select((.flags | split(" ")[1]) == $model) | select(.error and .expected)
  | {error: ([.error[$ks[]] | fabs] | max), stated: ([.expected[$ks[]]] | max), reference: ([$r[$ks[]]] | max)}];
"| quantity | inside | median error [%] | median stated [%] | median of stated/actual |",
"|---|---|---|---|---|",
row("v by `inertia-corrected`"; predictions([0])),
row("arm amplitudes by `inertia-corrected`"; predictions([1, 2])),
(("lbm", "rpy", "rpy+near", "oseen") as $model | row("v of runs by `\($model)`"; runs($model; [0])), row("arm amplitudes of runs by `\($model)`"; runs($model; [1, 2])))
