# Prints the sentence of docs/choosing-a-model.md:  jq -rs -f docs/results/run-costs.jq run-costs.jsonl
map(.measured / .expected) | sort | length as $n | (if $n % 2 == 1 then .[$n / 2 | floor] else (.[$n / 2 - 1] + .[$n / 2]) / 2 end) as $median
| "Measured cost was \($median * 100 | round / 100) times the expected cost at the median of \($n) runs, and within 25 % of it in \(
    map(select(. > 0.75 and . < 1.25)) | length)"
