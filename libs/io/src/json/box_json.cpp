#include "beadswim/io/fields_json.hpp"

namespace beadswim {

void to_json(Json& json, const Box& box) {
  Json boundary = Json::array();
  for (int a = 0; a < 3; ++a) {
    const std::string name = to_text(box.boundary[a]);
    boundary.push_back(box.walls[a].are_moving() ? Json{{name, box.walls[a]}} : Json(name));
  }
  json = {{"lengths", box.lengths}, {"boundary", boundary}};
}

void from_json(const Json& json, Box& box) {
  json.at("lengths").get_to(box.lengths);
  for (int a = 0; a < 3; ++a) {
    const Json& boundary = json.at("boundary").at(a);
    box.walls[a] = {};
    if (boundary.is_object()) {
      box.boundary[a] = Boundary::no_slip;
      boundary.at(to_text(Boundary::no_slip)).get_to(box.walls[a]);
    } else {
      boundary.get_to(box.boundary[a]);
    }
  }
}

void to_json(Json& json, const Domain& domain) {
  if (domain.half_space) {
    json = {{"half_space",
             {{"axis", std::string(1, "xyz"[domain.half_space->axis])},
              {"boundary", to_text(Boundary::no_slip)}}}};
  } else {
    json = domain.box;
  }
}

void from_json(const Json& json, Domain& domain) {
  domain = {};
  if (json.is_object() && json.contains("half_space")) {
    domain.half_space = half_space_across(json.at("half_space").at("axis").get<std::string>());
  } else {
    json.get_to(domain.box);
  }
}

}  // namespace beadswim
