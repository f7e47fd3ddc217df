# Draws docs/images/stated-uncertainty.svg:  jq -rs -f docs/results/stated-uncertainty-figure.jq stated-uncertainty.jsonl
# Each mark is one velocity or one arm amplitude; the actual error is at most the stated one below the line.
def low: -4; def high: 1; def size: 400; def left: 70; def top: 20;
def at: ([[., 1e-4] | max, 10] | min | log10 - low) / (high - low) * size;
def x: left + at; def y: top + size - at;
def two: . * 10 | round / 10;
def mark($shape; $colour): .stated as $s | .actual as $a
  | if $shape == "circle" then "<circle cx=\"\($s | x | two)\" cy=\"\($a | y | two)\" r=\"4\" fill=\"\($colour)\"/>"
    elif $shape == "square" then "<rect x=\"\(($s | x) - 3 | two)\" y=\"\(($a | y) - 3 | two)\" width=\"6\" height=\"6\" fill=\"none\" stroke=\"\($colour)\"/>"
    else "<path d=\"M\($s | x | two) \(($a | y) - 4 | two)l4 7h-8z\" fill=\"none\" stroke=\"\($colour)\"/>" end;
def group($name; $shape; $colour; $marks): {name: $name, shape: $shape, colour: $colour, marks: $marks};
def runs($model): [.[].runs[] | select((.flags | split(" ")[1]) as $m | ($model == "lbm") == ($m == "lbm")) | select(.error and .expected)
  | {stated: .expected[0], actual: (.error[0] | fabs)}];
[group("inertia-corrected, v"; "circle"; "#0072B2"; [.[].prediction | {stated: .stated[0], actual: (.error[0] | fabs)}]),
 group("inertia-corrected, arms"; "circle"; "#56B4E9"; [.[].prediction | (1, 2) as $k | {stated: .stated[$k], actual: (.error[$k] | fabs)}]),
 group("lattice runs, v"; "square"; "#D55E00"; runs("lbm")),
 group("mobility runs, v"; "triangle"; "#777777"; runs("mobility"))] as $groups
| "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"700\" height=\"500\" font-family=\"sans-serif\" font-size=\"13\">",
  "<rect width=\"700\" height=\"500\" fill=\"white\"/>",
  "<path d=\"M\(left) \(top + size)L\(left + size) \(top)\" stroke=\"black\" stroke-dasharray=\"4 3\"/>",
  (range(low; high + 1) | (if . >= -2 then "\(pow(10; . + 2) | round)" else "\(pow(10; . + 2) * 100 | round / 100)" end) as $text
   | (pow(10; .)) as $v
   | "<path d=\"M\($v | x) \(top)v\(size)M\(left) \($v | y)h\(size)\" stroke=\"#dddddd\"/>",
     "<text x=\"\($v | x)\" y=\"\(top + size + 18)\" text-anchor=\"middle\">\($text)</text>",
     "<text x=\"\(left - 8)\" y=\"\(($v | y) + 4)\" text-anchor=\"end\">\($text)</text>"),
  "<rect x=\"\(left)\" y=\"\(top)\" width=\"\(size)\" height=\"\(size)\" fill=\"none\" stroke=\"black\"/>",
  "<text x=\"\(left + size / 2)\" y=\"\(top + size + 42)\" text-anchor=\"middle\">stated uncertainty or expected error [%]</text>",
  "<text x=\"0\" y=\"0\" transform=\"translate(18 \(top + size / 2)) rotate(-90)\" text-anchor=\"middle\">actual error [%]</text>",
  ($groups | reverse[] | . as $g | "<g>\([.marks[] | mark($g.shape; $g.colour)] | join(""))</g>"),
  (range($groups | length) | . as $i | $groups[$i]
   | "<g transform=\"translate(490 \(60 + 24 * $i))\">\(if .shape == "circle" then "<circle cx=\"0\" cy=\"0\" r=\"4\" fill=\"\(.colour)\"/>" elif .shape == "square"
      then "<rect x=\"-3\" y=\"-3\" width=\"6\" height=\"6\" fill=\"none\" stroke=\"\(.colour)\"/>" else "<path d=\"M0 -4l4 7h-8z\" fill=\"none\" stroke=\"\(.colour)\"/>" end)<text x=\"12\" y=\"4\">\(.name)</text></g>"),
  "<text x=\"70\" y=\"488\" font-size=\"10\" text-anchor=\"start\">60 random scenes of one swimmer. Below the dashed line the actual error is within the stated one.</text>",
  "</svg>"
