#include "beadswim/plan/representatives.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/theory/surroundings.hpp"
#include "stand_in.hpp"
#include "swimmer_in_box.hpp"

namespace beadswim {
namespace {

/// Returns a periodic box for one swimmer that stands for its part of `box`. Its dimensions are
///   volume  about V = (volume of `box`)/swimmers
///   length  L/n, where L is the edge of `box` along the swimmer and n the largest integer for which L/n is
///           at least 1.2 swimmer lengths and at least the cube root of V
///   width   sqrt(V/length)
/// The length is increased to 1.2 swimmer lengths and the width to four bead radii if they are smaller.
BoxPlace share_of(const Box& box, std::size_t swimmers, const CollinearSwimmer& swimmer, const Vec3& axis) {
  constexpr double room = 1.2, radii_across = 4;
  int along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  const double box_length = box.lengths[along], share = box.lengths.prod() / static_cast<double>(swimmers);
  const double min_length = room * swimmer_length(swimmer);
  const double blocks = std::max(1.0, std::floor(box_length / std::max(min_length, std::cbrt(share))));
  const double x = std::max(box_length / blocks, min_length);
  const double y = std::max(std::sqrt(share / x), radii_across * *std::ranges::max_element(swimmer.radius));
  return box_place_at_centre({x, y, y});
}

/// Returns the type, driven only by the component of its forces along the swimmer's axis.
ThreeBeadSwimmer driven_along_its_line(ThreeBeadSwimmer type, const Vec3& axis) {
  for (double& amplitude : type.driving.amplitude) amplitude *= axis.x();
  type.driving.frame = DrivingFrame::body;
  return type;
}

/// Returns true if the driving forces have a component perpendicular to the axis.
bool is_driven_across(const ThreeBeadSwimmer& type, const Vec3& axis) {
  constexpr double largest_sine = 1e-9;
  return type.driving.frame == DrivingFrame::lab && axis.cross(Vec3::UnitX()).norm() > largest_sine;
}

Representative representative(const Layout& cell, const Swimmer& swimmer) {
  Representative result;
  result.swimmer = swimmer.id;
  const SwimmerType type = cell.resolved_type(swimmer);
  const std::optional<ThreeBeadSwimmer> three = three_bead_form(type);
  result.is_stand_in = !three;
  result.type = three ? *three : stand_in(type, cell.fluid);
  const bool across = result.is_slanted = is_driven_across(result.type, swimmer.axis);
  const ThreeBeadSwimmer collinear_type =
      across ? driven_along_its_line(result.type, swimmer.axis) : result.type;
  const Surroundings surroundings = surroundings_of(cell, swimmer);
  Question& question = result.question;
  question.swimmer = collinear_swimmer(collinear_type, across ? Vec3::UnitX() : swimmer.axis,
                                       cell.fluid.dynamic_viscosity());
  question.fluid_density = cell.fluid.density;
  question.box = surroundings.box;
  std::vector<std::string> approximations;
  if (!cell.domain.box && (cell.swimmers.size() > 1 || cell.domain.half_space)) {
    approximations.push_back("alone in open space");
    if (cell.domain.half_space) approximations.push_back("without the wall");
    if (cell.swimmers.size() > 1) approximations.push_back("without neighbours");
  } else if (!surroundings.obstacle.empty()) {
    question.box = share_of(*cell.domain.box, cell.swimmers.size(), question.swimmer, swimmer.axis);
    const std::string& why = surroundings.obstacle;  // form: "reason; remedy"
    approximations.push_back("alone in its share of the box (" + why.substr(0, why.find(';')) + ")");
  }
  if (has_background_flow(cell)) approximations.push_back("in fluid without the background flow");
  if (across) approximations.push_back("driven only by the component of its forces along its axis");
  result.approximation = fmt::format("{}", fmt::join(approximations, ", "));
  question = with_exact_reference(std::move(question));
  return result;
}

/// Name of the type of a swimmer, and its driving without the phase offset: of other swimmers than three
/// beads, frame, largest force and period.
using Kind = std::tuple<std::string, DrivingFrame, double, double, double, double>;

Kind kind_of(const Layout& cell, const Swimmer& swimmer) {
  const SwimmerType type = cell.resolved_type(swimmer);
  const Driving& driving = type.driving;
  if (const std::optional<ThreeBeadSwimmer> three = three_bead_form(type)) {
    const auto& [a, b] = three->driving.amplitude;
    return {swimmer.type, driving.frame, a, b, three->driving.phase, driving.period};
  }
  return {swimmer.type, driving.frame, largest_driving_force(type), 0, 0, driving.period};
}

/// Returns the first swimmer, the swimmers with the largest and the smallest force, and the swimmers with the
/// longest and the shortest period. A swimmer with several of these properties is returned once.
std::vector<const Swimmer*> extremes(const Layout& cell, const std::vector<const Swimmer*>& all) {
  const auto force = [&](const Swimmer* swimmer) {
    return largest_driving_force(cell.resolved_type(*swimmer));
  };
  const auto period = [&](const Swimmer* swimmer) { return cell.driving_of(*swimmer).period; };
  std::vector<const Swimmer*> selected{all.front()};
  for (const Swimmer* extreme :
       {*std::ranges::max_element(all, {}, force), *std::ranges::min_element(all, {}, force),
        *std::ranges::max_element(all, {}, period), *std::ranges::min_element(all, {}, period)})
    if (std::ranges::find(selected, extreme) == selected.end()) selected.push_back(extreme);
  return selected;
}

}  // namespace

std::vector<Representative> representatives(const Layout& cell) {
  constexpr std::size_t max_drivings = 8;
  std::map<std::string, std::vector<const Swimmer*>> swimmers_by_type;
  std::set<Kind> kinds;
  std::set<std::string> known_types;  // whose driving has been seen
  for (const Swimmer& swimmer : cell.swimmers) {
    if (!swimmer.driving && !known_types.insert(swimmer.type).second) continue;
    if (kinds.insert(kind_of(cell, swimmer)).second) swimmers_by_type[swimmer.type].push_back(&swimmer);
  }
  std::vector<Representative> result;
  for (const auto& [type, swimmers] : swimmers_by_type) {
    for (const Swimmer* swimmer : swimmers.size() > max_drivings ? extremes(cell, swimmers) : swimmers)
      result.push_back(representative(cell, *swimmer));
  }
  return result;
}

}  // namespace beadswim
