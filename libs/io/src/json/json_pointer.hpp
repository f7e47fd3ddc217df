#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// "/key" with the key escaped as RFC 6901 asks.
inline std::string pointer_step(const std::string& key) {
  return (Json::json_pointer() / key).to_string();
}

}  // namespace beadswim
