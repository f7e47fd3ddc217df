#!/usr/bin/env python3
"""The messages in the sources, and whether docs/errors.md has each of them and no other.

    messages.py SOURCE-FOLDER            compares; exit status 1 if they differ
    messages.py SOURCE-FOLDER --list     prints place and message

A message is what string literals say in a statement that throws, refuses, warns or tells, and in the functions of SPEAKING that
return reasons; "…" stands for what is put in, but settings have their flag there, as in the programs. On the page it is what stands in backticks in the first column of a table.
"""

import pathlib
import re
import sys

LITERAL = r'"(?:[^"\\\n]|\\.)*"'
TOKEN = re.compile(r"//[^\n]*|/\*.*?\*/|" + LITERAL + r"|'(?:[^'\\\n]|\\.)+'", re.S)
RUN = re.compile(r"(?:" + LITERAL + r"\s*)+")
LOUD = re.compile(r"\bthrow\b|\bInputError\(|\brefuse\w*\(|\bfail\w*\(|\btell\(|\bfaults?\b|\blines\.push_back|\bmessages\.push_back|stderr|refused =")
QUIET = re.compile(r"add_option|add_flag|->check|assert|validity|verdict|settings|notes")
# Files whose functions return what others throw, warn of or plan by.
SPEAKING = {
    "box_methods.cpp", "box_mobility.cpp", "closed_form_methods.cpp", "fault_message.cpp", "h5md.cpp", "inertia_methods.cpp",
    "json_parse.cpp", "flag_values.cpp", "nearest_name.cpp", "overdamped_model.cpp", "plan_flags.cpp", "periodic_motion.cpp", "perturbation_methods.cpp", "planned_lattices.cpp",
    "planned_scene.cpp", "program.cpp", "question.cpp", "run_loop.cpp", "run_plan.cpp", "schema_name.cpp", "surroundings.cpp",
    "trajectory_reader.cpp", "value_fault.cpp", "warnings.cpp", "options.cpp", "flags.cpp",
}
# Parts of other messages, places that begin one, and what other libraries say.
SILENT = re.compile(
    r"^(/|\{|--|beadswim-layout (reduce|swimmer)|beadswim-run: …$|Object |Failed to|Array should|Missing|Value type|Expected|[^ ]*$"
    r"|of swimmer|bead … of|… at \(|predicted|\(4\.|exact |the layout's box|greater than$|at least$|less than$|at most$|must be$"
    r"|line …|statistics of cycle|spheres (…|on)|flow on|mobility of near|box edge|no file$|one file$|command line$|RUN\.|open space"
    r"|stroke fit|step … of|… of itself|a fault of the run|temporary file|its length along|the line at|through the periodic)"
)


def without_comments(text):
    blank = lambda m: re.sub(r"[^\n]", " ", m.group()) if m.group().startswith(("//", "/*")) else m.group()
    return re.sub(r"#\s*include[^\n]*", lambda m: " " * len(m.group()), TOKEN.sub(blank, text))


def arguments(code):
    """Of a call, from the comma after its first argument, or what else stands there, to its end."""
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
    """As the user reads it, with … for what is put in, and the flag for a setting."""
    text = "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals))
    text = text.replace("{{", "\0").replace("}}", "\1")
    values = iter(values)
    text = re.sub(r"\{[^}]*\}", lambda m: flags.get(next(values, ""), "…"), text).replace("\0", "{").replace("\1", "}")
    return text.replace('\\"', '"').replace("\\n", " ").replace("\\t", " ")


def joined(runs, text, flags):
    """Runs of literals of one statement; those with only "+ value +" between them are one message."""
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


def main():
    root = pathlib.Path(sys.argv[1])
    found = messages(root)
    if "--list" in sys.argv:
        print("\n".join(f"{place}: {words}" for words, place in found.items()))
        return 0
    page = (root / "docs/errors.md").read_text()
    told = {row.replace("\\|", "|") for row in re.findall(r"(?m)^\| `` ?(.*?) ?`` \|", page)}
    faults = [f"docs/errors.md lacks: {w} ({place})" for w, place in found.items() if w not in told]
    faults += [f"docs/errors.md has, and no source says: {w}" for w in sorted(told - set(found))]
    print("\n".join(faults + [f"{len(found)} messages, {len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
