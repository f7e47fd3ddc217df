#!/usr/bin/env python3
"""Checks that tests/docs/messages.txt lists all messages in the sources, and that docs/errors.md quotes no other messages.

    messages.py SOURCE-FOLDER            compares; exit status 1 if they differ
    messages.py SOURCE-FOLDER --list     writes tests/docs/messages.txt

A message is the text of the string literals in a statement that throws or prints an error, a warning or a notice, and in the functions
of the files in SPEAKING, which return reasons. "…" stands for an inserted value; a setting is replaced by its flag, as in the programs.
docs/errors.md quotes messages, or parts of them, in backticks in the first column of its tables.
"""

import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\\n]|\\.)*"'
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|" + LITERAL + r"|'(?:[^'\\\n]|\\.)+'", re.S)
RUN = re.compile(r"(?:" + LITERAL + r"\s*)+")
LOUD = re.compile(r"\bthrow\b|\bInputError\(|\brefuse\w*\(|\bfail\w*\(|\btell\(|\bfaults?\b|\blines\.push_back|\bmessages\.push_back|\bwarnings\.push_back|stderr|refused =")
QUIET = re.compile(r"add_option|add_flag|->check|assert|validity|verdict|settings|notes")
# Files whose functions return texts that other files throw or print.
SPEAKING = {
    "absent_features.cpp", "box_methods.cpp", "box_mobility.cpp", "closed_form_methods.cpp", "fault_message.cpp", "force_directions.cpp", "h5md.cpp", "inertia_methods.cpp",
    "json_parse.cpp", "flag_values.cpp", "nearest_name.cpp", "overdamped_model.cpp", "plan_flags.cpp", "periodic_motion.cpp", "perturbation_methods.cpp", "planned_lattices.cpp",
    "planned_scene.cpp", "program.cpp", "question.cpp", "run_loop.cpp", "run_plan.cpp", "schema_name.cpp", "surroundings.cpp",
    "trajectory_reader.cpp", "value_fault.cpp", "warnings.cpp", "options.cpp", "flags.cpp",
}
# Parts of other messages, places at the beginning of a message, and messages of other libraries.
SILENT = re.compile(
    r"^(/|\{|--|one of$|or an object|Read more|beadswim-layout (reduce|swimmer)|beadswim-run: …$|Object |Failed to|Array should|Missing|Value type|Expected|[^ ]*$"
    r"|of swimmer|bead … of|… at \(|predicted|\(4\.|exact |the layout's box|greater than$|at least$|less than$|at most$|must be$"
    r"|line …|statistics of cycle|spheres (…|on)|flow on|mobility of near|box edge|no file$|one file$|command line$|RUN\.|open space"
    r"|stroke fit|step … of|… of itself|a fault of the run|temporary file|its length along|the line at|through the periodic)"
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


def messages_of(path, flags):
    text = without_comments(path.read_text())
    ends = [0] + [m.end() for m in re.finditer(r"(?<!')[;{}]\n|:\n", RUN.sub(lambda m: "_" * len(m.group()), text))] + [len(text)]
    for begin, end in zip(ends, ends[1:]):
        statement = text[begin:end]
        code = RUN.sub("", statement)
        speaks = LOUD.search(code) or path.name in SPEAKING
        if not speaks or re.search(r"\b(set_footer|begin_group|add_choice|add_switch|add_word|add_marks)\(", code):
            continue
        for start, words, _ in joined(RUN.finditer(statement), statement, flags):
            words = " ".join(words.split()).strip(" :;,")
            if QUIET.search(code) and not LOUD.search(code):
                continue
            if len(re.findall(r"[A-Za-z]{2,}", words)) >= 2 and not SILENT.match(words) and not re.search(r"[^.]\.$", words):
                yield text.count("\n", 0, begin + start) + 1, words


def messages(root):
    found = {}
    flags = dict(re.findall(r'\{(Setting::\w+), "([^"]+)"\}', (root / "tools/common/src/flag_names.cpp").read_text()))
    for path in sorted(p for f in ["libs", "tools"] for p in (root / f).rglob("*.[ch]pp")):
        for line, words in messages_of(path, flags):
            found.setdefault(words, f"{path.relative_to(root)}:{line}")
    return found


def quotes(page):
    """Returns the texts in backticks in the first columns of the tables of a page."""
    first_columns = re.findall(r"(?m)^\| (.*?) (?<!\\)\|", page)
    found = [single or double for cell in first_columns for double, single in re.findall(r"`` ?(.+?) ?``|`([^`]+)`", cell)]
    return [quote.replace("\\|", "|") for quote in found]


def main():
    root = pathlib.Path(sys.argv[1])
    list_file, found = root / "tests/docs/messages.txt", messages(root)
    if "--list" in sys.argv:
        list_file.write_text("".join(f"{words}\n" for words in sorted(found)))
        return 0
    listed = set(list_file.read_text().splitlines())
    faults = [f"new: {words} ({place})" for words, place in found.items() if words not in listed]
    faults += [f"gone: {words}" for words in sorted(listed - set(found))]
    if faults:
        faults.append("tests/docs/messages.txt is stale; write it again: python3 -B tests/docs/messages.py . --list")
    for quote in quotes((root / "docs/errors.md").read_text()):
        if not any(quote in words for words in found):
            faults.append(f"docs/errors.md quotes what no source says: {quote}")
    print("\n".join(faults + [f"{len(found)} messages, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
