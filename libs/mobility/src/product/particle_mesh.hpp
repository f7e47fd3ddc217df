#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "beadswim/core/box.hpp"
#include "beadswim/core/communicator.hpp"
#include "beadswim/mobility/ewald_plan.hpp"
#include "beadswim/mobility/fluid_memory.hpp"
#include "ewald_split.hpp"
#include "imaged_spheres.hpp"
#include "memory_field.hpp"
#include "mesh_transform.hpp"
#include "mobility_kernels.hpp"
#include "wall_reflection.hpp"
#include "window_table.hpp"

// Far part of an Ewald sum for the velocities of beads, evaluated on a mesh ("spectral Ewald"). Each bead
// acts on the mesh points near it, weighted by a Kaiser-Bessel function W around its centre (its window,
// window_table.hpp). The forces are spread to the mesh with these weights, Fourier transformed, multiplied by
// the kernel K and transformed back. The velocities of the beads are interpolated with the same weights.
//
//   u_i = h^3 sum_g W(x_i - g) u(g),   u = K * sum_j W(g - x_j) f_j,   K = far part / W^2
//
//   u_i, f_j  velocity and force of the beads at x_i and x_j
//   g, h      mesh point, mesh spacing [length];  *  convolution
//   K         kernel; the quotient (far part)/W^2 is taken between Fourier transforms
//
// In a periodic box the Fourier transform of K is known in closed form. In open space K is sampled on a mesh
// of twice the size, where the periodic convolution equals the convolution in open space. The samples are
// those of the far part, to which a filter along each axis is applied. In Fourier space the filter is a sum
// of cosines, which approximates 1/W^2 where the far part is not negligible.
//
// If all beads have one radius a and only forces act, one field is transformed: the forces F, with D = a^2 F.
// Otherwise a second field D is transformed: the forces times a_j^2, where a_j is the radius of the bead on
// which the force acts. The velocity of bead i is then
//
//   u_i = (K F + L D) + a_i^2 (L F),     K: kernel of the Oseen tensor, L: kernel of its Laplacian/6
//
// With force moments, F is the source of a bead, and 6 c_l a^2 (force_moments.hpp) replaces a^2. Forces are
// the source of order 0.
//
// With memory of the fluid, each class of sources has its own field, because its form factor matters at all
// wavenumbers. F is the sum of all fields, D the sum of the fields times their 6 c_l a^2.
//
// At points without size, a_i is 0: F then needs K F + L D alone.
//
// Over the wall of a half-space, the flow is also needed at the mirror points of the beads, with its pressure
// p. The mesh then contains these points too.
//
// References: Lindbo and Tornberg, J. Comput. Phys. 229, 8994 (2010); af Klinteberg, Shamshirgar and
// Tornberg, Res. Math. Sci. 4, 1 (2017). Page: docs/method/mobility-product.md.

namespace beadswim {

class ParticleMesh {
 public:
  /// Sets up the mesh for the parameters `plan`. `memory`: of a fluid with inertia in a periodic box.
  /// `half_space`: the mesh contains the mirror points of the beads. Collective.
  ParticleMesh(const EwaldPlan& plan, const ImagedSpheres& spheres, const std::optional<FluidMemory>& memory,
               const std::optional<HalfSpace>& half_space, Receivers receivers,
               const Communicator& communicator);

  /// Sets the positions of all beads and images [length]. In open space, fits the mesh to them and to the box
  /// around all receivers. Collective.
  void set_sources(std::span<const Vec3> positions, const Eigen::AlignedBox3d& around_receivers);
  /// Sets the positions of the receivers [length]: the beads without images, or points.
  void set_receivers(std::span<const Vec3> positions);

  /// Adds the contribution of this rank to the flows of the far part at the receivers (force_moments.hpp).
  /// The sum of the contributions of all ranks is the far part, including the self-interaction of each bead.
  /// `sources`: of all beads and images, equal on all ranks. If the plan has mirror points, also adds the
  /// contribution to the flow at the mirror point of each bead to at_mirrors. Collective.
  void add_flows(std::span<const double> sources, FlowPart part, std::span<double> flows,
                 std::span<MirrorFlow> at_mirrors = {});
  /// Evaluates the far part on the mesh, from which gather_flows() then adds it at any receivers. Collective.
  void evaluate(std::span<const double> sources, FlowPart part);
  void gather_flows(std::span<double> flows, std::span<MirrorFlow> at_mirrors) const;
  /// Sets the mesh to a random flow, whose covariance at the receivers is the far part:
  ///
  ///   u(k) = sqrt(h^-3 K(k)) (I - kk/k^2) z(k)     z: normal numbers, z(-k) = conj z(k)
  ///
  /// They depend on the seed and k. gather_flows() then adds it. In a periodic box, with forces alone.
  /// Collective.
  void set_noise(std::uint64_t seed);

