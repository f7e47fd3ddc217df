#include "beadswim/core/xml_text.hpp"

#include <algorithm>
#include <array>

namespace beadswim {
namespace {

/// Returns the number of bytes of the character that begins at `at`; 0 if it is not a character of XML in
/// UTF-8.
std::size_t character_bytes(const std::string& text, std::size_t at) {
  constexpr std::array<char32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000};  // of 1 to 4 bytes
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t bytes = byte(at) < 0x80 ? 1 : byte(at) < 0xE0 ? 2 : byte(at) < 0xF0 ? 3 : 4;
  if (at + bytes > text.size()) return 0;
  char32_t code = bytes == 1 ? byte(at) : byte(at) - (0xF00U >> bytes & 0xFFU);
  for (std::size_t i = at + 1; i < at + bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return 0;
    code = code << 6U | (byte(i) & 0x3FU);
  }
  const bool is_allowed = code == '\t' || code == '\n' || code == '\r' || (code >= 0x20 && code < 0xD800) ||
                          (code >= 0xE000 && code < 0xFFFE) || (code >= 0x10000 && code < 0x110000);
  return is_allowed && code >= smallest[bytes] ? bytes : 0;
}

}  // namespace

std::string xml_text(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t bytes = character_bytes(text, at);
    const char c = text[at];
    const bool is_space = c == '\t' || c == '\n' || c == '\r';  // a plain one would become a blank
    result += bytes == 0 ? "\xEF\xBF\xBD"
              : c == '&' ? "&amp;"
              : c == '<' ? "&lt;"
              : c == '>' ? "&gt;"
              : c == '"' ? "&quot;"
              : is_space ? "&#" + std::to_string(c) + ";"
                         : text.substr(at, bytes);
    at += std::max<std::size_t>(bytes, 1);
  }
  return result;
}

}  // namespace beadswim
