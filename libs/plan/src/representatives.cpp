#include "beadswim/plan/representatives.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>

#include "beadswim/collinear/rotne_prager.hpp"
#include "beadswim/core/joined.hpp"
#include "beadswim/core/reason_against.hpp"
#include "beadswim/plan/model_errors.hpp"
#include "beadswim/scene/presets.hpp"
#include "beadswim/swimmers/swimmer_forces.hpp"
#include "beadswim/theory/linear_response.hpp"
#include "beadswim/theory/scene_numbers.hpp"
#include "beadswim/theory/shaped_swimmer.hpp"

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

/// Returns the three-bead swimmer for which errors are estimated instead of a swimmer of another shape. Its
/// beads have the largest radius a of the type, its arms the mean length of the bonds, at least 2.5 a (10 a
/// without bonds), its springs gamma omega/k = 1, its driving the period of the type. The driving forces give
/// its arms the largest relative amplitude of a bond by theory, at least 5 % and at most half the gap between
/// the beads. docs/results/simplified-scenes.sh measured how many errors of other shapes are within limits.
ThreeBeadSwimmer stand_in(const SwimmerType& type, const std::optional<FirstOrderMotion>& motion,
                          double viscosity) {
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
  double relative_swing = least_swing;
  for (std::size_t k = 0; motion && k < type.bonds.size(); ++k)
    relative_swing = std::max(relative_swing, motion->stroke.amplitude[k] / type.bonds[k].rest_length);
  const double swing = std::min(relative_swing * arm, arm / 2 - radius);
  for (double& amplitude : swimmer.driving.amplitude) amplitude = std::max(swing, 0.0) / by_unit_forces;
  return swimmer;
}

/// Returns the edge of the box along the axis to which `axis` is nearest.
double edge_along(const Box& box, const Vec3& axis) {
  int along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  return box.lengths[along];
}

/// Returns a periodic box for one swimmer that stands for its part of `box`. Its dimensions are
///   volume  about V = (volume of `box`)/swimmers
///   length  L/n, where L is the edge of `box` along the swimmer and n the largest integer for which L/n is
///           at least 1.2 swimmer lengths and at least the cube root of V
///   width   sqrt(V/length)
/// The length is increased to 1.2 swimmer lengths and the width to four bead radii if they are smaller.
BoxPlace share_of(const Box& box, std::size_t swimmers, const CollinearSwimmer& swimmer, const Vec3& axis) {
  constexpr double room = 1.2, radii_across = 4;
  const double box_length = edge_along(box, axis), share = box.lengths.prod() / static_cast<double>(swimmers);
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
  const SwimmerType type = cell.resolved_type(swimmer);
  const double viscosity = cell.fluid.dynamic_viscosity();
  const std::optional<FirstOrderMotion> motion = predicted_motion(type, cell.fluid, swimmer.orientation());
  const std::optional<ThreeBeadSwimmer> three = three_bead_form(type);
  const ThreeBeadSwimmer treated = three ? *three : stand_in(type, motion, viscosity);
  const bool across = is_driven_across(treated, swimmer.axis);
  const CollinearSwimmer line =
      collinear_swimmer(across ? driven_along_its_line(treated, swimmer.axis) : treated,
                        across ? Vec3::UnitX() : swimmer.axis, viscosity);
  const double bead_speed =
      motion ? motion->largest_speed()
             : line.angular_frequency() * std::ranges::max(first_order_stroke(line, rotne_prager).amplitude);
  const Surroundings surroundings = surroundings_of(cell, swimmer);
  Question question(line, cell.fluid.density);
  question.surroundings.box = surroundings.box;
  std::vector<std::string> approximations;
  if (!cell.domain.box && (cell.swimmers.size() > 1 || cell.domain.half_space)) {
    approximations.push_back("alone in open space");
    if (cell.domain.half_space) approximations.push_back("without the wall");
    if (cell.swimmers.size() > 1) approximations.push_back("without neighbours");
  } else if (!surroundings.obstacle.empty()) {
    question.surroundings.box = share_of(*cell.domain.box, cell.swimmers.size(), line, swimmer.axis);
    const std::string& why = surroundings.obstacle;  // form: "reason; remedy"
    approximations.push_back("alone in its share of the box (" + why.substr(0, why.find(';')) + ")");
  }
  if (has_background_flow(cell)) approximations.push_back("in fluid without the background flow");
  if (across) approximations.push_back("driven only by the component of its forces along its axis");
  return {.swimmer = swimmer.id,
          .type = treated,
          .question = std::move(question),
          .approximation = joined(approximations, ", "),
          .is_stand_in = !three,
          .bead_speed = bead_speed,
          .is_slanted = across};
}

