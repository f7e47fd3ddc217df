#pragma once

#include <cstdint>

#include "beadswim/core/kernel.hpp"
#include "wall_reflection.hpp"

// Kernels of a mobility product: sums over pairs of spheres, the exchange between beads and a mesh by
// Gaussian windows, and the flow of Fourier modes of forces. mobility_kernels.cpp is compiled once per
// instruction set; best_kernels() selects one at run time. Arguments are plain arrays, with three components
// per vector unless stated otherwise. Sources and flows: force_moments.hpp.

namespace beadswim {

/// Highest n of ((1/r) d/dr)^n for a pair of spheres, and for a sphere and the mirror point of another one.
constexpr int highest_of_pairs = 6, highest_of_mirrors = 8;
/// Returns the highest n that the flow of sources of this order at their receivers needs.
constexpr int highest_radial(int order, Receivers receivers) {
  return receivers == Receivers::points ? order + 3 : 2 * order + 4;
}
/// Largest number of elements of a source or of a flow (force_moments.hpp).
constexpr int max_elements = 3 * derivative_count(2);

/// Spheres sorted by the cells of a CellList, with one array per coordinate.
struct SortedSpheres {
  const double *x, *y, *z;
  const unsigned char* is_receiver;  ///< 1 if the velocity of the sphere is required
  double lengths[3];                 ///< edges of the periodic box; 0 in open space [length]
};

/// Batch of pairs of spheres: pairs of one sphere ("the one sphere") with other spheres.
struct PairBatch {
  static constexpr int capacity = 512;
  int count = 0;
  int other[capacity];  ///< indices in SortedSpheres
  /// d: position of the one sphere minus positions of the other spheres [length]. r2: squared lengths of d.
  double d[3][capacity], r2[capacity];
  double squares[capacity];      ///< a_i^2 + a_j^2 [length^2]; used only if radii differ
  double products[capacity];     ///< a_i^2 a_j^2 [length^4]; used only with 6 functions
  double force[3][capacity];     ///< forces on the other spheres [mass length/time^2]
  double velocity[3][capacity];  ///< velocities of the other spheres due to the force on the one sphere
};

/// Table of a pair tensor (PairTensor) up to the cutoff: polynomials of degree 5 in r^2 for isotropic and
/// axial/r^2, one set per interval of r^2. If radii differ, the terms of SplitTensor are tabulated
/// separately. Each interval [x, 2 x] of r^2, with x a power of two, is divided into 64 equal intervals. The
/// bits of the double r^2 contain the number of the interval and the position within it.
struct PairTable {
  static constexpr int degree = 5;
  static constexpr int stretch_bits = 6, shift = 52 - stretch_bits;
  std::int64_t first = 0;  ///< upper bits of r^2 in the first interval
  int functions = 2;       ///< 2: isotropic and axial/r^2; 4 or 6: both for each term of SplitTensor
  /// Coefficients [interval][power][function] of polynomials in the position within the interval, 0 to 1.
  const double* coefficients = nullptr;
};

/// A mesh and the Gaussian window of a bead, which is the set of mesh points that receive its Gaussian. A
/// plane of the mesh is perpendicular to the first axis, a row in it is parallel to the third axis. Each rank
/// owns consecutive planes. Mesh indices are periodic.
struct WindowMesh {
  static constexpr int max_points = 28;
  int window = 0;                   ///< mesh points per axis that receive the Gaussian, 6 to 26; even
  int points[3]{}, row_length = 0;  ///< size of the mesh; length of a row in memory
  int first_plane = 0, planes = 0;  ///< planes that this rank owns
  double origin[3]{}, inverse_spacing[3]{}, inverse_points[3]{};
  double decay[3]{}, height[3]{};    ///< Gaussian height exp(-decay d^2), d: distance [mesh spacing]
  double decay_at[3][max_points]{};  ///< exp(-decay p^2), p = 0, 1, ...; 0 beyond the window
};

/// Positions of `count` beads or points, three coordinates each [length].
struct WindowBeads {
  long count = 0;
  const double* positions = nullptr;
};

/// Up to 8 spheres, one in each lane, whose flow at a point or at another sphere is needed. The vector r is
/// the position of the receiver minus the position of the sphere. Unused lanes have sources of zero.
struct SourceLanes {
  double r[3][lanes];
  /// ((1/r) d/dr)^n of chi, of its Laplacian and of its second Laplacian, divided by 8 pi eta. chi[0] is not
  /// used.
  double chi[highest_of_mirrors + 1][lanes], laplacian[highest_of_mirrors + 1][lanes];
  double bilaplacian[highest_of_mirrors - 1][lanes];
  double source[max_elements][lanes];
  double size[3][lanes];  ///< c_l a^2 of the spheres
};

/// The sphere at which the flow of SourceLanes is needed.
struct OneSphere {
  const double* source;
  double size[3];
  double* flow;  ///< the flow of the other spheres is added to it
};

/// Sum of the flows of many spheres at a point or a mirror point, with one part of the sum in each lane.
struct MirrorFlowParts {
  double along[2][derivative_count(2)][lanes]{};
  double across[MirrorFlow::max_count][lanes]{}, pressure[MirrorFlow::max_count][lanes]{};
};

/// A row of wavevectors (kx, ky, kz) of a mesh. Their Fourier modes are stored as real numbers: the real and
/// the imaginary part of each.
struct WaveRow {
  long count = 0;                 ///< real numbers, two per wavevector
  double kx = 0, ky = 0;          ///< [1/length]
  const double* kz = nullptr;     ///< of each number [1/length]
  double xi = 0;                  ///< splitting parameter [1/length]
  double scale = 0;               ///< mesh cell/box volume/viscosity, times the Gaussian along x and y
  const double* decay = nullptr;  ///< Gaussian along z, of each number
};

/// Factors of a field of sources in the sums F and D (multiply_waves).
struct FieldFactors {
  double p = 0;  ///< in F
  double q = 0;  ///< in D [length^2]
};

struct MobilityKernels {
  /// Adds to the batch each sphere in [begin, end) that is nearer than `cutoff` to sphere `one`, unless
  /// neither of the two spheres is a receiver. Returns the index at which to continue: `end`, or less if the
  /// batch is full.
  int (*find_near_spheres)(const SortedSpheres&, int one, int begin, int end, double cutoff, PairBatch&);
  /// Sets the velocities of the other spheres of a batch that the force on the one sphere causes. Adds to
  /// `velocity` the velocity of the one sphere that the forces on the other spheres cause.
  void (*pair_velocities)(const PairTable&, const double* force, PairBatch&, double* velocity);
  /// Evaluates the flows of all pairs in both directions, for moments up to `order`, 1 or 2. Sets `at_others`
  /// to the flow of the one sphere at the other spheres.
  void (*moment_pairs)(int order, const OneSphere&, const SourceLanes& others, double (*at_others)[lanes]);
  /// Adds the flow of the sources at a point, or at the mirror point of a sphere or a point. `axis`: of the
  /// wall's normal.
  void (*mirror_flow)(int order, Receivers, int axis, const SourceLanes&, bool has_bilaplacian,
                      MirrorFlowParts&);
  /// Adds the derivatives of the windows of the beads, multiplied by `sources`, to the three meshes.
  /// `sources`: 3 * derivative_count(order) numbers per bead, for an order up to 2.
  void (*spread)(int order, const WindowMesh&, const WindowBeads&, const double* sources,
                 double* const* onto);
  /// Adds to `flows` the derivatives up to `order`, at most 4, of the values of several meshes at the beads,
  /// interpolated with their windows and divided by the volume of a mesh cell.
  void (*gather)(int order, const WindowMesh&, const WindowBeads&, int meshes, const double* const* from,
                 double* flows);
  // clang-format off
  /// Replaces the Fourier modes of the sources of each field by those of their flow. `values`: three components
  /// per field.
  ///
  ///   F = sum p_f V_f,   D = sum q_f V_f              V_f: source of the field f, without its part along k
  ///   V_f <- K [p_f (F - k^2/6 D) - q_f k^2/6 F]      K = scale decay (1 + k^2/(4 xi^2))/k^2, 0 for k = 0
  ///
  /// K contains the far part of the Oseen tensor (ewald_split.hpp), without the part of its Gaussian that the
  /// windows apply.
  // clang-format on
  void (*multiply_waves)(const WaveRow&, int fields, const FieldFactors* factors, double* const* values);

  static const MobilityKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel.hpp)
};

}  // namespace beadswim
