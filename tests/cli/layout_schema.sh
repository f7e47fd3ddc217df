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

finish
