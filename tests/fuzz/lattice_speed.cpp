#include "beadswim/plan/lattice_speed.hpp"

#include <cmath>
#include <optional>

#include "documents_agree.hpp"

// Fuzz target: the cache file of the measured speed of lattice steps. Any contents must be accepted
// completely or replaced by a new measurement.

using namespace beadswim;

namespace {

CoupledScene scene_of(int edge, BeadScheme scheme) {
  CoupledScene scene;
  scene.cells = {edge, edge, edge};
  scene.bead_boundary = scheme;
  scene.types.resize(1);
  scene.types[0].beads.assign(3, {{.radius = 4, .density = 1}});
  scene.swimmers = {{.id = 0, .type = 0, .position = {9, 9, 9}}};
  return scene;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Json given;
  std::optional<LatticeSpeed> speed;
  try {
    given = parse_json(text_of(data, size), "cache");
    speed = lattice_speed_from_json(given);
  } catch (const std::exception&) {  // as speed_of_this_machine takes it
    return 0;
  }
  const auto written = written_again(
      given, [](const Json& json) { return lattice_speed_to_json(lattice_speed_from_json(json)); });
  require(written && written->at("precisions") == lattice_speed_to_json(*speed).at("precisions"),
          "the same speeds");
  for (const int edge : {20, 1000}) {
    for (const BeadScheme scheme : all_values<BeadScheme>) {
      const double seconds = speed->step(scene_of(edge, scheme));
      require(std::isfinite(seconds) && seconds > 0, "a step takes time");
    }
  }
  return 0;
}