/// Properties that distinguish the representatives of swimmers of the same type.
struct Kind {
  DrivingFrame frame;
  std::array<double, 2> amplitude;  ///< of three beads; of other shapes the largest driving force [force]
  double phase, period;             ///< of three beads: alpha [radian]; T [time]
  double along_x;                   ///< frame lab: |component of the axis along x|; otherwise 1
  double box_edge;                  ///< edge of the box along the swimmer [length]

  double force() const { return along_x * std::max(std::abs(amplitude[0]), std::abs(amplitude[1])); }
  auto operator<=>(const Kind&) const = default;
};

Kind kind_of(const Layout& cell, const Swimmer& swimmer) {
  const SwimmerType type = cell.resolved_type(swimmer);
  const DrivingFrame frame = type.driving.frame;
  Kind kind{.frame = frame,
            .amplitude = {largest_driving_force(type), 0},
            .phase = 0,
            .period = type.driving.period,
            .along_x = frame == DrivingFrame::lab ? std::abs(swimmer.axis.x()) : 1,
            .box_edge = 0};
  if (const std::optional<ThreeBeadSwimmer> three = three_bead_form(type)) {
    kind.amplitude = three->driving.amplitude;
    kind.phase = three->driving.phase;
  }
  if (cell.domain.box) kind.box_edge = edge_along(*cell.domain.box, swimmer.axis);
  return kind;
}

/// Returns the swimmers that represent all kinds: the first of each kind or, of more than eight kinds, those
/// with the largest and the smallest force along the axis, the longest and the shortest period. They are in
/// the order of the layout.
std::set<const Swimmer*> selected(const std::map<Kind, const Swimmer*>& first_of_kinds) {
  constexpr std::size_t max_kinds = 8;
  std::set<const Swimmer*> swimmers;
  if (first_of_kinds.size() <= max_kinds) {
    for (const auto& [kind, swimmer] : first_of_kinds) swimmers.insert(swimmer);
    return swimmers;
  }
  const auto add_extremes = [&](auto&& property) {
    const auto [least, most] = std::ranges::minmax_element(
        first_of_kinds, {}, [&](const auto& kind_and_swimmer) { return property(kind_and_swimmer.first); });
    swimmers.insert({least->second, most->second});
  };
  add_extremes([](const Kind& kind) { return kind.force(); });
  add_extremes([](const Kind& kind) { return kind.period; });
  return swimmers;
}

Vec3 box_around(const CollinearSwimmer& swimmer, double free_length) {
  const double radius = *std::ranges::min_element(swimmer.radius);
  const auto rounded_up = [&](double edge) { return radius * std::ceil(edge / radius - 1e-9); };
  return {rounded_up(swimmer_length(swimmer) + free_length), rounded_up(free_length),
          rounded_up(free_length)};
}

}  // namespace

std::vector<Representative> representatives(const Layout& cell) {
  std::map<std::string, std::map<Kind, const Swimmer*>> first_of_kinds;  // of each type
  for (const Swimmer& swimmer : cell.swimmers)
    first_of_kinds[swimmer.type].try_emplace(kind_of(cell, swimmer), &swimmer);
  std::vector<Representative> result;
  for (const auto& [type, kinds] : first_of_kinds)
    for (const Swimmer* swimmer : selected(kinds)) result.push_back(representative(cell, *swimmer));
  return result;
}

std::optional<SufficientBox> sufficient_box(const Question& question, double tolerance) {
  Question boxed = question;
  const BestPrediction reference = best_prediction(boxed);
  const CollinearSwimmer& swimmer = question.line();
  const double length = swimmer.arm[0] + swimmer.arm[1];
  constexpr double factor = 1.2, longest = 20;
  for (double free_length = 0.5 * length; free_length < longest * length; free_length *= factor) {
    const Vec3 lengths = box_around(swimmer, free_length);
    boxed.surroundings.box = box_place_at_centre(lengths);
    double change = INFINITY;  // stays infinite if the box is too narrow for theory
    reason_against([&] { change = difference(best_prediction(boxed).motion, reference).maxCoeff(); });
    if (change <= tolerance) return SufficientBox{.lengths = lengths, .change = change};
  }
  return std::nullopt;
}

}  // namespace beadswim
