"""Validates documents with python3-jsonschema: the schemas themselves, valid documents, and documents with one fault each.

usage: by_jsonschema.py SCHEMAS DOCUMENTS FAULTS     folders; documents are SCHEMA/NAME.json
"""
import json
import sys
import warnings
from pathlib import Path

warnings.filterwarnings("ignore")
import jsonschema

schemas, documents, faults = map(Path, sys.argv[1:])
wrong = 0
counts = {True: 0, False: 0}
for path in sorted(schemas.glob("*.schema.json")):
    schema = json.loads(path.read_text())
    assert schema["$schema"] == "http://json-schema.org/draft-07/schema#", path
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    for folder, sound in ((documents, True), (faults, False)):
        files = sorted((folder / path.name.removesuffix(".schema.json")).glob("*.json"))
        assert files, f"{folder} has no document for {path.name}"
        counts[sound] += len(files)
        for file in files:
            errors = list(validator.iter_errors(json.loads(file.read_text())))
            if bool(errors) == sound:
                wrong += 1
                print(f"{file}: {errors[0].message if errors else 'is not refused'}", file=sys.stderr)
if wrong:
    sys.exit(1)
print(f"{counts[True]} documents accepted, {counts[False]} faults refused")
