#include "beadswim/scene/combine.hpp"

#include <fmt/core.h>

#include <numeric>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/scene_differences.hpp"
#include "beadswim/scene/units.hpp"
#include "beadswim/swimmers/three_bead_swimmer.hpp"

namespace beadswim {
namespace {

/// Throws InputError if the fluid, the domain or the flow of a part differs from that of the first part.
void require_same_surroundings(const ScenePart& first, const ScenePart& part) {
  require_same_units(first.layout, part.layout, part.source);
  std::vector<SceneDifference> differences;
  add_differences(differences, common_properties(first.layout), common_properties(part.layout));
  std::erase_if(differences, [](const SceneDifference& d) { return d.name == "swimmers"; });
  if (differences.empty()) return;
  std::string text;
  for (const SceneDifference& d : differences)
    text += fmt::format("{}the {} is {}, but {} in {}", text.empty() ? "" : "; ", d.name, d.reference, d.run,
                        first.source);
  throw InputError(part.source, text + "; use the same fluid and domain in all layouts");
}

/// Moves the swimmers of a part to their places in the combined scene.
void place_swimmers(ScenePart& part) {
  Layout& layout = part.layout;
  std::vector<Swimmer>& swimmers = layout.swimmers;
  const Vec3 sum =
      std::accumulate(swimmers.begin(), swimmers.end(), Vec3(Vec3::Zero()),
                      [](const Vec3& x, const Swimmer& swimmer) { return x + swimmer.position; });
  const Vec3 centre = sum / static_cast<double>(swimmers.size());
  const bool turns = !part.turn.isApprox(Eigen::Quaterniond::Identity(), 0);
  for (Swimmer& swimmer : swimmers) {
    if (turns) {
      turn_swimmer(swimmer, layout.resolved_type(swimmer), part.turn);
      swimmer.move_to(centre + part.turn * (swimmer.position - centre));
    }
    swimmer.move_to(wrapped(swimmer.position + part.displacement, layout.domain.box));
  }
}

/// Adds the type to the scene, unless it has an equal one of this name. Returns its name in the scene.
std::string add_type(Layout& scene, const std::string& name, const SwimmerType& type) {
  const auto [found, is_new] = scene.types.try_emplace(name, type);
  if (is_new || found->second == type) return name;
  for (const auto& [other_name, other] : scene.types)
    if (other == type) return other_name;
  const std::string free = free_type_name(scene);
  scene.types[free] = type;
  return free;
}

}  // namespace

std::string free_type_name(const Layout& layout) {
  for (char letter = 'b'; letter <= 'z'; ++letter) {
    if (!layout.types.contains(std::string(1, letter))) return std::string(1, letter);
  }
  int n = 1;
  while (layout.types.contains(fmt::format("a{}", n))) ++n;
  return fmt::format("a{}", n);
}

void require_same_units(const Layout& layout, const Layout& other, const std::string& source) {
  const auto same = [](const Units::Unit& a, const Units::Unit& b) { return a.si_factor == b.si_factor; };
  const Units &a = layout.units, &b = other.units;
  const bool equal =
      a.lattice == b.lattice &&
      (a.lattice || (same(a.length, b.length) && same(a.time, b.time) && same(a.mass, b.mass)));
  if (!equal)
    throw InputError(source,
                     "the units of this layout ({}) differ from the units ({}) of the layout with which it "
                     "is combined; convert one of them",
                     unit_names(b), unit_names(a));
}

void turn_swimmer(Swimmer& swimmer, const SwimmerType& type, const Eigen::Quaterniond& turn) {
  swimmer.turn_start(turn);
  // Three beads on a line, which forces along it drive, do not depend on a turn about it.
  if (!swimmer.turn && three_bead_form(type)) {
    swimmer.axis = (turn * swimmer.axis).normalized();
    return;
  }
  swimmer.turn = (turn * Eigen::Quaterniond(swimmer.orientation())).normalized();
  swimmer.axis = swimmer.turn->toRotationMatrix().col(0);
}

Layout combine(std::span<const ScenePart> parts) {
  Layout scene = parts.front().layout;
  scene.types.clear();
  scene.swimmers.clear();
  for (ScenePart part : parts) {
    require_same_surroundings(parts.front(), part);
    place_swimmers(part);
    if (part.layout.resolution != scene.resolution) scene.resolution.reset();
    std::map<std::string, std::string> names;
    for (const auto& [name, type] : part.layout.types) names[name] = add_type(scene, name, type);
    for (Swimmer& swimmer : part.layout.swimmers) {
      swimmer.type = names.at(swimmer.type);
      swimmer.id = static_cast<int>(scene.swimmers.size());
      scene.swimmers.push_back(std::move(swimmer));
    }
  }
  return scene;
}

}  // namespace beadswim
