#pragma once

#include <cstdint>

#include "beadswim/core/kernel.hpp"
#include "split_polynomials.hpp"
#include "wall_reflection.hpp"

// Kernels of a mobility product: sums over pairs of spheres, the exchange between beads and a mesh by
// windows, and the flow of Fourier modes of forces. mobility_kernels.cpp is compiled once per
// instruction set; best_kernels() selects one at run time. Arguments are plain arrays, with three components
// per vector unless stated otherwise. Sources and flows: force_moments.hpp.

namespace beadswim {

/// Highest n of ((1/r) d/dr)^n for a pair of spheres, and for a sphere and the mirror point of another one.
constexpr int highest_of_pairs = 6, highest_of_mirrors = SplitPolynomials::highest;
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
  const double* squares;             ///< a^2 of the radii [length^2]
  double lengths[3];                 ///< edges of the periodic box; 0 in open space [length]
};

/// Spheres near one sphere: indices in SortedSpheres.
struct NearSpheres {
  static constexpr int capacity = 512;
  int count = 0, close_count = 0;
  int others[capacity + 8], close[capacity + 8];  ///< farther away than a limit; the nearest
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

/// A mesh and the window of a bead, which is the set of mesh points that receive its force. A plane of the
/// mesh is perpendicular to the first axis, a row in it is parallel to the third axis. Each rank owns
/// consecutive planes. Mesh indices are periodic.
struct WindowMesh {
  int window = 0;                   ///< mesh points per axis that receive the force, up to 18
  int points[3]{}, row_length = 0;  ///< size of the mesh; length of a row in memory
  int first_plane = 0, planes = 0;  ///< planes that this rank owns
  double origin[3]{}, inverse_spacing[3]{}, inverse_points[3]{};
  int degree = 0;                       ///< of the polynomials of the window
  const double* polynomials = nullptr;  ///< WindowTable::polynomials()
};

/// Positions of `count` beads or points, three coordinates each [length].
struct WindowBeads {
  long count = 0;
  const double* positions = nullptr;
};

/// Up to 8 spheres, one in each lane, whose flow at a point or at another sphere is needed. The vector r is
/// the position of the receiver minus the position of the sphere. Unused lanes have sources of zero.
struct SourceLanes {
  double r[3][lanes], distance[lanes];
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
  double scale = 0;               ///< mesh cell/box volume/viscosity, over the squared windows along x and y
  const double* window = nullptr;  ///< of each number: 1 over the squared transform of the window along z
  /// The far part has the factor s, a polynomial of y = shape^2 - cutoff^2 k^2, and 0 below a limit of y.
  const double* far_terms = nullptr;
  int terms = 0;
  double square = 0, cutoff_square = 0;  ///< shape^2, cutoff^2
};

/// Factors of a field of sources in the sums F and D (multiply_waves).
struct FieldFactors {
  double p = 0;  ///< in F
  double q = 0;  ///< in D [length^2]
};

struct MobilityKernels {
  /// Adds to `near` each sphere in [begin, end) whose distance to sphere `one` is at most the cutoff, unless
  /// neither of the two spheres is a receiver. Those at or below the squared distance `close` are added to
  /// its closest ones. Returns the index at which to continue: `end`, or less if `near` is full.
  int (*find_near_spheres)(const SortedSpheres&, int one, int begin, int end, double cutoff, double close,
                           NearSpheres& near);
  /// Adds the velocities of sphere `one` and of `count` other spheres, up to NearSpheres::capacity, that
  /// their forces cause in both directions. force, velocity: an array of all spheres for each component.
  void (*pair_velocities)(const PairTable&, const SortedSpheres&, int one, int count, const int* others,
                          const double* const* force, double* const* velocity);
  /// Sets the radial functions of all lanes to those of the near part of an Ewald sum. unit:
  /// 1/(8 pi eta).
  void (*near_radials)(const SplitPolynomials&, double unit, SourceLanes&);
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
  ///   V_f <- K [p_f (F - k^2/6 D) - q_f k^2/6 F]      K = scale window s(k)/k^2, 0 for k = 0
  ///
  /// K contains the far part of the Oseen tensor (ewald_split.hpp), over the squared windows.
  // clang-format on
  void (*multiply_waves)(const WaveRow&, int fields, const FieldFactors* factors, double* const* values);

  /// Replaces the Fourier modes of one or two fields F and D in open space by K F + L D and L F. `values`:
  /// three components per field. `kernel`: elements xx, xy, xz, yy, yz, zz of K, and of L for two fields, one
  /// number per wavevector.
  void (*multiply_tensors)(long waves, int fields, const double* const* kernel, double* const* values);

  static const MobilityKernels baseline, x86_64_v3,
      x86_64_v4;  ///< of each instruction set (core/kernel.hpp)
};

}  // namespace beadswim
