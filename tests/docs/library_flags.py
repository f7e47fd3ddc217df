#!/usr/bin/env python3
"""Checks that no string and no comment of the libraries names a flag. Libraries name settings instead (core/setting.hpp).

    library_flags.py SOURCE-FOLDER       exit status 1 if a flag is found
"""

import pathlib
import re
import sys

from messages import TOKEN

FLAG = re.compile(r"(?<![\w-])--[a-z]|^\"-[a-z]\"$|mpirun -n")
OF_RSVG_CONVERT = {'"--zoom=1"', '"--zoom=2"', '"--format=png"', '"--format=pdf"'}


def main():
    root = pathlib.Path(sys.argv[1])
    faults = []
    for path in sorted((root / "libs").rglob("*.[ch]pp")):
        text = path.read_text()
        faults += [
            f"{path.relative_to(root)}:{text.count(chr(10), 0, m.start()) + 1}: names a flag: {m.group()}"
            for m in TOKEN.finditer(text)
            if FLAG.search(m.group()) and m.group() not in OF_RSVG_CONVERT
        ]
    print("\n".join(faults + [f"{len(faults)} faults"]))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
