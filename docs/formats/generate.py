#!/usr/bin/env python3
"""Writes the reference part of the pages of this folder, between the markers, from schemas/*.schema.json.

usage: docs/formats/generate.py [--check]     --check writes nothing; exit status 1 if a page differs from its schema

Each key of a schema needs a description, which for numbers ends with the unit in brackets ([1]: no unit). A definition that several
schemas share has its table on the page of the first of them. The page of a later version of a document names the keys that have not changed.
"""
import json
import sys
from pathlib import Path

here = Path(__file__).resolve().parent
schemas = here.parent.parent / "schemas"
pages = {"run": "run-record"}  # other pages have the names of their schemas
first_schemas = ["layout", "run"]  # their pages hold the tables that other pages link to
earlier_versions = {"layout-2": "layout"}
begin = "<!-- Below: from {}, by docs/formats/generate.py -->"
end = "<!-- end of {} -->"

words = {"string": "text"}
bounds = {"minimum": "≥", "exclusiveMinimum": ">", "maximum": "≤", "exclusiveMaximum": "<"}


class Fault(Exception):
    """An error of a schema or a page."""


class Page:
    """The reference of one schema: a table of the document's keys, and one of each object that has a definition."""

    def __init__(self, schema, homes=None, earlier=None):
        self.schema = schema
        self.unchanged = unchanged_keys(schema, earlier) if earlier else []  # the page of the earlier version describes them
        self.homes = homes or {}  # page of each definition that has its table elsewhere, by name and text
        self.described = {}  # row of this page that states the meaning of a definition
        self.tables = []  # (name and meaning of the object, rows)
        self.named = []  # definitions with a table on this page, in the order of their first use
        self.faults = []
        self.where = ""  # the object of the present table

    def text(self):
        self.add_table(None, self.schema)
        for name in self.named:  # grows during the loop
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
            if value is True or (schema is self.schema and key in self.unchanged):
                continue  # another schema describes this key
            place = f"{path}.{key}" if path else key
            self.add_row(place, value, key in schema.get("required", []), rows)
        others = schema.get("additionalProperties")
        if isinstance(others, dict):
            place = f"{path}.NAME" if path else "NAME"
            if "properties" in schema:  # keys without a name, beside those with one
                rows.append({"key": place, "type": self.type_of(others), "meaning": "other settings", "values": "optional"})
            else:
                self.add_members(place, others, rows)

    def add_row(self, place, value, required, rows):
        target = self.resolved(value)
        meaning, unit = split_unit(value if "description" in value else target)
        if not meaning:
            self.faults.append(f"{self.where}{place}: has no description")
        if self.needs_unit(target) and not unit:
            self.faults.append(f"{self.where}{place}: its description ends with no unit in brackets; [1] says that there is none")
        if "$ref" in value and "description" not in value:
            if value["$ref"] in self.described:
                meaning, unit = f"as {self.described[value['$ref']]}", ""
            else:
                self.described[value["$ref"]] = f"`{place}`" + (f" of {self.where.replace('_', ' ')}".rstrip() if self.where else "")
        values = [] if required else ["optional" if "default" not in value else f"default `{json.dumps(value['default'])}`"]
        values += [] if meaning.startswith("as `") or not allowed(target) else [allowed(target)]
        rows.append({"key": place, "type": self.type_of(value), "values": "; ".join(values),
                     "meaning": meaning if unit in ("", "1") else f"{meaning} [{unit}]"})
        self.add_members(place, value, rows)

    def add_members(self, place, value, rows):
        """Adds rows of the keys of an object or of its elements, unless the object has a table of its own."""
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
        """Returns the name of a definition that has a table of its own, that is, of an object."""
        reference = value.get("$ref", "").removeprefix("#/definitions/")
        return reference if reference and "properties" in self.resolved(value) else None

    def use(self, value):
        name = self.name_of(value)
        if name not in self.named and self.key_of(name) not in self.homes:
            self.named.append(name)

    def key_of(self, name):
        return name, json.dumps(self.schema["definitions"][name], sort_keys=True)

    def type_of(self, value):
        if name := self.name_of(value):
            return f"[{name.replace('_', ' ')}]({self.homes.get(self.key_of(name), '')}#{anchor(name)})"
        value = self.resolved(value)
        if "if" in value:
            return " or ".join(self.type_of(value[branch]) for branch in ("then", "else"))
        kinds = value.get("type", "any" if not {"enum", "const"} & set(value) else "text")
        if isinstance(value.get("enum", [""])[0], int):
            kinds = "integer"
        return " or ".join(self.word_for(kind, value) for kind in ([kinds] if isinstance(kinds, str) else kinds))

    def word_for(self, kind, value):
        if kind == "object" and isinstance(value.get("additionalProperties"), dict) and "properties" not in value:
            return f"{self.type_of(value['additionalProperties'])} by name"
        if kind != "array":
            return words.get(kind, kind)
        count = f"{value['minItems']} ×" if value.get("minItems", 0) == value.get("maxItems") else "list of"
        return f"{count} {self.type_of(value.get('items', {}))}"

    def needs_unit(self, value):
        """Returns true for numbers and lists of numbers; counts need no unit."""
        kinds = value.get("type", [])
        if "array" in kinds:
            return self.needs_unit(self.resolved(value.get("items", {})))
        return "number" in kinds and "string" not in kinds

    @staticmethod
    def table_text(name, meaning, rows):
        columns = [("Key", lambda row: f"`{row['key']}`"), ("Type", lambda row: row["type"]),
                   ("Meaning [unit]" if any(row["meaning"].endswith("]") for row in rows) else "Meaning", lambda row: row["meaning"]),
                   ("Values", lambda row: row["values"])]
        columns = [column for column in columns if any(column[1](row) for row in rows)]
        lines = [f"\n### {heading_of(name)}"] if name else []
        lines += ["", sentence(meaning)] if name and sentence(meaning) != heading_of(name) + "." else []
        lines += ["", "| " + " | ".join(name for name, _ in columns) + " |", "|" + "---|" * len(columns)]
        for row in rows:
            lines.append("| " + " | ".join(cell(row).replace("|", "\\|") for _, cell in columns) + " |")
        return "\n".join(lines)


