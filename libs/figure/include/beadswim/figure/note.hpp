#pragma once

#include <cstddef>
#include <string>
#include <vector>

// Notes below a drawing: what is drawn, its parameters, and what to see.

namespace beadswim {

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
