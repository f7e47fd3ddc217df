#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "beadswim/mobility/fluid_memory.hpp"

// Far part of an Ewald sum for the velocities of beads, evaluated on a mesh ("spectral Ewald"). Each bead
// acts on the mesh points near it, weighted by a Gaussian W around its centre (its window). The forces are
// spread to the mesh with these weights, Fourier transformed, multiplied by the kernel K and transformed
// back. The velocities of the beads are interpolated with the same weights.
//
//   u_i = h^3 sum_g W(x_i - g) u(g),   u = K * sum_j W(g - x_j) f_j,   K = far part / W^2
//   W(x) = prod over axes of sqrt(2 xi^2/(pi share)) exp(-2 xi^2 x^2/share)
//   Fourier transform of W:  exp(-share k^2/(8 xi^2))
//
//   u_i, f_j  velocity and force of the beads at x_i and x_j
//   g, h      mesh point, mesh spacing [length];  *  convolution
//   K         kernel; the quotient (far part)/W^2 is taken between Fourier transforms
//   xi        splitting parameter (ewald_split.hpp) [1/length]
//   share     part of the exponent of the far part's Gaussian that the windows apply, 0 to 1
//
// The far part contains the Gaussian exp(-k^2/(4 xi^2)). Spreading and interpolation apply W once each,
// together the factor exp(-share k^2/(4 xi^2)). K contains the remaining factor. `share` is chosen such that
// W decreases to exp(-m^2/2) of its maximum at the edge of the window (EwaldPlan::window_shape). In a
// periodic box the Fourier transform of K is known in closed form. In open space K is smooth and is sampled
// on a mesh of twice the size, where the periodic convolution equals the convolution in open space.
//
// Over the wall of a half-space, the flow is also needed at the mirror points of the beads, with its pressure
// p. The mesh then contains these points too.
//
// References: Lindbo and Tornberg, J. Comput. Phys. 229, 8994 (2010); af Klinteberg, Shamshirgar and
// Tornberg, Res. Math. Sci. 4, 1 (2017). Page: docs/method/mobility-product.md.

namespace beadswim {

class MemoryField;
struct MirrorFlow;

class ParticleMesh {
 public:
  /// Radii of the beads and viscosity of the fluid.
  struct Beads {
    std::vector<double> squared_radii;    ///< a_i^2 of each bead [length^2]; empty: point forces (Oseen)
    double viscosity = 0;                 ///< dynamic [mass/(length time)]
    int moment_order = 0;                 ///< highest moment of the forces (force_moments.hpp)
    std::optional<FluidMemory> memory{};  ///< periodic box only; nullopt: steady flow
  };

  /// Sets up the mesh for the parameters `plan`. `lengths` are the edges of the periodic box [length]. They
  /// are 0 in open space, where each call of add_velocities() fits the mesh to the positions of the beads.
  /// All ranks must call the constructor (collective).
  ParticleMesh(const EwaldPlan& plan, const Vec3& lengths, Beads beads, const Communicator& communicator);
  ~ParticleMesh();
  ParticleMesh(const ParticleMesh&) = delete;
  ParticleMesh& operator=(const ParticleMesh&) = delete;

  /// Adds to `velocities` [length/time] the contribution of this rank to the far part. The sum of the
  /// contributions of all ranks is the far part, including the self-interaction of each bead. `positions`
  /// [length] and `forces` [mass length/time^2] contain all beads and are equal on all ranks. `velocities`
  /// may be shorter than these arrays: it contains only the first beads, whose velocities are required. All
  /// ranks must call the function (collective).
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces, FlowPart part,
                      std::span<Vec3> velocities);

  /// Does the same for force moments up to Beads::moment_order. `sources` contains the sources of all beads.
  /// The flows at the first beads are added to `flows` (force_moments.hpp).
  void add_flows(std::span<const Vec3> positions, std::span<const double> sources, FlowPart part,
                 std::span<double> flows);

  /// Adds the flows as add_flows() does, in open space over the wall of a half-space. Adds also the
  /// contribution of this rank to the flow at the mirror point of each bead to at_mirrors. Collective.
  void add_flows_and_mirrors(const HalfSpace& half_space, std::span<const Vec3> positions,
                             std::span<const double> sources, std::span<double> flows,
                             std::span<MirrorFlow> at_mirrors);

  /// Spreads and transforms the sources, which MemoryField::start() or end_step() then uses. Collective.
  void read_sources(std::span<const Vec3> positions, std::span<const double> sources);
  /// Returns the memory of the fluid; null for steady flow.
  MemoryField* memory() const;

 private:
  struct Mesh;
  std::unique_ptr<Mesh> mesh_;
};

}  // namespace beadswim
