#pragma once

#include <cstdint>

#include "beadswim/core/kernel.hpp"

// Kernels of a mobility product: sums over pairs of spheres, the exchange between beads and a mesh by
// Gaussian windows, and the flow of Fourier modes of forces. mobility_kernels.cpp is compiled once per
// instruction set; mobility_kernels() selects one at run time. Arguments are plain arrays, with three
// components per vector unless stated otherwise.

namespace beadswim {

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
  double force[3][capacity];     ///< forces on the other spheres [mass length/time^2]
  double velocity[3][capacity];  ///< velocities of the other spheres due to the force on the one sphere
};

/// Table of a pair tensor (PairTensor) up to the cutoff: polynomials of degree 5 in r^2 for isotropic and
/// axial/r^2, one set per interval of r^2. If radii differ, the two terms of SplitTensor are tabulated
/// separately. Each interval [x, 2 x] of r^2, with x a power of two, is divided into 64 equal intervals. The
/// bits of the double r^2 contain the number of the interval and the position within it.
struct PairTable {
  static constexpr int degree = 5;
  static constexpr int stretch_bits = 6, shift = 52 - stretch_bits;
  std::int64_t first = 0;  ///< upper bits of r^2 in the first interval
  int functions = 2;       ///< 2: isotropic and axial/r^2; 4: both for each term of SplitTensor
  /// Coefficients [interval][power][function] of polynomials in the position within the interval, 0 to 1.
  const double* coefficients = nullptr;
};

/// A mesh and the Gaussian window of a bead, which is the set of mesh points that receive its Gaussian. A
/// plane of the mesh is perpendicular to the first axis, a row in it is parallel to the third axis. Each rank
/// owns consecutive planes. Mesh indices are periodic.
struct WindowMesh {
  static constexpr int max_points = 26;
  int window = 0;                   ///< mesh points per axis that receive the Gaussian; even
  int points[3]{}, row_length = 0;  ///< size of the mesh; length of a row in memory
  int first_plane = 0, planes = 0;  ///< planes that this rank owns
  double origin[3]{}, inverse_spacing[3]{}, inverse_points[3]{};
  double decay[3]{}, height[3]{};    ///< Gaussian height exp(-decay d^2), d: distance [mesh spacing]
  double decay_at[3][max_points]{};  ///< exp(-decay p^2), p = 0, 1, ...
};

/// Positions of `count` beads, three coordinates per bead [length]. The kernels process three values per
/// bead, such as force components, each with its own mesh.
struct WindowBeads {
  long count = 0;
  const double* positions = nullptr;
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
