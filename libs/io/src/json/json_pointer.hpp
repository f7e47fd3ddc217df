#pragma once

#include <string>

namespace beadswim {

/// "/key" with the key escaped as RFC 6901 asks: ~ is ~0, / is ~1.
inline std::string pointer_step(const std::string& key) {
  std::string step = "/";
  for (const char c : key) {
    if (c == '~') {
      step += "~0";
    } else if (c == '/') {
      step += "~1";
    } else {
      step += c;
    }
  }
  return step;
}

}  // namespace beadswim
