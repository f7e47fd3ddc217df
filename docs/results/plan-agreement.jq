# Prints the table and the sentences of docs/choosing-a-model.md from plan-agreement.jsonl:  jq -rs -f plan-agreement.jq plan-agreement.jsonl
# Errors below the uncertainty of their reference, typical or measured, count as this uncertainty. A choice is right if the measured errors of
# velocity and strokes are within the tolerance, not right if there is no choice, and undecided if they exceed it by less than the
# uncertainty of the reference. An error is within its limit if it exceeds it by at most the uncertainty of the reference.
def percent: 100 * . | (if . >= 10 then 1 elif . >= 1 then 10 else 100 end) as $n | . * $n | round / $n | tostring;
def digits: if . >= 10 then round else (if . >= 1 then 10 else 100 end) as $n | . * $n | round / $n end | tostring;
def seen: [.measured, .reference] | max;
def verdict: .tolerance as $t | [.velocity, .strokes]
  | if all(.measured <= $t) then "yes" elif all(.measured - .reference <= $t) then "undecided" else "no" end;
def median: sort | .[length / 2 | floor];
def within($from; $to): map(select(. >= $from and . <= $to)) | length;
def ratios: map(([.typical, .reference] | max) / seen) | "median \(median | digits), range \(min | digits) to \(max | digits); within a factor of 2: \(within(0.5; 2)) of \(length)";
def limits: "\(map(select(.measured - .reference <= .limit)) | length) of \(length)";
def model_errors($from; $name): map(.[$name].reference as $reference | .models[] | {limit: .[$from], typical: .[$from + 1], measured: .[$from + 2], $reference});
map(select(.cost)) as $run | length as $scenes | $run |
"| tolerance | choice | core-seconds: predicted, measured | error of velocity [%]: limit, typical, measured | error of strokes [%] | uncertainty of the reference: velocity [%] | within the tolerance |",
"|---|---|---|---|---|---|---|",
(sort_by(-.tolerance, .seed, .scene)[] | "| \(.tolerance | percent) % | `\(.choice | sub("--model "; ""))` | \(.cost.predicted | digits), \(.cost.measured | digits) | \(.velocity | [.limit, .typical, seen] | map(percent) | join(", ")) | \(.strokes | [.limit, .typical, seen] | map(percent) | join(", ")) | \(.velocity.reference | percent) | \(verdict) |"),
"",
"Within the tolerance: \(map(select(verdict == "yes")) | length) of \($scenes) scenes; undecided: \(map(select(verdict == "undecided")) | length).",
"Predicted/measured cost: \(map(.cost.predicted / .cost.measured) | "median \(median | digits), range \(min | digits) to \(max | digits); within 30 %: \(within(1 / 1.3; 1.3)) of \(length)").",
"Typical/measured error of velocity, chosen runs: \(map(.velocity) | ratios); measured within the limit: \(map(.velocity) | limits).",
"Typical/measured error of strokes, chosen runs: \(map(.strokes) | ratios); measured within the limit: \(map(.strokes) | limits).",
"Typical/measured error of velocity, mobility models: \(model_errors(1; "velocity") | ratios); measured within the limit: \(model_errors(1; "velocity") | limits).",
"Typical/measured error of strokes, mobility models: \(model_errors(4; "strokes") | ratios); measured within the limit: \(model_errors(4; "strokes") | limits)."
