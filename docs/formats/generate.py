#!/usr/bin/env python3
"""Writes the reference part of the pages of this folder from schemas/*.schema.json: all that stands between the markers.

usage: docs/formats/generate.py [--check]     --check writes nothing; exit status 1 if a page is not what the schemas give

A schema's keys each need a description: what it is, and for numbers their unit in brackets at its end ([1]: none).
"""
import json
import sys
from pathlib import Path

here = Path(__file__).resolve().parent
schemas = here.parent.parent / "schemas"
pages = {"run": "run-record"}  # other pages are called like their schemas
begin = "<!-- Below: from {}, by docs/formats/generate.py -->"
end = "<!-- Above: from {}, by docs/formats/generate.py -->"

words = {"string": "text", "boolean": "true or false", "array": "list"}
bounds = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}


class Fault(Exception):
    """Something that a schema lacks."""


class Page:
    """The reference of one schema: a table of the document's keys, and one of each object that it names."""

    def __init__(self, schema):
        self.schema = schema
        self.tables = []  # (name and meaning of the object, rows)
        self.named = []  # definitions that need a table, in the order of their first use
        self.faults = []
        self.where = ""  # the object whose table is being made

    def text(self):
        self.add_table(None, self.schema)
        for name in self.named:  # grows while it is gone through
            self.add_table(name, self.schema["definitions"][name])
        if self.faults:
            raise Fault("\n".join(self.faults))
        return "\n".join(self.table_text(*table) for table in self.tables)

    def add_table(self, name, schema):
        rows = []
        self.where = f"{name} " if name else ""
        self.add_keys("", schema, rows)
        meaning = split_unit(schema)[0]
        if name and not meaning:
            self.faults.append(f"definitions/{name}: has no description")
        self.tables.append((name, meaning, rows))

    def add_keys(self, path, schema, rows):
        for key, value in schema.get("properties", {}).items():
            place = f"{path}.{key}" if path else key
            self.add_row(place, value, key in schema.get("required", []), rows)
        others = schema.get("additionalProperties")
        if isinstance(others, dict):
            place = f"{path}.NAME" if path else "NAME"
            if "properties" in schema:  # keys of no name of their own, beside those that have one
                rows.append({"key": place, "type": self.type_of(others), "unit": "", "meaning": "others", "required": "no",
                             "allowed": "", "default": ""})
            else:
                self.add_members(place, others, rows)

    def add_row(self, place, value, required, rows):
        target = self.resolved(value)
        meaning, unit = split_unit(value if "description" in value else target)
        if not meaning:
            self.faults.append(f"{self.where}{place}: has no description")
        if self.needs_unit(target) and not unit:
            self.faults.append(f"{self.where}{place}: its description ends with no unit in brackets; [1] says that there is none")
        rows.append({"key": place, "type": self.type_of(value), "unit": "" if unit == "1" else unit, "meaning": meaning,
                     "required": "yes" if required else "no", "allowed": allowed(target),
                     "default": json.dumps(value["default"]) if "default" in value else ""})
        self.add_members(place, value, rows)

    def add_members(self, place, value, rows):
        """Rows of an object's or its elements' keys, unless it has a table of its own."""
        for part in (value, value.get("then", {}), value.get("else", {})):
            if self.name_of(part):
                self.use(part)
            elif "$ref" in part:
                self.add_members(place, self.resolved(part), rows)
            else:
                self.add_keys(place, part, rows)
                if "items" in part:
                    self.add_members(f"{place}[]", part["items"], rows)

    def resolved(self, value):
        while "$ref" in value:
            value = self.schema["definitions"][value["$ref"].removeprefix("#/definitions/")]
        return value

    def name_of(self, value):
        """Of the definition that a table of its own is for: of an object."""
        reference = value.get("$ref", "").removeprefix("#/definitions/")
        return reference if reference and "properties" in self.resolved(value) else None

    def use(self, value):
        name = self.name_of(value)
        if name not in self.named:
            self.named.append(name)

    def type_of(self, value):
        if name := self.name_of(value):
            return f"[{name.replace('_', ' ')}](#{anchor(name)})"
        value = self.resolved(value)
        if "if" in value:
            return " or ".join(self.type_of(value[branch]) for branch in ("then", "else"))
        kinds = value.get("type", "any" if not {"enum", "const"} & set(value) else "text")
        if isinstance(value.get("enum", [""])[0], int):
            kinds = "integer"
        return " or ".join(self.word_for(kind, value) for kind in ([kinds] if isinstance(kinds, str) else kinds))

    def word_for(self, kind, value):
        if kind == "object" and isinstance(value.get("additionalProperties"), dict) and "properties" not in value:
            return f"object of {self.type_of(value['additionalProperties'])} by name"
        if kind != "array":
            return words.get(kind, kind)
        count = f"{value['minItems']} × " if value.get("minItems", 0) == value.get("maxItems") else ""
        return f"list of {count}{self.type_of(value.get('items', {}))}"

    def needs_unit(self, value):
        """Numbers, and lists of them; counts need none."""
        kinds = value.get("type", [])
        if "array" in kinds:
            return self.needs_unit(self.resolved(value.get("items", {})))
        return "number" in kinds and "string" not in kinds

    @staticmethod
    def table_text(name, meaning, rows):
        columns = [("Key", lambda row: f"`{row['key']}`"), ("Type", lambda row: row["type"]), ("Unit", lambda row: row["unit"]),
                   ("Meaning", lambda row: row["meaning"]), ("Required", lambda row: row["required"]),
                   ("Allowed", lambda row: row["allowed"]),
                   ("Default", lambda row: row["default"] and f"`{row['default']}`")]
        columns = [column for column in columns if any(column[1](row) for row in rows)]
        lines = [f"\n### {heading_of(name)}", "", sentence(meaning)] if name else []
        lines += ["", "| " + " | ".join(name for name, _ in columns) + " |", "|" + "---|" * len(columns)]
        for row in rows:
            lines.append("| " + " | ".join(cell(row).replace("|", "\\|") for _, cell in columns) + " |")
        return "\n".join(lines)


