#include "beadswim/plan/representatives.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "beadswim/theory/surroundings.hpp"
#include "swimmer_in_box.hpp"

namespace beadswim {
namespace {

/// About a box of one swimmer's share of the whole: along x as long as the box is along the swimmer, or a
/// whole part of that where swimmers stand one behind the other; periodic. Larger than the share where that
/// would leave no room for a swimmer, or for four radii across.
BoxPlace share_of(const Box& box, std::size_t swimmers, const CollinearSwimmer& swimmer, const Vec3& axis) {
  constexpr double room = 1.2, radii_across = 4;
  int along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  const double whole = box.lengths[along], share = box.lengths.prod() / static_cast<double>(swimmers);
  const double least = room * length_of(swimmer);
  const double blocks = std::max(1.0, std::floor(whole / std::max(least, std::cbrt(share))));
  const double x = std::max(whole / blocks, least);
  const double y = std::max(std::sqrt(share / x), radii_across * *std::ranges::max_element(swimmer.radius));
  return in_the_middle({x, y, y});
}

/// What theory takes of a swimmer that lies aslant to its driving: the part of it along its line.
SwimmerType driven_along_its_line(SwimmerType type, const Vec3& axis) {
  for (double& amplitude : type.driving.amplitude) amplitude *= axis.x();
  type.driving.frame = DrivingFrame::body;
  return type;
}

/// Whether its driving acts across its line too.
bool is_driven_across(const SwimmerType& type, const Vec3& axis) {
  constexpr double largest_sine = 1e-9;
  return type.driving.frame == DrivingFrame::lab && axis.cross(Vec3::UnitX()).norm() > largest_sine;
}

Representative representative(const Layout& cell, const Swimmer& swimmer) {
  Representative result;
  result.swimmer = swimmer.id;
  result.type = cell.resolved_type(swimmer);
  const bool across = result.is_slanted = is_driven_across(result.type, swimmer.axis);
  const SwimmerType seen = across ? driven_along_its_line(result.type, swimmer.axis) : result.type;
  const Surroundings surroundings = surroundings_of(cell, swimmer);
  Question& question = result.question;
  question.swimmer =
      collinear_swimmer(seen, across ? Vec3::UnitX() : swimmer.axis, cell.fluid.dynamic_viscosity());
  question.fluid_density = cell.fluid.density;
  question.box = surroundings.box;
  if (!cell.domain && cell.swimmers.size() > 1) {
    result.approximation = "alone in open space, without its neighbours";
  } else if (!surroundings.obstacle.empty()) {
    question.box = share_of(*cell.domain, cell.swimmers.size(), question.swimmer, swimmer.axis);
    const std::string& why = surroundings.obstacle;  // and what to do about it, after a semicolon
    result.approximation = "alone in its share of the box (" + why.substr(0, why.find(';')) + ")";
  }
  if (across) {
    if (!result.approximation.empty()) result.approximation += "; ";
    result.approximation += "driven along its own line, by that part of forces along x";
  }
  question = with_exact_reference(std::move(question));
  return result;
}

/// Type and driving, but for its phase offset.
using Kind = std::tuple<std::string, DrivingFrame, double, double, double, double>;

Kind kind_of(const Layout& cell, const Swimmer& swimmer) {
  const Driving driving = cell.resolved_type(swimmer).driving;
  return {swimmer.type,         driving.frame, driving.amplitude[0],
          driving.amplitude[1], driving.phase, driving.period};
}

/// Of many drivings: the first, and the extremes of force and period.
std::vector<const Swimmer*> extremes(const Layout& cell, const std::vector<const Swimmer*>& all) {
  const auto force = [&](const Swimmer* swimmer) {
    const auto& [a, b] = cell.resolved_type(*swimmer).driving.amplitude;
    return std::abs(a) + std::abs(b);
  };
  const auto period = [&](const Swimmer* swimmer) { return cell.resolved_type(*swimmer).driving.period; };
  std::vector<const Swimmer*> few{all.front()};
  for (const Swimmer* extreme :
       {*std::ranges::max_element(all, {}, force), *std::ranges::min_element(all, {}, force),
        *std::ranges::max_element(all, {}, period), *std::ranges::min_element(all, {}, period)})
    if (std::ranges::find(few, extreme) == few.end()) few.push_back(extreme);
  return few;
}

}  // namespace

std::vector<Representative> representatives(const Layout& cell) {
  constexpr std::size_t many = 8;
  std::map<std::string, std::vector<const Swimmer*>> of_type;
  std::set<Kind> kinds;
  for (const Swimmer& swimmer : cell.swimmers)
    if (kinds.insert(kind_of(cell, swimmer)).second) of_type[swimmer.type].push_back(&swimmer);
  std::vector<Representative> result;
  for (const auto& [type, swimmers] : of_type) {
    for (const Swimmer* swimmer : swimmers.size() > many ? extremes(cell, swimmers) : swimmers)
      result.push_back(representative(cell, *swimmer));
  }
  return result;
}

}  // namespace beadswim
