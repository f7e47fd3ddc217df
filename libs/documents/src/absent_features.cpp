#include "absent_features.hpp"

#include <array>
#include <set>
#include <string_view>

#include "beadswim/core/error.hpp"

namespace beadswim {
namespace {

struct AbsentFeature {
  std::set<std::string_view> keys;
  const char* explanation;
};

const std::array<AbsentFeature, 3>& absent_features() {
  static const std::array<AbsentFeature, 3> features{
      {{{"background_flow", "imposed_flow", "external_flow", "inflow", "shear", "shear_rate", "strain_rate",
         "velocity_gradient", "pressure_gradient", "wall_velocity", "wall_velocities"},
        "imposed flow has other keys: \"flow\" of the layout for a linear flow of unbounded fluid, "
        "\"body_force\" and moving walls for flow between no-slip walls; remove the key"},
       {{"stroke", "strokes", "prescribed_stroke", "kinematics", "gait", "waveform", "arm_length",
         "arm_lengths", "arm_amplitudes", "arm_phases", "rest_length", "rest_lengths"},
        "version 1 of the layout has no prescribed stroke: harmonic forces drive the beads (amplitude, "
        "phase, "
        "period of \"driving\"); remove the key, or prescribe lengths and angles in a layout of version 2 "
        "(beadswim-layout shape prescribed-three-bead)"},
       {{"gravity", "external_force", "temperature", "kT", "thermal_noise", "noise"},
        "this version has neither gravity nor thermal noise; remove the key, or set constant forces on beads "
        "in "
        "a layout of version 2 with the key net_force (beadswim-layout shape sphere)"}}};
  return features;
}

/// Throws InputError if a key of the JSON object requests a feature that this version does not have. Does
/// nothing if the value is not an object.
void refuse_keys(const Json& object, const std::string& place) {
  if (!object.is_object()) return;
  for (const auto& [key, value] : object.items()) {
    for (const AbsentFeature& feature : absent_features()) {
      if (feature.keys.contains(key)) throw InputError(place + "/" + key, feature.explanation);
    }
  }
}

const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  return object.is_object() && object.contains(key) ? object[key] : nothing;
}

}  // namespace

void refuse_absent_features(const Json& layout, const std::string& source) {
  refuse_keys(layout, source + ":");
  for (const char* part : {"fluid", "domain"}) refuse_keys(member(layout, part), source + ":/" + part);
  const auto refuse_in = [&](const Json& object, const std::string& place) {
    refuse_keys(object, place);
    refuse_keys(member(object, "driving"), place + "/driving");
  };
  for (const auto& [name, type] : member(layout, "types").items())
    refuse_in(type, source + ":/types/" + name);
  const Json& swimmers = member(layout, "swimmers");
  if (!swimmers.is_array()) return;
  for (std::size_t s = 0; s < swimmers.size(); ++s)
    refuse_in(swimmers[s], source + ":/swimmers/" + std::to_string(s));
}

}  // namespace beadswim
