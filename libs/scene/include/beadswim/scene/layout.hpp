#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// A scene: fluid, domain, types of swimmer and the swimmers, in one coherent unit system. The in-memory
// twin of layout.json (schemas/layout.schema.json); it knows nothing of JSON, cells or time steps.

namespace beadswim {

/// "lattice" (all factors 1), or named units with their size in SI.
struct Units {
  struct Unit {
    std::string name;
    double si_factor = 1;  ///< how many metres, seconds or kilograms one unit is

    static void visit_fields(auto&& visit, auto& unit) {
      visit("name", unit.name);
      visit("si_factor", unit.si_factor);
    }
  };
  bool lattice = true;
  Unit length, time, mass;
};

struct Fluid {
  double density = 1;              ///< rho [mass/length^3]
  double kinematic_viscosity = 0;  ///< nu [length^2/time]

  double dynamic_viscosity() const { return density * kinematic_viscosity; }  ///< eta

  static void visit_fields(auto&& visit, auto& fluid) {
    visit("density", fluid.density);
    visit("kinematic_viscosity", fluid.kinematic_viscosity);
  }
};

/// One swimmer: its type, where it is, and its own driving (its type's unless overridden).
struct Swimmer {
  int id = 0;
  std::string type;
  Vec3 position = Vec3::Zero();  ///< centre of bead 2, unwrapped [length]
  Vec3 axis = Vec3::UnitX();     ///< unit vector from bead 1 to bead 3
  std::optional<Driving> driving{};
};

/// How a resolved run should discretise the scene; a hint only.
struct Resolution {
  double cells_per_radius = 0;
  double relaxation_time = 0;

  static void visit_fields(auto&& visit, auto& resolution) {
    visit("cells_per_radius", resolution.cells_per_radius);
    visit("relaxation_time", resolution.relaxation_time);
  }
};

struct Layout {
  Units units;
  Fluid fluid;
  std::optional<Box> domain;  ///< none: unbounded fluid
  std::map<std::string, SwimmerType> types;
  std::vector<Swimmer> swimmers;
  std::optional<Resolution> resolution;

  /// The swimmer's type with the swimmer's own driving in place.
  SwimmerType resolved_type(const Swimmer& swimmer) const;
};

/// Of all beads that the layout's swimmers have [length].
double smallest_radius(const Layout& layout);

/// Returns the period that all swimmers share, else that of the first one's type [time].
double base_period(const Layout& layout);

/// Returns the shortest period of any swimmer's driving [time].
double shortest_period(const Layout& layout);

}  // namespace beadswim
