#pragma once

#include <memory>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_plan.hpp"

// Far part of the Ewald sum by a mesh ("spectral Ewald"). Forces are spread to the mesh by Gaussian windows
// W, Fourier transformed, multiplied by the kernel K, transformed back and interpolated with the same
// windows.
//
//   u_i = h^3 sum_g W(x_i - g) u(g),   u = K * sum_j W(g - x_j) f_j,   K = far part / W^2
//   W(x) = prod over axes of sqrt(2 xi^2/(pi eta)) exp(-2 xi^2 x^2/eta),   transform exp(-eta k^2/(8 xi^2))
//
// eta is the part of the far part's Gaussian that the window takes over. It is chosen such that the window
// decreases to exp(-m^2/2) over its points. In a periodic box K is known in k. In open space K is smooth: it
// is sampled on a mesh of twice the size, where the sum is an ordinary convolution.
//
// References: Lindbo and Tornberg, J. Comput. Phys. 229, 8994 (2010); af Klinteberg, Shamshirgar and
// Tornberg, Res. Math. Sci. 4, 1 (2017). Page: docs/method/mobility-product.md.

namespace beadswim {

class ParticleMesh {
 public:
  /// Sizes of the beads, and the fluid.
  struct Beads {
    std::vector<double> squared_radii;  ///< a_i^2 of each bead [length^2]; empty: point forces (Oseen)
    double viscosity = 0;               ///< dynamic [mass/(length time)]
  };

  /// `lengths` are the edges of the periodic box [length], or 0 in open space, where the mesh is fitted to
  /// the beads in each call. Collective.
  ParticleMesh(const EwaldPlan& plan, const Vec3& lengths, Beads beads, const Communicator& communicator);
  ~ParticleMesh();
  ParticleMesh(const ParticleMesh&) = delete;
  ParticleMesh& operator=(const ParticleMesh&) = delete;

  /// Adds the contribution of this rank to the far part of the velocities. The sum over all ranks is the far
  /// part, including the self-interaction of each bead. `positions` and `forces` hold all beads, equal on all
  /// ranks; `velocities` holds the first beads, as many as are needed. Collective.
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                      std::span<Vec3> velocities);

 private:
  struct Mesh;
  std::unique_ptr<Mesh> mesh_;
};

}  // namespace beadswim
