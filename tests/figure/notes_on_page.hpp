#pragma once

#include <algorithm>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

// Finds the notes of a figure in its SVG document.

namespace beadswim {

inline constexpr double note_height = 10;  ///< font size of notes [px]

struct NoteLine {
  double baseline = 0;    ///< y of the text [px]
  double right = 0;       ///< estimated end of the text [px]
  std::size_t words = 0;  ///< number of texts between spaces
};

inline double page_attribute(const std::string& svg, const std::string& name) {
  return std::stod(svg.substr(svg.find(name + "=\"") + name.size() + 2));
}

inline double page_width(const std::string& svg) {
  return page_attribute(svg, " width");
}

inline double page_height(const std::string& svg) {
  return page_attribute(svg, " height");
}

inline std::vector<NoteLine> notes_on_page(const std::string& svg) {
  constexpr double glyph_width = 5.5;  // mean width of lower-case letters in DejaVu Sans of size 10 [px]
  const std::size_t start = svg.find("<g class=\"notes\">");
  if (start == std::string::npos) return {};
  const std::string group = svg.substr(start, svg.find("</g>", start) - start);
  static const std::regex element("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"[^>]*>([^<]*)<");
  std::vector<NoteLine> lines;
  for (std::sregex_iterator match(group.begin(), group.end(), element), end; match != end; ++match) {
    const std::string text = (*match)[3];
    const auto letters = std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; });
    std::istringstream words(text);
    std::size_t count = 0;
    for (std::string word; words >> word;) ++count;
    lines.push_back({.baseline = std::stod((*match)[2]),
                     .right = std::stod((*match)[1]) + glyph_width * static_cast<double>(letters),
                     .words = count});
  }
  return lines;
}

}  // namespace beadswim
