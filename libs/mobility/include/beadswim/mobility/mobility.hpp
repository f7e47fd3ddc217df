#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/background_flow.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "beadswim/mobility/fluid_memory.hpp"
#include "beadswim/mobility/mobility_model.hpp"

// Velocities v_i of many spheres in Stokes flow from the forces f_j on them. a_i are the radii, eta is the
// dynamic viscosity:
//
//   v_i = sum_j mu_ij f_j,   mu_ii = I/(6 pi eta a_i)
//
// The model (MobilityModel) determines mu_ij for i != j:
//
//   oseen      Oseen tensor of point forces (collinear/oseen.hpp)
//   rpy        Rotne-Prager-Yamakawa tensor of spheres; mu is positive definite even if spheres overlap
//   rpy+near   close beads have induced stresslets, and a map S of the forces (near_map.hpp)
//   multipole  higher moments of the forces keep the surfaces of the spheres rigid (force_moments.hpp)
//   unsteady   as multipole, in a fluid with inertia (fluid_memory.hpp)
//
// The map S makes the mobility of close spheres exact along the lines between their centres. The result is
// positive definite. If spheres are close, the sum over stresslets costs several times the sum over forces.
//
// The spheres are in open space or in a box. Each axis of the box is periodic or has free-slip walls, which
// act as mirrors. In a box the sum over j includes all periodic and mirror images of the spheres. The Fourier
// series of this sum leaves out the wavevector k = 0, so the volume flux is zero. The forces in a box should
// sum to zero.
//
// Over the plane no-slip wall of a half-space, mu also contains the flow that the wall adds to that of each
// sphere (docs/method/half-space.md). In open space and in a half-space a background flow can be added to all
// velocities.
//
// Fewer than 1000 spheres in open space are summed pair by pair, without approximation. Otherwise an Ewald
// sum is evaluated: the near part is summed over pairs, the far part is evaluated on a mesh (ewald_split.hpp,
// particle_mesh.hpp). For N spheres the cost of an Ewald sum is proportional to N log N, its memory to N.
//
// Page: docs/method/mobility-product.md.

namespace beadswim {

struct MobilityScene {
  MobilityModel model = MobilityModel::rpy;
  double viscosity = 0;       ///< dynamic viscosity eta of the fluid [mass/(length time)]
  Domain domain;              ///< a half-space without memory
  std::vector<double> radii;  ///< radius of each sphere [length]
  double tolerance = 1e-4;    ///< accepted error of sphere velocities, divided by their root mean square
  /// Index of the first sphere of each swimmer of three consecutive spheres that stay on a line. The model
  /// rpy_near corrects such a swimmer as a whole, and all other close spheres as pairs.
  std::vector<int> lines{};
  int moment_order =
      0;  ///< models multipole and unsteady: highest moment of the force on each sphere, 0 to 2
  std::optional<FluidMemory> memory{};    ///< model unsteady
  BackgroundFlow flow{};                  ///< without box and memory
};

/// Returns the highest moment of the forces in the scene.
inline int highest_moment(const MobilityScene& scene) {
  return has_moment_order(scene.model) ? scene.moment_order : 0;
}

/// Work of products. Only products with force moments need iterations.
struct ProductWork {
  long products = 0;
  long iterations = 0;       ///< of the method of conjugate gradients; each needs one sum over all moments
  double residual = 0;       ///< largest square root of (dissipation by the residual/power of the forces)
  /// false if a product needed more than 100 iterations, or met a curvature that is not positive or a
  /// residual that is not a number
  bool is_converged = true;

