#pragma once

#include <string>
#include <vector>

#include "beadswim/figure/note.hpp"
#include "svg.hpp"

namespace beadswim {

/// Notes as SVG elements.
struct NoteBlock {
  std::string elements;  ///< a group of the class "notes"; empty if there is no note
  double bottom = 0;     ///< baseline of the last line, or one line above `top_left` if there is no note [px]
};

/// Draws the notes of a drawing, shortened by shorten_notes(). Each note starts a new line, and is wrapped to
/// `width` [px]. `top_left` is the start of the baseline of the first line.
NoteBlock draw_notes(const std::vector<Note>& notes, svg::Point top_left, double width);

}  // namespace beadswim
