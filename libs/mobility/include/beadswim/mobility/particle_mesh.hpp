#pragma once

#include <memory>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_plan.hpp"

// The far part of the Ewald sum by a mesh: forces are spread by Gaussian windows W, transformed, multiplied,
// transformed back and gathered by the same windows ("spectral Ewald").
//
//   u_i = h^3 sum_g W(x_i - g) u(g),   u = K * sum_j W(g - x_j) f_j,   K = far part / W^2
//   W(x) = prod over axes of sqrt(2 xi^2/(pi eta)) exp(-2 xi^2 x^2/eta),   transform exp(-eta k^2/(8 xi^2))
//
// eta, the window's share of the far part's Gaussian, is such that the window falls to exp(-m^2/2) over its
// points. In a periodic box K is known in k. In open space K is smooth, sampled on a mesh of twice the size,
// and what it sums is a plain convolution.
//
// References: Lindbo and Tornberg, J. Comput. Phys. 229, 8994 (2010); af Klinteberg, Shamshirgar and
// Tornberg, Res. Math. Sci. 4, 1 (2017). Page: docs/method/mobility-product.md.

namespace beadswim {

class ParticleMesh {
 public:
  /// What beads of one radius, or of several, ask of the mesh.
  struct Beads {
    std::vector<double> squared_radii;  ///< a_i^2 of each bead [length^2]; empty: point forces (Oseen)
    double viscosity = 0;               ///< dynamic
  };

  /// lengths: of the periodic box; in open space 0, and the mesh follows the beads. Collective.
  ParticleMesh(const EwaldPlan& plan, const Vec3& lengths, Beads beads, const Communicator& communicator);
  ~ParticleMesh();
  ParticleMesh(const ParticleMesh&) = delete;
  ParticleMesh& operator=(const ParticleMesh&) = delete;

  /// Adds this rank's part of the far part's velocities of the first `receivers` beads, of its own force too;
  /// the sum over ranks is the velocity. Positions and forces of all beads, the same on all ranks.
  /// Collective.
  void add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                      std::span<Vec3> velocities);

 private:
  struct Mesh;
  std::unique_ptr<Mesh> mesh_;
};

}  // namespace beadswim
