#pragma once

#include <cstddef>
#include <string>
#include <vector>

// What all kinds of drawings have in common: their form as text, and the notes below them, which say what is
// drawn, its parameters, and what to see.

namespace beadswim {

/// A drawing as text. Equal input has equal bytes: palette and number formats are fixed, and no date is
/// written.
struct Drawing {
  std::string svg;  ///< a complete SVG document
  std::string csv;  ///< the numbers that are drawn, as comma-separated values
};

/// Label of an axis or of a colour bar: "quantity (unit)", or "quantity" if the unit is empty.
struct AxisLabel {
  std::string quantity;
  std::string unit{};
};

/// Converts an SVG document to PDF if the name `path` of the output file ends in .pdf, otherwise to PNG, with
/// the program rsvg-convert of librsvg. A PNG image has twice the size of the document, for a better
/// resolution in print. Throws InputError if rsvg-convert is not installed, and SolverError if it fails.
std::string converted_svg(const std::string& svg, const std::string& path);

/// Largest number of words in all notes of one drawing together. A word is a text between spaces: "T = 4800"
/// has three words.
inline constexpr std::size_t max_note_words = 60;

struct Note {
  std::string text{};
  std::string summary{};  ///< shorter text for drawings with too many words; empty: there is none
};

/// Returns the texts of the notes that are not empty, with at most max_note_words words together. While there
/// are too many words, replaces texts by their summaries, from the last note to the first. Then omits notes
/// from the last to the first. Put the most important note first.
std::vector<std::string> shorten_notes(const std::vector<Note>& notes);

}  // namespace beadswim
