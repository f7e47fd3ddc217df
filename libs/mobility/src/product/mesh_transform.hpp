#pragma once

#include <fftw3.h>

#include <array>
#include <memory>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/complex.hpp"

namespace beadswim {

struct FftwFree {
  void operator()(double* memory) const { fftw_free(memory); }
};
using FftwArray = std::unique_ptr<double[], FftwFree>;

struct PlanFree {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanFree>;

inline Complex* as_complex(const FftwArray& array) {
  return reinterpret_cast<Complex*>(array.get());
}

/// In-place Fourier transforms of real meshes. Each rank owns planes of the mesh, perpendicular to the first
/// axis. Of the Fourier transform, each rank owns planes perpendicular to the second axis.
///
/// FFTW transforms lines of points, those of one plane after those of another, so that a plane stays in the
/// caches. Between the second and the first axis, the ranks exchange the lines of their planes once. FFTW's
/// own transforms of whole meshes take 1.5 times as long, with the algorithm that it selects without timing.
///
/// In open space the values are needed, and are not 0, only at the first points along the axes. Lines of
/// other points are not transformed, and planes beyond these points are not stored.
class MeshTransform {
 public:
  /// `used`: number of the points along each axis at which values are needed. `like`: another mesh of the
  /// same box; each rank owns the same wavevectors of both, as far as both have them. `communicator` must
  /// live as long as the object.
  MeshTransform(const std::array<int, 3>& points, const std::array<int, 3>& used,
                const Communicator& communicator, const MeshTransform* like = nullptr);

  FftwArray array() const;
  /// Returns the number of real numbers in an array.
  std::ptrdiff_t reals() const { return 2 * row_ * max_rows_; }
  /// Collective.
  void forward(const FftwArray& a) const;
  /// Collective. The result is not divided by the number of points.
  void backward(const FftwArray& a) const;

  const Communicator& communicator() const { return communicator_; }
  const std::array<int, 3>& points() const { return points_; }
  const std::array<int, 3>& used() const { return used_; }
  int planes() const { return planes_[rank_].count; }
  int first_plane() const { return planes_[rank_].first; }
  std::ptrdiff_t wave_count() const { return std::ptrdiff_t{wave_planes_[rank_].count} * points_[0] * row_; }

  /// Returns the index in the array of a wavevector of this rank, from its components.
  std::ptrdiff_t place(int i, int j, int k) const {
    return place_of(i < 0 ? i + points_[0] : i, (j < 0 ? j + points_[1] : j) - wave_planes_[rank_].first) + k;
  }
  /// Calls visit(place, i, j, k) for each wavevector of this rank. `place` is the index of the wavevector in
  /// the array. i, j and k are the components along x, y and z in units of 2 pi/edge of the mesh; they have a
  /// sign. The order of the wavevectors of all ranks together is the same on any number of ranks.
  template <class Visitor>
  void for_each_wave(const Visitor& visit) const {
    for (int j = 0; j < wave_planes_[rank_].count; ++j)
      for (int i = 0; i < points_[0]; ++i)
        for (int k = 0; k < row_; ++k) visit(place_of(i, j) + k, signed_index(i, 0), signed_wave(j), k);
  }
  /// Calls visit(place, i, j) for the first wavevector of each row, with k = 0, in the order of the array.
  template <class Visitor>
  void for_each_row(const Visitor& visit) const {
    for (int i = 0; i < points_[0]; ++i)
      for (int j = 0; j < wave_planes_[rank_].count; ++j)
        visit(place_of(i, j), signed_index(i, 0), signed_wave(j));
  }

 private:
  /// Consecutive planes, which one rank owns.
  struct Planes {
    int first = 0, count = 0;
  };
  /// Returns the component of wavevectors with this index along an axis.
  int signed_index(int index, int axis) const {
    return 2 * index > points_[axis] ? index - points_[axis] : index;
  }
  int signed_wave(int j) const { return signed_index(wave_planes_[rank_].first + j, 1); }
  std::ptrdiff_t place_of(int i, int j) const {
    return (std::ptrdiff_t{i} * wave_planes_[rank_].count + j) * row_;
  }
  std::vector<Planes> parts(int planes) const;
  std::vector<Planes> parts_on(int planes) const;
  template <class Copy>
  void for_each_piece(const Copy& copy) const;
  void exchange(const FftwArray& from, const std::vector<Planes>& before, const FftwArray& to,
                const std::vector<Planes>& after) const;
  void transform_along_x(const FftwPlan& lines, const FftwArray& a, int read, int written) const;

  std::array<int, 3> points_, used_;
  const Communicator& communicator_;
  int rank_;
  std::vector<Planes> planes_;        ///< of the mesh, by rank
  std::vector<Planes> wave_planes_;   ///< of the Fourier transform, by rank
  std::ptrdiff_t row_;                ///< number of wavevectors along the third axis
  std::ptrdiff_t max_rows_;           ///< rows of the larger of both parts of this rank
  std::array<FftwArray, 2> scratch_;  ///< a plane of either kind each
  FftwArray exchanged_;               ///< scratch for messages; null on one rank
  struct {
    FftwPlan along_z, along_y, along_x;
  } forward_, backward_;  ///< transforms of all lines of a plane, along each axis
};

}  // namespace beadswim
