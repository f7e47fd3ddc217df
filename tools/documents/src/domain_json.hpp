#pragma once

#include <optional>

#include "beadswim/io/json.hpp"
#include "beadswim/scene/layout.hpp"

namespace beadswim {

/// [x, y, z].
Json vec3_to_json(const Vec3& vector);
Vec3 vec3_from_json(const Json& json);

/// { "lengths", "boundary" }, or null for unbounded fluid.
Json domain_to_json(const std::optional<Box>& domain);

/// The inverse, of JSON that a schema has let through.
std::optional<Box> domain_from_json(const Json& json);

}  // namespace beadswim
