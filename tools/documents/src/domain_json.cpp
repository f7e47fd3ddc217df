#include "domain_json.hpp"

namespace beadswim {

void to_json(Json& json, Boundary boundary) {
  json = to_name(boundary_names, boundary);
}

void from_json(const Json& json, Boundary& boundary) {
  boundary = from_name(boundary_names, json.get<std::string>()).value();
}

void to_json(Json& json, DrivingFrame frame) {
  json = to_name(frame_names, frame);
}

void from_json(const Json& json, DrivingFrame& frame) {
  frame = from_name(frame_names, json.get<std::string>()).value();
}

}  // namespace beadswim
