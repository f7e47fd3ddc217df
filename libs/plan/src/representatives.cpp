#include "beadswim/plan/representatives.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "beadswim/core/error.hpp"
#include "beadswim/scene/surroundings.hpp"

namespace beadswim {
namespace {

/// From the far side of bead 1 to that of bead 3, at rest [length].
double length_of(const CollinearSwimmer& swimmer) {
  return swimmer.radius[0] + swimmer.arm[0] + swimmer.arm[1] + swimmer.radius[2];
}

/// A box of one swimmer's share of the whole, along x as long as the box is along the swimmer, or shorter
/// where swimmers stand one behind the other.
BoxPlace share_of(const Domain& domain, std::size_t swimmers, const CollinearSwimmer& swimmer,
                  const Vec3& axis) {
  int along = 0;
  axis.cwiseAbs().maxCoeff(&along);
  const double whole = domain.lengths[along], share = domain.lengths.prod() / static_cast<double>(swimmers);
  const double least = 1.2 * length_of(swimmer);
  const double blocks = std::max(1.0, std::floor(whole / std::max(least, std::cbrt(share))));
  const double x = std::max(whole / blocks, least), y = std::sqrt(share / x);
  const double widest = std::max(y, 4 * *std::ranges::max_element(swimmer.radius));
  return {.box = {.lengths = {x, widest, widest}, .free_slip = {}},
          .middle_bead = {x / 2, widest / 2, widest / 2}};
}

/// Along its own line, whatever its driving's frame.
CollinearSwimmer along_own_line(const SwimmerType& type, const Vec3& axis, double viscosity) {
  try {
    return collinear_swimmer(type, axis, viscosity);
  } catch (const InputError&) {
    return collinear_swimmer(type, Vec3::UnitX(), viscosity);
  }
}

Representative representative(const Layout& cell, const Swimmer& swimmer) {
  const SwimmerType type = cell.resolved_type(swimmer);
  const Surroundings surroundings = surroundings_of(cell, swimmer);
  Representative result{.swimmer = swimmer.id, .question = {}, .is_exact = surroundings.obstacle.empty()};
  result.question.swimmer = along_own_line(type, swimmer.axis, cell.fluid.dynamic_viscosity());
  result.question.fluid_density = cell.fluid.density;
  result.question.box = surroundings.box;
  if (!cell.domain) {
    result.is_exact = cell.swimmers.size() == 1;
  } else if (!result.is_exact) {
    result.question.box = share_of(*cell.domain, cell.swimmers.size(), result.question.swimmer, swimmer.axis);
  }
  result.question = with_exact_reference(std::move(result.question));
  return result;
}

}  // namespace

std::vector<Representative> representatives(const Layout& cell) {
  std::vector<Representative> result;
  std::set<std::string> types;
  for (const Swimmer& swimmer : cell.swimmers) {
    if (types.insert(swimmer.type).second) result.push_back(representative(cell, swimmer));
  }
  return result;
}

}  // namespace beadswim
