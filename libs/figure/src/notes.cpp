#include <sstream>

#include "svg.hpp"

namespace beadswim {
namespace {

constexpr double note_size = 10, note_pitch = 15;  // [px]

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::size_t count_words(const std::vector<std::string>& texts) {
  std::size_t count = 0;
  for (const std::string& text : texts) count += words_of(text).size();
  return count;
}

/// Returns the parts of a text between which a line can break: words, or equations such as "T = 4800".
std::vector<std::string> unbreakable_parts(const std::string& text) {
  const auto is_sign = [](const std::string& word) { return word == "=" || word == "×"; };
  std::vector<std::string> parts;
  bool after_sign = false;
  for (const std::string& word : words_of(text)) {
    if (!parts.empty() && (after_sign || is_sign(word))) {
      parts.back() += " " + word;
    } else {
      parts.push_back(word);
    }
    after_sign = is_sign(word);
  }
  return parts;
}

/// Breaks a text into lines that are at most `width` [px] wide. A part that is wider has a line of its own.
std::vector<std::string> wrap(const std::string& text, double width) {
  std::vector<std::string> lines;
  for (const std::string& part : unbreakable_parts(text)) {
    const bool fits = !lines.empty() && svg::text_width(lines.back() + " " + part, note_size) <= width;
    if (fits) {
      lines.back() += " " + part;
    } else {
      lines.push_back(part);
    }
  }
  return lines;
}

}  // namespace

std::vector<std::string> shorten_notes(const std::vector<Note>& notes) {
  std::vector<std::string> texts;
  for (const Note& note : notes) texts.push_back(note.text);
  for (std::size_t i = notes.size(); i-- > 0 && count_words(texts) > max_note_words;) {
    if (!notes[i].summary.empty()) texts[i] = notes[i].summary;
  }
  while (count_words(texts) > max_note_words) texts.pop_back();
  std::erase(texts, "");
  return texts;
}

svg::NoteBlock svg::draw_notes(const std::vector<Note>& notes, svg::Point top_left, double width) {
  NoteBlock block{.elements = "", .bottom = top_left.y() - note_pitch};
  for (const std::string& text : shorten_notes(notes)) {
    for (const std::string& line : wrap(text, width)) {
      block.bottom += note_pitch;
      block.elements += svg::text({top_left.x(), block.bottom}, line, {.size = note_size});
    }
  }
  if (!block.elements.empty()) block.elements = "<g class=\"notes\">\n" + block.elements + "</g>\n";
  return block;
}

}  // namespace beadswim
