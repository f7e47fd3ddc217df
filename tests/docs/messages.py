#!/usr/bin/env python3
"""Checks the texts of the sources: each thrown message says what to do, and docs/errors.md quotes only texts that exist.

    messages.py SOURCE-FOLDER            exit status 1 if there is a fault
    messages.py SOURCE-FOLDER --list     prints all texts, to compare two revisions; page_flags.sh checks the flags in them

A text is what the string literals of one statement say. "…" stands for an inserted value; a setting is replaced by its flag, as in
the programs. docs/errors.md quotes messages, or parts of them, in backticks in the first column of its tables.
"""

import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\\n]|\\.)*"'
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|" + LITERAL + r"|'(?:[^'\\\n]|\\.)+'", re.S)
RUN = re.compile(r"(?:" + LITERAL + r"\s*)+")
# What tells a user what to do or what is allowed.
REMEDY = re.compile(
    r";|\bmust\b|\bneed(s|ed)?\b|did you mean|Valid|Available|predictions have|verdict has|One of these|--help|\b(see|give|name|use|write|leave|reduce|join|add)\b|, each "
)
# Faults of files and processes, and texts to which the function that catches them adds the remedy.
REMEDY_ELSEWHERE = re.compile(
    r"cannot be (read|written|created|copied|replaced|started)|waiting for a process|HDF5|dataset|attribute|regular file|has the schema|built in"
    r"|more than 256|leads to|not varied|is not a finite number|smaller than|no angle|too far apart|before or after the colon|is invalid$|verify"
    r"|cannot (treat|run)|no method of theory|is a failure|has no document|is damaged$|memory needs|only bend the swimmer|does not know the value|no model can run|presets belong"
)


def without_comments(text):
    blank = lambda m: re.sub(r"[^\n]", " ", m.group()) if m.group().startswith(("//", "/*")) else m.group()
    return re.sub(r"#\s*include[^\n]*", lambda m: " " * len(m.group()), TOKEN.sub(blank, text))


def arguments(code):
    """Returns the arguments of a call after its first one; `code` begins at the end of the first argument."""
    found, depth = [""], 0
    for part in re.findall(LITERAL + r"|.", code, re.S):
        depth += (part in "([{") - (part in ")]}")
        if depth < 0:
            break
        if part == "," and depth == 0:
            found.append("")
        else:
            found[-1] += part
    return [a.strip() for a in found[1:]]


def plain(literals, values, flags):
    """Returns the message as the user reads it, with … for an inserted value and the flag for a setting."""
    text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals))
    text = text.replace("{{", "\0").replace("}}", "\1")
    values = iter(values)
    text = re.sub(r"\{[^}]*\}", lambda m: flags.get(next(values, ""), "…"), text).replace("\0", "{").replace("\1", "}")
    return text.replace('\\"', '"').replace("\\n", " ").replace("\\t", " ")


def joined(runs, text, flags):
    """Returns the messages of one statement: runs of literals, joined where only "+ value +" stands between them."""
    messages = []
    for run in runs:
        words = plain(run.group(), arguments(text[run.end() :]), flags)
        between = text[messages[-1][2] : run.start()].strip() if messages else ""
        if messages and re.fullmatch(r"\+[^;{}?]*\+", between) and "InputError" not in between:
            start, before, _ = messages.pop()
            messages.append((start, before + "…" + words, run.end()))
        else:
            messages.append((run.start(), words, run.end()))
    return messages


def statements(text):
    """Yields the line and the code of each statement."""
    text = without_comments(text)
    ends = [0] + [m.end() for m in re.finditer(r"(?<!')[;{}]\n|:\n", RUN.sub(lambda m: "_" * len(m.group()), text))] + [len(text)]
    for begin, end in zip(ends, ends[1:]):
        yield text.count("\n", 0, begin) + 1, text[begin:end]


def texts(root):
    """Returns place, texts of two words or more, and whether it throws (DataError apart, to which the function that catches it adds the remedy), of each statement of the sources."""
    sources = {p.relative_to(root): p.read_text() for f in ["libs", "tools"] for p in sorted((root / f).rglob("*.[ch]pp"))}
    all_text = "".join(sources.values())
    settings = re.search(r"#define BEADSWIM_SETTINGS([\w, \\\n]+)\n//", all_text)
    flags = {f"Setting::{name}": "--" + name.replace("_", "-") for name in re.findall(r"\w+", settings[1])}
    flags |= dict(re.findall(r'\{(Setting::\w+), "([^"]+)"\}', all_text))  # special flags
    for path, source in sources.items():
        for line, code in statements(source):
            said = [" ".join(words.split()).strip(" :;,") for _, words, _ in joined(RUN.finditer(code), code, flags)]
            yield f"{path}:{line}", [words for words in said if len(re.findall(r"[A-Za-z]{2,}", words)) >= 2], "throw " in RUN.sub("", code) and "DataError(" not in code


def quotes(page):
    """Returns the texts in backticks in the first columns of the tables of a page."""
    first_columns = re.findall(r"(?m)^\| (.*?) (?<!\\)\|", page)
    found = [single or double for cell in first_columns for double, single in re.findall(r"`` ?(.+?) ?``|`([^`]+)`", cell)]
    return [quote.replace("\\|", "|") for quote in found]


def main():
    root = pathlib.Path(sys.argv[1])
    found = list(texts(root))
    said = sorted({words for _, all_words, _ in found for words in all_words})
    if "--list" in sys.argv:
        print("\n".join(said))
        return 0
    thrown = [(place, " ".join(words)) for place, words, throws in found if throws and len(" ".join(words).split()) > 4]
    faults = [f"{place}: does not say what to do: {words}" for place, words in thrown if not REMEDY.search(words) and not REMEDY_ELSEWHERE.search(words)]
    for quote in quotes((root / "docs/errors.md").read_text()):
        if not any(quote in words for words in said):
            faults.append(f"docs/errors.md quotes what no source says: {quote}")
    if len(thrown) < 100:
        faults.append(f"only {len(thrown)} statements that throw were found")
    print("\n".join(faults + [f"{len(said)} texts, {len(thrown)} statements that throw, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
