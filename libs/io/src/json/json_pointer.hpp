#pragma once

#include <string>

#include "beadswim/io/json.hpp"

namespace beadswim {

/// Returns "/key", with the key escaped according to RFC 6901.
inline std::string pointer_step(const std::string& key) {
  return (Json::json_pointer() / key).to_string();
}

}  // namespace beadswim
