#!/usr/bin/env python3
"""Prints the notes of a figure of beadswim-plot as one line, and checks them: figure_notes.py FIGURE.svg

Exit status 1 if the notes have more than 60 words, if a note lies over the drawing, or if it leaves the page.
"""

import re
import sys
import xml.etree.ElementTree as xml

MAX_WORDS = 60
NOTE_SIZE = 10.0  # font size, which only notes have [px]
GLYPH_WIDTH = 5.5  # mean width of a letter of a note [px]


def tag(element):
    return element.tag.split("}")[-1]


def is_note(element):
    return (tag(element) == "text" and float(element.get("font-size", 0)) == NOTE_SIZE
            and element.get("text-anchor") == "start")


def bottom(element):
    """Returns the largest y of an element of the drawing, or 0 if the element has no position."""
    if tag(element) == "rect" and element.get("y"):
        return float(element.get("y")) + float(element.get("height"))
    if tag(element) == "circle":
        return float(element.get("cy")) + float(element.get("r"))
    if tag(element) == "line":
        return max(float(element.get("y1")), float(element.get("y2")))
    if tag(element) in ("polyline", "path"):
        numbers = re.findall(r"-?\d+(?:\.\d+)?", element.get("points") or element.get("d"))
        return max(map(float, numbers[1::2]), default=0)
    return float(element.get("y")) if tag(element) == "text" else 0


def faults(root, notes):
    words = sum(len(note.text.split()) for note in notes)
    if words > MAX_WORDS:
        yield f"{words} words in the notes, at most {MAX_WORDS}"
    drawing = max(bottom(element) for element in root.iter() if not is_note(element))
    for note in notes:
        x, y = float(note.get("x")), float(note.get("y"))
        if y - NOTE_SIZE < drawing:
            yield f"a note at y = {y} lies over the drawing, which ends at {drawing}: {note.text}"
        if x + GLYPH_WIDTH * len(note.text) > float(root.get("width")) or y > float(root.get("height")):
            yield f"a note leaves the page: {note.text}"


def main():
    root = xml.parse(sys.argv[1]).getroot()
    notes = [element for element in root.iter() if is_note(element)]
    print(" ".join(note.text for note in notes))
    found = list(faults(root, notes))
    for fault in found:
        print(f"{sys.argv[1]}: {fault}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