def expanded(value, schema):
    """Returns a part of a schema with its references replaced by the definitions."""
    if isinstance(value, list):
        return [expanded(element, schema) for element in value]
    if not isinstance(value, dict):
        return value
    if "$ref" in value:
        value = {**schema["definitions"][value["$ref"].removeprefix("#/definitions/")], **value, "$ref": None}
    return {key: expanded(element, schema) for key, element in value.items()}


def unchanged_keys(schema, earlier):
    """Returns the keys of a document that are the same in its earlier version."""
    def described(key, version):
        return expanded(version["properties"].get(key), version), key in version["required"]
    return [key for key in schema["properties"] if described(key, schema) == described(key, earlier)]


def heading_of(name):
    return name.replace("_", " ").capitalize()


def anchor(name):
    return name.replace("_", "-")


def sentence(text):
    return text[0].upper() + text[1:] + "."


def split_unit(schema):
    """Returns meaning and unit of a description "meaning [unit]"."""
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
    """Returns the page with the text between its markers replaced."""
    first, last = begin.format(source), end.format(source)
    if text.count(first) != 1 or text.count(last) != 1 or text.index(first) > text.index(last):
        raise Fault(f"needs one line {first!r}, and {last!r} after it")
    return text[:text.index(first)] + first + "\n" + reference + "\n\n" + text[text.index(last):]


def schema_of(name):
    return json.loads((schemas / f"{name}.schema.json").read_text(encoding="utf-8"))


def main(arguments):
    if arguments not in ([], ["--check"]):
        sys.exit(__doc__)
    wrong, homes = 0, {}
    names = sorted(path.name.removesuffix(".schema.json") for path in schemas.glob("*.schema.json"))
    for name in sorted(names, key=lambda name: (first_schemas + names).index(name)):
        path = schemas / f"{name}.schema.json"
        page = here / f"{pages.get(name, name)}.md"
        source = f"schemas/{path.name}"
        try:
            if not page.exists():
                raise Fault(f"has no page {page.name}")
            now = page.read_text(encoding="utf-8")
            earlier = earlier_versions.get(name)
            reference = Page(schema_of(name), homes, schema_of(earlier) if earlier else None)
            text = reference.text()
            if reference.unchanged:
                keys = ", ".join(f"`{key}`" for key in reference.unchanged)
                text = f"\nThese keys are those of [version 1]({earlier_versions[name]}.md#keys): {keys}.\n" + text
            wanted = page_with(now, source, text)
            homes |= {reference.key_of(name): page.name for name in reference.named}
        except Fault as fault:
            wrong += 1
            for line in str(fault).splitlines():
                print(f"{source}: {line}", file=sys.stderr)
            continue
        if now == wanted:
            continue
        if arguments:
            wrong += 1
            print(f"docs/formats/{page.name}: differs from {source}; run docs/formats/generate.py", file=sys.stderr)
        else:
            page.write_text(wanted, encoding="utf-8")
            print(f"docs/formats/{page.name}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
