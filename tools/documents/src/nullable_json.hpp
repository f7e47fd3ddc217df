#pragma once

#include <optional>

#include "beadswim/io/json.hpp"

// Values that documents may leave null.

namespace beadswim {

template <typename Value>
Json json_or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json(nullptr);
}

template <typename Value>
std::optional<Value> value_unless_null(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<Value>());
}

}  // namespace beadswim
