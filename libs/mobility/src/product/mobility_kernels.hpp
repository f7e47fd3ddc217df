#pragma once

#include <cstdint>

#include "beadswim/core/kernel_choice.hpp"

// Kernels of a mobility product: sums over pairs of spheres, and Gaussian windows between spheres and a mesh.
// mobility_kernels.cpp is compiled once per instruction set; mobility_kernels() selects one at run time.
// Arguments are plain arrays, with three components per vector unless stated otherwise.

namespace beadswim {

/// Spheres in order of their cells, with one array per coordinate.
struct SortedSpheres {
  const double *x, *y, *z;
  const unsigned char* is_receiver;  ///< 1 if the velocity of the sphere is required
  double lengths[3];                 ///< edges of the periodic box; 0 in open space [length]
};

/// Separations from one sphere to others, with the data of the pairs.
struct PairBatch {
  static constexpr int capacity = 512;
  int count = 0;
  int other[capacity];  ///< indices in SortedSpheres
  double d[3][capacity], r2[capacity];
  double squares[capacity];      ///< a_i^2 + a_j^2 [length^2]; used if the radii differ
  double force[3][capacity];     ///< forces on the other spheres
  double velocity[3][capacity];  ///< velocities of the other spheres by the force on the one sphere
};

/// Piecewise polynomials of degree 5 in r^2 for the components isotropic and axial/r^2 of a pair tensor, up
/// to the cutoff. If radii differ, both parts of SplitTensor are tabulated. Each octave of r^2 is divided
/// into 64 equal intervals. The interval and the position within it follow from the bits of r^2.
struct PairTable {
  static constexpr int degree = 5;
  static constexpr int stretch_bits = 6, shift = 52 - stretch_bits;
  std::int64_t first = 0;  ///< upper bits of r^2 in the first interval
  int functions = 2;       ///< 2: isotropic, axial/r^2; 4: both of them for each part of SplitTensor
  const double* coefficients =
      nullptr;  ///< [interval][power][function], in the position within the interval, 0 to 1
};

/// Gaussian windows on the planes of a mesh that this rank owns. Rows are parallel to the third axis. All
/// indices wrap.
struct WindowMesh {
  static constexpr int max_points = 26;
  int window = 0;                   ///< points per axis; even
  int points[3]{}, row_length = 0;  ///< size of the mesh; length of a row in memory
  int first_plane = 0, planes = 0;  ///< planes of this rank along the first axis
  double origin[3]{}, inverse_spacing[3]{}, inverse_points[3]{};
  double decay[3]{}, height[3]{};    ///< window height exp(-decay d^2), d in mesh spacings
  double decay_at[3][max_points]{};  ///< exp(-decay p^2), p = 0, 1, ...
};

/// Positions of beads. The kernels take three values per bead, for three meshes.
struct WindowBeads {
  long count = 0;
  const double* positions = nullptr;
};

#define BEADSWIM_DECLARE_MOBILITY_KERNELS(instruction_set)                                               \
  namespace instruction_set {                                                                            \
  int find_near_spheres(const SortedSpheres& spheres, int one, int begin, int end, double cutoff,        \
                        PairBatch& batch);                                                               \
  void pair_velocities(const PairTable& table, const double* force, PairBatch& batch, double* velocity); \
  void spread_windows(const WindowMesh& mesh, const WindowBeads& beads, const double* numbers,           \
                      double* const* onto);                                                              \
  void gather_windows(const WindowMesh& mesh, const WindowBeads& beads, const double* const* from,       \
                      double* numbers);                                                                  \
  }

BEADSWIM_DECLARE_MOBILITY_KERNELS(baseline)
#if defined(__x86_64__)
BEADSWIM_DECLARE_MOBILITY_KERNELS(x86_64_v3)
BEADSWIM_DECLARE_MOBILITY_KERNELS(x86_64_v4)
#endif

struct MobilityKernels {
  /// Adds to the batch the spheres in [begin, end) that are nearer than `cutoff` to sphere `one`, if one of
  /// the two is a receiver. Returns the index at which to continue: `end`, or less if the batch is full.
  int (*find_near_spheres)(const SortedSpheres&, int one, int begin, int end, double cutoff, PairBatch&);
  /// Sets the velocities of a batch by the force on the one sphere. Adds to `velocity` that of the one sphere
  /// by all forces of the batch.
  void (*pair_velocities)(const PairTable&, const double* force, PairBatch&, double* velocity);
  /// Adds the three values of each bead, multiplied by its window, to the three meshes.
  void (*spread_windows)(const WindowMesh&, const WindowBeads&, const double* numbers, double* const* onto);
  /// Adds to the values of each bead the sums of the meshes weighted by its window.
  void (*gather_windows)(const WindowMesh&, const WindowBeads&, const double* const* from, double* numbers);
};

/// Returns the kernels of the best instruction set that this processor supports.
const MobilityKernels& mobility_kernels();

}  // namespace beadswim
