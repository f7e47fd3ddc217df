#!/usr/bin/env python3
"""Checks that every relative link in the Markdown pages leads to an existing file or heading, and that a link leads to every page in docs/.

    links.py SOURCE-FOLDER
"""

import pathlib
import re
import sys


def prose(text):
    """Returns the text of a page without its code, in which brackets are not links."""
    return re.sub(r"(?ms)^```.*?^```|`[^`\n]*`", "", text)


def anchors(page):
    """Returns the anchors that GitHub makes from the headings of a page."""
    headings = re.findall(r"(?m)^#+ (.+)$", page.read_text())
    return {re.sub(r"[^\w\- ]", "", h.lower()).strip().replace(" ", "-") for h in headings}


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    pages = [p for p in [root / "README.md", *root.glob("*/**/*.md")] if not {"build", "out", "node_modules"} & set(p.relative_to(root).parts)]
    faults, linked = [], {root / "README.md", root / "CHANGELOG.md"}
    for page in pages:
        for target in re.findall(r"\]\(([^)\s]+)\)", prose(page.read_text())):
            if re.match(r"\w+:", target):
                continue
            name, _, anchor = target.partition("#")
            path = (page.parent / name).resolve() if name else page
            linked |= {path} if path != page else set()
            if not path.exists():
                faults.append(f"{page.relative_to(root)}: links to {target}, which is not there")
            elif anchor and path.suffix == ".md" and anchor not in anchors(path):
                faults.append(f"{page.relative_to(root)}: links to {target}, a heading that is not there")
    folders = [path for path in linked if path.is_dir()]
    lost = [p for p in pages if (root / "docs") in p.parents and p not in linked and p.parent not in folders]
    faults += [f"{p.relative_to(root)}: no page links to it" for p in lost]
    print("\n".join(faults + [f"{len(pages)} pages, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
