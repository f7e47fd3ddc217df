#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "beadswim/core/background_flow.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/fields.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/swimmers/swimmer_shape.hpp"
#include "beadswim/swimmers/swimmer_type.hpp"

// A scene in one coherent unit system: fluid, box, types and swimmers. Layout has the content of layout.json
// (schemas/layout.schema.json). It does not depend on JSON, cells or time steps.

namespace beadswim {

/// Unit system: "lattice" (all factors 1), or named units with their size in SI.
struct Units {
  struct Unit {
    std::string name;
    double si_factor = 1;  ///< size of the unit in metres, seconds or kilograms

    bool operator==(const Unit&) const = default;

    BEADSWIM_FIELDS(name, si_factor)
  };
  bool lattice = true;
  Unit length, time, mass;  ///< not used if `lattice` is true

  bool operator==(const Units&) const = default;
};

struct Fluid {
  double density = 1;              ///< rho [mass/length^3]
  double kinematic_viscosity = 0;  ///< nu [length^2/time]
  double thermal_energy = 0;       ///< kT [mass length^2/time^2]; 0: no thermal noise

  double dynamic_viscosity() const { return density * kinematic_viscosity; }  ///< eta [mass/(length time)]

  BEADSWIM_FIELDS(density, kinematic_viscosity, (thermal_energy, omitted_if(0.0)))
};

/// State of a swimmer at the start of a run, instead of its shape at rest.
struct SwimmerStart {
  std::vector<Vec3> positions;  ///< centres of the beads in the box, unwrapped [length]

  BEADSWIM_FIELDS(positions)
};

/// One swimmer. A swimmer without its own driving has the driving of its type.
struct Swimmer {
  int id = 0;
  std::string type;
  Vec3 position = Vec3::Zero();  ///< origin of the type's frame (bead 2 of three), unwrapped [length]
  Vec3 axis = Vec3::UnitX();     ///< unit vector, direction of the x axis of the type's frame
  std::optional<Driving> driving{};
  /// Turns the frame of the type to that of the box, with the x axis onto `axis`. Without it, the shortest
  /// turn of the x axis onto `axis` does.
  std::optional<Eigen::Quaterniond> turn{};
  std::optional<SwimmerStart> start{};

  /// Returns the orientation; its first column is `axis`.
  Eigen::Matrix3d orientation() const;

  /// Moves the swimmer: its position and its beads at the start.
  void move_to(const Vec3& new_position);
  /// Turns the beads at the start about the position. Leaves the orientation as it is.
  void turn_start(const Eigen::Quaterniond& rotation);

  static void visit_fields(auto&& visit, auto& swimmer) {  // layout_document.hpp writes `driving`
    visit("id", swimmer.id);
    visit("type", swimmer.type);
    visit("position", swimmer.position);
    visit("orientation", swimmer.turn, omitted_if_none);
    visit("axis", swimmer.axis, omitted_when(swimmer.turn.has_value()));
    visit("start", swimmer.start, omitted_if_none);
  }
};

/// Proposed discretisation of a resolved run. Programs may choose another one.
struct Resolution {
  double cells_per_radius = 0;  ///< smallest bead radius, divided by the edge of a cell
  double relaxation_time = 0;   ///< tau [step]

  bool operator==(const Resolution&) const = default;

  BEADSWIM_FIELDS(cells_per_radius, relaxation_time)
};

struct Layout {
  Units units;
  Fluid fluid;
  Domain domain;
  BackgroundFlow flow{};  ///< without box
  /// Force per volume on fluid and beads, as a pressure gradient acts [mass/(length^2 time^2)].
  Vec3 body_force = Vec3::Zero();
  std::map<std::string, SwimmerType> types;
  std::vector<Swimmer> swimmers;
  std::optional<Resolution> resolution;
  std::optional<std::int64_t> seed{};  ///< of the thermal noise

  /// Returns the driving of a swimmer: its own, otherwise that of its type.
  const Driving& driving_of(const Swimmer& swimmer) const;

  /// Returns the type of a swimmer. If the swimmer has its own driving, the returned type contains this
  /// driving.
  SwimmerType resolved_type(const Swimmer& swimmer) const;

  BEADSWIM_FIELDS(units, fluid, domain, (flow, omitted_if(BackgroundFlow{})),
                  (body_force, omitted_when(record.body_force.isZero(0))), types, swimmers,
                  (resolution, omitted_if_none), (seed, omitted_if_none))
};

/// Returns the domain in words, for figures and messages: "box 120 × 80 × 80", "open space" or "half-space
/// z > 0 over a no-slip wall".
std::string in_words(const Domain& domain);

/// Returns which models have thermal noise, and the number that decides it: the time a^2/nu in which the
/// momentum of the fluid around a bead spreads, divided by the period.
std::string models_with_noise(const Layout& layout);

/// Returns true if a background flow, walls or a body force move the fluid.
bool has_background_flow(const Layout& layout);

/// Return the smallest radius of the beads, or of all beads of the layout's swimmers [length].
double smallest_radius(const SwimmerType& type);
double smallest_radius(const Layout& layout);

/// Returns the period of the swimmers if all have the same period, otherwise the period of the first
/// swimmer's type [time].
double base_period(const Layout& layout);

/// Returns the shortest period of any harmonic of any swimmer's driving [time].
double shortest_period(const Layout& layout);

}  // namespace beadswim
