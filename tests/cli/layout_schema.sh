#!/bin/bash
# Tests the schemas, and documents that the programs write, with a second validator: python3-jsonschema.
source "$(dirname "$0")/harness.sh"

python=/usr/bin/python3

for schema in "$BEADSWIM_SOURCE"/schemas/*.schema.json; do
  accepts $python -c 'import json, sys, jsonschema
schema = json.load(open(sys.argv[1]))
assert schema["$schema"] == "http://json-schema.org/draft-07/schema#"
jsonschema.Draft7Validator.check_schema(schema)' "$schema"
done

beadswim-layout swimmer --preset paper-single >bounded.json
beadswim-layout swimmer --preset paper-single --unbounded --units um,s,pg --radius 1 --viscosity 1e6 --density 1 >unbounded.json
beadswim-layout check bounded.json --json >bounded-check.json
beadswim-layout check unbounded.json --json >unbounded-check.json
valid layout bounded.json
valid layout unbounded.json
valid layout-check bounded-check.json
valid layout-check unbounded-check.json

# Both validators refuse what the schema alone can see.
for edit in 's/"radius"/"raduis"/' 's/"lattice"/"latice"/' 's/"lab"/"labb"/' 's/"density": 1.0/"density": "1.0"/' \
  's/"density": 1.0/"density": 0/' 's/"id": 0/"id": 0.5/' 's/"axis": \[1.0, /"axis": [/'; do
  sed "$edit" bounded.json >bad.json
  run $python -W ignore -m jsonschema -i bad.json "$BEADSWIM_SOURCE/schemas/layout.schema.json"
  has_status 1
  refuses 'bad.json:/' beadswim-layout check bad.json
done

finish
