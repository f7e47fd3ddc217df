#include "beadswim/core/xml_text.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace beadswim {
namespace {

const std::map<char, std::string> escapes{{'&', "&amp;"}, {'<', "&lt;"},   {'>', "&gt;"},  {'"', "&quot;"},
                                          {'\t', "&#9;"}, {'\n', "&#10;"}, {'\r', "&#13;"}};

/// Returns the number of bytes of the character at `at`; 0 if it is not a character of XML in UTF-8.
std::size_t character_bytes(const std::string& text, std::size_t at) {
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};  // of 1 to 4 bytes
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t bytes = byte(at) < 0x80 ? 1 : byte(at) < 0xE0 ? 2 : byte(at) < 0xF0 ? 3 : 4;
  if (at + bytes > text.size()) return 0;
  if (bytes == 1) return byte(at) >= 0x20 || escapes.contains(text[at]) ? 1 : 0;
  char32_t code = byte(at) - (0xF00U >> bytes & 0xFFU);
  for (std::size_t i = at + 1; i < at + bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool is_surrogate = code >> 11U == 0x1BU;
  return code >= smallest[bytes] && code < 0x110000 && !is_surrogate && code >> 1U != 0x7FFFU ? bytes : 0;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string result;
  for (std::size_t at = 0, bytes = 0; at < text.size(); at += std::max<std::size_t>(bytes, 1)) {
    bytes = character_bytes(text, at);
    const auto escape = escapes.find(text[at]);
    result += bytes == 0 ? "\xEF\xBF\xBD" : escape != escapes.end() ? escape->second : text.substr(at, bytes);
  }
  return result;
}

std::string plain_text(std::string xml) {
  for (std::size_t at = xml.find('&'); at != std::string::npos; at = xml.find('&', at + 1)) {
    const auto is_here = [&](const auto& escape) {
      return xml.compare(at, escape.second.size(), escape.second) == 0;
    };
    if (const auto escape = std::ranges::find_if(escapes, is_here); escape != escapes.end())
      xml.replace(at, escape->second.size(), 1, escape->first);
  }
  return xml;
}

}  // namespace beadswim
