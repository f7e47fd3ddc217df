#pragma once

#include <cstdint>

#include "beadswim/core/kernel_choice.hpp"

// The arithmetic of a mobility product: pairs of spheres, and windows between spheres and a mesh.
// mobility_kernels.cpp is compiled once for each instruction set; mobility_kernels() chooses at run time.
// Plain arrays alone, three numbers a vector where not said.

namespace beadswim {

/// Spheres in order of their cells, a list a coordinate.
struct SortedSpheres {
  const double *x, *y, *z;
  const unsigned char* is_receiver;  ///< whether velocities are wanted of it
  double lengths[3];                 ///< of the periodic box; 0: open space
};

/// Separations from one sphere to others, and what is needed of these.
struct PairBatch {
  static constexpr int most = 512;
  int count = 0;
  int other[most];  ///< places in SortedSpheres
  double d[3][most], r2[most];
  double squares[most];      ///< a_i^2 + a_j^2; read if the table's are not all alike
  double force[3][most];     ///< on the others
  double velocity[3][most];  ///< of the others, by the one's force
};

/// isotropic and axial/r^2 of a pair tensor between some distance and the cut-off, as polynomials of degree 5
/// in stretches of r^2; of spheres of several sizes, those of SplitTensor's two parts. Each octave of r^2 has
/// 64 equal stretches: which one r^2 is in, and where in it, are bits of the number.
struct PairTable {
  static constexpr int degree = 5;
  static constexpr int stretch_bits = 6, shift = 52 - stretch_bits;
  std::int64_t first = 0;  ///< upper bits of r^2 in the first stretch
  int functions = 2;       ///< 4: isotropic and axial/r^2 of both parts
  const double* coefficients =
      nullptr;  ///< [stretch][power][function], of the place within the stretch, 0 to 1
};

/// Gaussian windows on this rank's planes of a mesh. Rows lie along the third axis; all indices wrap.
struct WindowMesh {
  static constexpr int most_points = 26;
  int window = 0;                   ///< points along an axis, even
  int points[3]{}, row_length = 0;  ///< of the mesh
  int first_plane = 0, planes = 0;  ///< along the first axis, of this rank
  double origin[3]{}, inverse_spacing[3]{}, inverse_points[3]{};
  double decay[3]{}, height[3]{};     ///< height exp(-decay d^2), d in spacings
  double decay_at[3][most_points]{};  ///< exp(-decay p^2), p = 0, 1, ...
};

/// Beads, and three numbers for each, of as many meshes.
struct WindowBeads {
  long count = 0;
  const double* positions = nullptr;
};

#define BEADSWIM_DECLARE_MOBILITY_KERNELS(instruction_set)                                               \
  namespace instruction_set {                                                                            \
  int near_spheres(const SortedSpheres& spheres, int one, int begin, int end, double reach,              \
                   PairBatch& batch);                                                                    \
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
  /// Adds to the batch those of spheres begin to end that are nearer than `reach` to one, if either is a
  /// receiver. Returns from where to go on: the end, or where the batch was full.
  int (*near_spheres)(const SortedSpheres&, int one, int begin, int end, double reach, PairBatch&);
  /// Velocities of a batch by the force on the one, and adds that of the one by theirs.
  void (*pair_velocities)(const PairTable&, const double* force, PairBatch&, double* velocity);
  /// Adds each bead's numbers, times its window, to the meshes.
  void (*spread_windows)(const WindowMesh&, const WindowBeads&, const double* numbers, double* const* onto);
  /// Adds the meshes' sums under each bead's window to its numbers.
  void (*gather_windows)(const WindowMesh&, const WindowBeads&, const double* const* from, double* numbers);
};

/// Those of the best instruction set that this processor can run.
const MobilityKernels& mobility_kernels();

}  // namespace beadswim
