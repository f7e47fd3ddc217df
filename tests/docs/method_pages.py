#!/usr/bin/env python3
"""Checks the pages in docs/method: each has all its parts, the headers and tests that it names exist, and the index names every page.

    method_pages.py SOURCE-FOLDER
"""

import pathlib
import re
import sys

PARTS = {
    "idea": r"\*\*Idea\.\*\*",
    "equation": r"(?m)^    \S",
    "symbols and units": r"(?m)^\| Symbol \| Meaning \| Unit \|$",
    "validity": r"(\*\*|## )Validity",
    "discretisation": r"(\*\*|## )Discretisation",
    "header": r"\*\*Headers?\*\*|\| What \| Where \| Test \|",
    "test": r"\*\*Tests?(\.|\*\*)|\| What \| Where \| Test \|",
    "reference": r"\*\*References?\.\*\*",
}


def files(root, folders, suffixes):
    return [p for folder in folders for p in (root / folder).rglob("*") if p.suffix in suffixes]


def suites(root):
    """Returns the names Suite and Suite.Case of all GoogleTest cases in the sources."""
    names = set()
    for source in files(root, ["tests"], {".cpp", ".hpp"}):
        for suite, case in re.findall(r"(?m)^(?:TYPED_)?TEST(?:_[FP])?\((\w+),\s*(\w+)", source.read_text()):
            names |= {suite, f"{suite}.{case}"}
    return names


def ends_with(path, name):
    return ("/" + path.as_posix()).endswith("/" + name)


class Tree:
    def __init__(self, root):
        self.headers = files(root, ["libs", "tools", "tests"], {".hpp"})
        self.sources = files(root, ["libs", "tools", "tests"], {".cpp", ".py", ".sh"})
        self.tests = {p.stem for p in files(root, ["tests"], {".cpp", ".sh", ".py"})}
        self.tests |= set(re.findall(r"beadswim_\w*test\((\w+)", "".join(
            p.read_text() for p in files(root, ["tests"], {".txt"}))))
        self.suites = suites(root)
        self.root = root

    def has_file(self, name):
        name = re.sub(r"^(lattice|coupling|swimmers|collinear|mobility|libs/\w+)/src/", r"src/", name) if "/src/" in name else name
        return any(ends_with(p, name) for p in self.headers + self.sources) or (self.root / name).exists()

    def has_test(self, name):
        return name in self.suites or name in self.tests


def named_files(text):
    return {name for name in re.findall(r"`([\w/+-]+\.(?:hpp|cpp|py|sh))`", text)}


def test_words(text):
    """Returns the texts in backticks in the section in which a page names its tests."""
    found = re.findall(r"\*\*Tests?\.?\*\*(.*?)(?:\n\*\*Ref|\Z)", text, re.S)
    rows = re.search(r"\| What \| Where \| Test \|\n\|[-|]+\n((?:\|.*\n)+)", text)
    found += [row.split("|")[3] for row in rows.group(1).splitlines()] if rows else []
    return {w for part in found for w in re.findall(r"`([A-Za-z][\w.]*)`", part) if not re.search(r"\.(hpp|cpp|py|sh)$", w)}


def faults_of(page, tree):
    text = page.read_text()
    for part, pattern in PARTS.items():
        if not re.search(pattern, text):
            yield f"lacks its {part}"
    for name in sorted(named_files(text)):
        if not tree.has_file(name):
            yield f"names {name}, which is not there"
    words = test_words(text)
    if not words and not re.search(r"`tests/[\w/.]+`", text):
        yield "names no test"
    for word in sorted(words):
        if not tree.has_test(word) and not tree.has_file(word + ".hpp"):
            yield f"names the test {word}, which is not there"


def index_faults(folder):
    index = (folder / "README.md").read_text()
    listed = set(re.findall(r"\]\(([\w-]+\.md)\)", index))
    pages = {p.name for p in folder.glob("*.md")} - {"README.md"}
    yield from (f"README.md: does not list {name}" for name in sorted(pages - listed))
    yield from (f"README.md: lists {name}, which is not there" for name in sorted(listed - pages))


def main():
    root = pathlib.Path(sys.argv[1])
    folder, tree = root / "docs/method", Tree(root)
    pages = sorted(p for p in folder.glob("*.md") if p.name != "README.md")
    faults = [f"{page.name}: {fault}" for page in pages for fault in faults_of(page, tree)]
    faults += index_faults(folder)
    index = (folder / "README.md").read_text()
    faults += [f"README.md: names {n}, which is not there" for n in sorted(named_files(index)) if not tree.has_file(n)]
    for fault in faults:
        print(f"docs/method/{fault}")
    print(f"{len(pages)} pages, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
