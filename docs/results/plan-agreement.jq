# Prints the table and the sentences of docs/choosing-a-model.md from plan-agreement.jsonl:  jq -rs -f plan-agreement.jq plan-agreement.jsonl
# A measured error below the uncertainty of its reference counts as this uncertainty. A choice is right if the measured errors of
# velocity and strokes are within the tolerance, not right if there is no choice, and undecided if they exceed it by less than the uncertainty of the reference.
def percent: 100 * . | (if . >= 10 then 1 elif . >= 1 then 10 else 100 end) as $n | . * $n | round / $n | tostring;
def digits: if . >= 10 then round else (if . >= 1 then 10 else 100 end) as $n | . * $n | round / $n end | tostring;
def seen: [.measured, .reference] | max;
def ratio: .predicted / seen;
def verdict: .tolerance as $t | [.velocity, .strokes]
  | if all(.measured <= $t) then "yes" elif all(.measured - .reference <= $t) then "undecided" else "no" end;
def within($from; $to): map(select(. >= $from and . <= $to)) | length;
map(select(.cost)) as $run | length as $scenes | $run |
"| tolerance | choice | core-seconds: predicted, measured | error of velocity [%]: predicted, measured | error of strokes [%] | uncertainty of the reference: velocity [%] | within the tolerance |",
"|---|---|---|---|---|---|---|",
(sort_by(-.tolerance, .scene)[] | "| \(.tolerance | percent) % | `\(.choice | sub("--model "; ""))` | \(.cost.predicted | digits), \(.cost.measured | digits) | \(.velocity.predicted | percent), \(.velocity | seen | percent) | \(.strokes.predicted | percent), \(.strokes | seen | percent) | \(.velocity.reference | percent) | \(verdict) |"),
"",
"Within the tolerance: \(map(select(verdict == "yes")) | length) of \($scenes) scenes; undecided: \(map(select(verdict == "undecided")) | length).",
"Predicted/measured cost: \(map(.cost.predicted / .cost.measured) | "median \(sort | .[length / 2 | floor] | digits), range \(min | digits) to \(max | digits); within 30 %: \(within(1 / 1.3; 1.3))").",
"Predicted/measured error of velocity: \(map(.velocity | ratio) | "median \(sort | .[length / 2 | floor] | digits), range \(min | digits) to \(max | digits); within a factor of 2: \(within(0.5; 2))").",
"Predicted/measured error of strokes: \(map(.strokes | ratio) | "median \(sort | .[length / 2 | floor] | digits), range \(min | digits) to \(max | digits); within a factor of 2: \(within(0.5; 2))")."