  void add(const ProductWork& other) {
    products += other.products;
    iterations += other.iterations;
    residual = std::max(residual, other.residual);
    is_converged = is_converged && other.is_converged;
  }
};

/// Start and accepted error of the iteration for force moments.
struct MomentGuess {
  std::span<const double> moments{};  ///< as those of Mobility::moments(); empty: 0
  double tolerance_factor = 1;        ///< factor on the accepted error, 1 or more
};

/// Spheres that move in the fluid; lists of all spheres.
struct MovingSpheres {
  std::span<const Vec3> positions;   ///< [length]
  std::span<const Vec3> velocities;  ///< [length/time]
  std::span<const double> moments;   ///< that the spheres exert on the fluid (Mobility::moments())
};

/// Flow at points, one element each.
struct FlowAtPoints {
  std::vector<Vec3> velocities;  ///< [length/time]
  std::vector<int> spheres;      ///< index of the sphere that contains the point; -1: a point in the fluid
};

class Mobility {
 public:
  /// Prepares the mobility of spheres at `positions` [length], which also determine how the work is divided
  /// between pairs and mesh: at other positions, results change within the tolerance. Throws InputError in
  /// these cases:
  ///   - There is no sphere.
  ///   - A radius, the viscosity, a length of the box, the tolerance or the order of moments is invalid.
  ///   - The numbers of positions and radii differ, or a swimmer of `lines` goes beyond the spheres.
  /// All functions throw InputError if an array lacks elements for all spheres, or has more.
  /// All ranks must call the constructor, gather_memory() and all functions that are not const (collective).
  Mobility(MobilityScene scene, std::span<const Vec3> positions, const Communicator& communicator);
  ~Mobility();
  Mobility(const Mobility&) = delete;
  Mobility& operator=(const Mobility&) = delete;

  /// Moves all spheres to `positions` [length]. What depends on positions alone is computed once for all
  /// products there.
  void set_positions(std::span<const Vec3> positions);

  /// Sets velocities[i] to the velocity v_i of each sphere i [length/time], by `forces`
  /// [mass length/time^2]. All arrays contain all spheres and are equal on all ranks. On an equal number of
  /// ranks, equal arguments give the same bits. On different numbers of ranks, results agree to roundoff, and
  /// with force moments to the tolerance.
  ProductWork apply(std::span<const Vec3> forces, std::span<Vec3> velocities,
                    FlowPart part = FlowPart::forces, const MomentGuess& guess = {});
  /// Returns the moments that the spheres exert on the fluid by the forces of the last apply() or
  /// start(): equally many numbers per sphere, first its force (force_moments.hpp). With `rpy+near` these
  /// are the forces and stresslets after the map.
  std::span<const double> moments() const;
  /// Returns the flow of `spheres` at `points`, which exert no force, with the background flow and the memory
  /// of the fluid at the end of the last step. Inside a sphere it is the velocity of the sphere, without
  /// rotation. The error is within the tolerance, divided by the root mean square of sphere velocities.
  /// `points` are equal on all ranks, as are the results. Collective.
  FlowAtPoints flow_at(std::span<const Vec3> points, const MovingSpheres& spheres);
  /// Sets `projections` to those of the flow of `moments`, moment_count() numbers per sphere each
  /// (force_moments.hpp), without a map of close spheres and without background flow.
  void project_flow_of(std::span<const double> moments, std::span<double> projections);
  /// Sets `velocities` to those of free spheres in a flow with these projections on their moments. Only with
  /// force moments, without memory.
  ProductWork move_in_flow(std::span<const double> projections, std::span<Vec3> velocities);

  /// Sets the fluid at rest. The forces begin to act. No effect without memory.
  ProductWork start(std::span<const Vec3> forces);
  /// Ends a time step, at whose end the spheres exert `moments` on the fluid, those of moments().
  /// `mean_flow`: mean velocity of the fluid, with the insides of the spheres. No effect without memory.
  void end_step(std::span<const double> moments, const Vec3& mean_flow);

  /// Returns the memory of the fluid on rank 0, and an empty list on other ranks. Only with memory.
  std::vector<double> gather_memory() const;
  /// Replaces the memory of the fluid, for example by that of a checkpoint. `memory` is equal on all ranks.
  /// Throws SolverError if its size is different. Only with memory.
  void restore_memory(std::span<const double> memory);

  /// Returns the parameters of the Ewald sum at the present positions; nullopt if all pairs are summed
  /// directly, without an Ewald sum.
  const std::optional<EwaldPlan>& plan() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace beadswim
