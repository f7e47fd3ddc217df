#include "beadswim/plan/representatives.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <tuple>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/plan/model_errors.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"
#include "beadswim/theory/surroundings.hpp"

namespace beadswim {
namespace {

/// Returns the length of the swimmer at rest, including the radii of beads 1 and 3 [length].
double swimmer_length(const CollinearSwimmer& swimmer) {
  return swimmer.radius[0] + swimmer.arm[0] + swimmer.arm[1] + swimmer.radius[2];
}

/// Returns a periodic box with bead 2 at its centre. The first edge is parallel to the swimmer.
BoxPlace box_place_at_centre(const Vec3& lengths) {
  return {.box = {.lengths = lengths, .boundary = {}},
          .middle_bead = {lengths[0] / 2, lengths[1] / 2, lengths[2] / 2}};
}

constexpr double arms_without_bonds = 10, shortest_arm = 2.5;  // divided by the radius
constexpr double least_swing = 0.05;                           // relative amplitude of the arms

/// Returns the largest amplitude of a bond, divided by its length; 0 if theory does not know it.
double largest_swing(const SwimmerType& type, double viscosity) {
  double largest = 0;
  reason_against([&] {
    const ShapedSwimmer swimmer{type, Eigen::Matrix3d::Identity(), viscosity};
    const ShapeMotion motion = second_order_motion(swimmer, rotne_prager_tensor);
    for (std::size_t k = 0; k < type.bonds.size(); ++k)
      largest = std::max(largest, motion.stroke.amplitude[k] / type.bonds[k].rest_length);
  });
  return largest;
}

/// Returns the three-bead swimmer for which errors are estimated instead of a swimmer of another shape. Its
/// beads have the largest radius a of the type, its arms the mean length of the bonds, at least 2.5 a (10 a
/// without bonds), its springs gamma omega/k = 1, its driving the period of the type. The driving forces give
/// its arms the largest relative amplitude of a bond by theory, at least 5 % and at most half the gap between
/// the beads.
ThreeBeadSwimmer stand_in(const SwimmerType& type, const Fluid& fluid) {
  const double viscosity = fluid.dynamic_viscosity();
  const double radius = std::ranges::max(type.beads, {}, &Bead::radius).radius;
  double arm = type.bonds.empty() ? arms_without_bonds * radius : 0;
  for (const Bond& bond : type.bonds) arm += bond.rest_length / static_cast<double>(type.bonds.size());
  arm = std::max(arm, shortest_arm * radius);
  const double omega = 2 * std::numbers::pi / type.driving.period;
  const Bead bead{.radius = radius, .density = type.beads[0].density};
  const Spring spring{.stiffness = 6 * std::numbers::pi * viscosity * radius * omega, .rest_length = arm};
  ThreeBeadSwimmer swimmer{.beads = {bead, bead, bead},
                           .springs = {spring, spring},
                           .driving = {.amplitude = {1, 1},
                                       .phase = std::numbers::pi / 2,
                                       .period = type.driving.period,
                                       .frame = DrivingFrame::body}};
  swimmer.angular_stiffness = straightening_stiffness(swimmer);
  const CollinearSwimmer line = collinear_swimmer(swimmer, Vec3::UnitX(), viscosity);
  const double by_unit_forces = std::ranges::max(first_order_stroke(line, rotne_prager).amplitude);
  const double swing =
      std::min(std::max(largest_swing(type, viscosity), least_swing) * arm, arm / 2 - radius);
  for (double& amplitude : swimmer.driving.amplitude) amplitude = std::max(swing, 0.0) / by_unit_forces;
  return swimmer;
}

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
  result.approximation = joined(approximations, ", ");
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

Vec3 box_around(const CollinearSwimmer& swimmer, double free_length) {
  const double radius = *std::ranges::min_element(swimmer.radius);
  const auto rounded_up = [&](double edge) { return radius * std::ceil(edge / radius - 1e-9); };
  return {rounded_up(swimmer_length(swimmer) + free_length), rounded_up(free_length),
          rounded_up(free_length)};
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

std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance) {
  Question boxed = question.inertia ? question : with_open_space_motion(question);
  const BestPrediction reference = best_prediction(boxed);
  const CollinearSwimmer& swimmer = question.swimmer;
  const double length = swimmer.arm[0] + swimmer.arm[1];
  constexpr double factor = 1.2, longest = 20;
  for (double free_length = 0.5 * length; free_length < longest * length; free_length *= factor) {
    const Vec3 lengths = box_around(swimmer, free_length);
    boxed.box = box_place_at_centre(lengths);
    double change = INFINITY;  // stays infinite if the box is too narrow for theory
    reason_against([&] { change = difference(best_prediction(boxed), reference).largest(); });
    if (change <= tolerance) return SufficientBox{.lengths = lengths, .change = change};
  }
  return std::nullopt;
}

}  // namespace beadswim
