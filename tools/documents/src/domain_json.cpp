#include "domain_json.hpp"

#include "beadswim/scene/names.hpp"

namespace beadswim {

Json vec3_to_json(const Vec3& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

Vec3 vec3_from_json(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json domain_to_json(const std::optional<Box>& domain) {
  if (!domain) return nullptr;
  Json boundary = Json::array();
  for (const Boundary closes : domain->boundary) boundary.push_back(to_name(boundary_names, closes));
  return {{"lengths", vec3_to_json(domain->lengths)}, {"boundary", boundary}};
}

std::optional<Box> domain_from_json(const Json& json) {
  if (json.is_null()) return std::nullopt;
  Box domain{.lengths = vec3_from_json(json.at("lengths"))};
  for (int axis = 0; axis < 3; ++axis) {
    domain.boundary[axis] =
        from_name(boundary_names, json.at("boundary").at(axis).get<std::string>()).value();
  }
  return domain;
}

}  // namespace beadswim
