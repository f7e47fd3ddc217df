#pragma once

#include <string>

namespace beadswim {

/// Returns a text as a field of comma-separated values, in quotation marks.
inline std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += c == '"' ? std::string("\"\"") : std::string(1, c);
  return all + "\"";
}

}  // namespace beadswim