def heading_of(name):
    return name.replace("_", " ").capitalize()


def anchor(name):
    return name.replace("_", "-")


def sentence(text):
    return text[0].upper() + text[1:] + "."


def split_unit(schema):
    """Meaning and unit of a description "meaning [unit]"."""
    text = schema.get("description", "")
    if text.endswith("]"):
        meaning, unit = text[:-1].rsplit("[", 1)
        return meaning.strip(), unit
    return text, ""


def allowed(schema):
    parts = []
    if "const" in schema:
        parts.append(f"`{json.dumps(schema['const'])}`")
    if "if" in schema:
        schema = schema["else"]
    if "enum" in schema:
        parts.append(", ".join(f"`{json.dumps(value)}`" for value in schema["enum"]))
    parts += [f"{sign} {schema[keyword]}" for keyword, sign in bounds.items() if keyword in schema]
    if "minProperties" in schema:
        parts.append(f"at least {schema['minProperties']}")
    if "minItems" in schema and schema["minItems"] != schema.get("maxItems"):
        parts.append(f"at least {schema['minItems']}")
    if "minLength" in schema:
        parts.append("not empty")
    if "pattern" in schema:
        parts.append(f"matches `{schema['pattern']}`")
    if "items" in schema and not ("$ref" in schema["items"] or "properties" in schema["items"]):
        inner = allowed(schema["items"])
        parts += [f"each {inner}"] if inner else []
    return "; ".join(parts)


def page_with(text, source, reference):
    """The page with what stands between its markers replaced."""
    first, last = begin.format(source), end.format(source)
    if text.count(first) != 1 or text.count(last) != 1 or text.index(first) > text.index(last):
        raise Fault(f"needs one line {first!r}, and {last!r} after it")
    return text[:text.index(first)] + first + "\n" + reference + "\n\n" + text[text.index(last):]


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    wrong = 0
    for path in sorted(schemas.glob("*.schema.json")):
        name = path.name.removesuffix(".schema.json")
        page = here / f"{pages.get(name, name)}.md"
        source = f"schemas/{path.name}"
        try:
            if not page.exists():
                raise Fault(f"has no page {page.name}")
            now = page.read_text(encoding="utf-8")
            wanted = page_with(now, source, Page(json.loads(path.read_text(encoding="utf-8"))).text())
        except Fault as fault:
            wrong += 1
            for line in str(fault).splitlines():
                print(f"{source}: {line}", file=sys.stderr)
            continue
        if now == wanted:
            continue
        if arguments:
            wrong += 1
            print(f"docs/formats/{page.name}: is not what {source} gives; run docs/formats/generate.py", file=sys.stderr)
        else:
            page.write_text(wanted, encoding="utf-8")
            print(f"docs/formats/{page.name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