  /// Spreads and transforms the sources, which MemoryField::start() or end_step() then uses. Collective.
  void read_sources(std::span<const double> sources);
  /// Evaluates the flow by the memory of the fluid (MemoryField::set_remainder()) on the mesh, from which
  /// gather_remainder() then adds the contribution of this rank at points, 3 numbers each. The mesh values of
  /// the last product are lost. Collective.
  void evaluate_remainder();
  void gather_remainder(std::span<const Vec3> points, std::span<double> flows) const;
  /// Returns the memory of the fluid; null for steady flow.
  MemoryField* memory() const { return memory_.get(); }

 private:
  /// Beads, sorted by rows of the mesh for memory locality.
  struct SortedBeads {
    std::vector<int> order;    ///< index of each bead in the list of all beads
    std::vector<Vec3> places;  ///< [length]

    WindowBeads windows() const { return {std::ssize(places), places[0].data()}; }
  };
  SortedBeads sorted(std::span<const Vec3> positions) const;
  bool is_periodic() const { return spheres_.lengths[0] > 0; }
  void set_points(const std::array<int, 3>& points, const std::array<int, 3>& used);
  void fit_to(const Eigen::AlignedBox3d& bounds);
  std::vector<double> inverse_windows(int axis) const;
  std::vector<double> octant(const std::function<double(const Vec3&)>& function,
                             const std::array<bool, 3>& is_odd) const;
  double cell_volume() const { return spacing_[0] * spacing_[1] * spacing_[2]; }
  void transform_kernel(const MeshTransform& whole, const std::function<double(const Vec3&)>& function,
                        const std::array<bool, 3>& is_odd,
                        const std::function<void(std::ptrdiff_t, double)>& set) const;
  void sample_kernel();
  void sample_pressure_kernel();
  void set_pressure();
  /// Returns the highest derivative of the flow at the receivers.
  int receiver_order() const { return at_points_ ? 0 : spheres_.order; }
  double weight_of(std::size_t field, int bead, std::size_t derivative) const;
  /// Returns the sums of window weight times a field and its derivatives up to `order` at the receivers.
  std::vector<double> gathered(std::size_t field, const SortedBeads& receivers, int order) const;
  void gather(std::span<double> flows) const;
  void gather_mirrors(std::span<MirrorFlow> at_mirrors) const;
  void multiply(FlowPart part);
  std::vector<FieldFactors> field_factors() const;
  void multiply_periodic();
  void multiply_open();

  EwaldPlan plan_;
  EwaldSplit split_;
  WindowTable window_;
  ImagedSpheres spheres_;
  bool at_points_;
  std::optional<HalfSpace> half_space_;
  const Communicator& communicator_;
  std::size_t fields_ = 1;
  double shared_size_ = 0;  ///< a_i^2 + a_j^2, equal for all pairs if there is one field [length^2]
  WindowMesh geometry_{};
  std::array<double, 3> spacing_{};  ///< h [length]
  std::unique_ptr<MeshTransform> transform_{};
  std::vector<std::array<FftwArray, 3>> values_{};  ///< mesh values per field: forces, replaced by velocities
  SortedBeads sources_, receivers_, mirrors_;       ///< beads with images; receivers; their mirror points
  std::vector<std::vector<double>> kernel_{};  ///< open space: elements of the Fourier transforms of K and L
  Eigen::VectorXd filter_{};  ///< open space: taps of the filter that undoes the windows along one axis
  /// Over a wall: imaginary part of the Fourier transform of the kernel of p/eta, and mesh values of p/eta.
  std::vector<std::array<double, 3>> pressure_kernel_{};
  FftwArray pressure_{};
  std::unique_ptr<MemoryField> memory_{};  ///< null: steady flow
};

}  // namespace beadswim
