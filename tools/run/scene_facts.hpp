#pragma once

#include <span>
#include <vector>

#include "beadswim/documents/run_record_document.hpp"
#include "beadswim/scene/layout.hpp"

// What any model asks of a layout.

namespace beadswim {

/// The period that all swimmers share, else that of the first one's type [time].
double base_period(const Layout& layout);

/// Of any swimmer's driving [time].
double shortest_period(const Layout& layout);

/// The layout's swimmers in order of their ids, and the types that they share: one with driving of its own
/// has a type of its own.
struct TypedSwimmers {
  struct Member {
    const Swimmer* swimmer;
    int type;  ///< index into types
  };
  std::vector<SwimmerType> types;
  std::vector<Member> members;
};
TypedSwimmers typed_swimmers(const Layout& layout);

double largest_radius(std::span<const SwimmerType> types);

/// In any coherent units; speed: the largest of any bead.
DimensionlessNumbers dimensionless_numbers(std::span<const SwimmerType> types, double speed,
                                           double kinematic_viscosity, double period);

}  // namespace beadswim
