#pragma once

#include <fftw3.h>

#include <array>
#include <complex>
#include <memory>
#include <vector>

#include "beadswim/core/communicator.hpp"
#include "beadswim/core/vec3.hpp"

namespace beadswim {

using Complex = std::complex<double>;

struct FftwFree {
  void operator()(double* memory) const { fftw_free(memory); }
};
using FftwArray = std::unique_ptr<double[], FftwFree>;

struct PlanFree {
  void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
};
using FftwPlan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanFree>;

/// Removes from a Fourier mode f with the wavevector k its part along k. k2: k^2.
template <class Vector>
Vector transverse(const Vec3& k, double k2, const Vector& f) {
  const Complex along = (k[0] * f[0] + k[1] * f[1] + k[2] * f[2]) / k2;
  return {f[0] - along * k[0], f[1] - along * k[1], f[2] - along * k[2]};
}

inline Complex* as_complex(const FftwArray& array) {
  return reinterpret_cast<Complex*>(array.get());
}

/// In-place Fourier transforms of real meshes. Each rank owns planes of the mesh, perpendicular to the first
/// axis. Of the Fourier transform, each rank owns planes perpendicular to the second axis.
///
/// FFTW transforms lines of points, those of one plane after those of another, so that a plane stays in the
/// caches. Between the second and the first axis, the ranks exchange the lines of their planes once. FFTW's
/// own transforms of whole meshes take 1.5 times as long, with the algorithm that it selects without timing.
class MeshTransform {
 public:
  /// Collective.
  MeshTransform(const std::array<int, 3>& points, const Communicator& communicator);

  FftwArray array() const;
  /// Returns the number of real numbers in an array.
  std::ptrdiff_t reals() const { return 2 * row_ * max_rows_; }
  /// Collective.
  void forward(const FftwArray& a) const;
  /// Collective. The result is not divided by the number of points.
  void backward(const FftwArray& a) const;

  int planes() const { return planes_[rank_].count; }
  int first_plane() const { return planes_[rank_].first; }
  std::ptrdiff_t wave_count() const { return std::ptrdiff_t{waves_[rank_].count} * points_[0] * row_; }

  /// Calls visit(place, i, j, k) for each wavevector of this rank. `place` is the index of the wavevector in
  /// the array. i, j and k are the components along x, y and z in units of 2 pi/edge of the mesh; they have a
  /// sign. The order of the wavevectors of all ranks together is the same on any number of ranks.
  template <class Visitor>
  void for_each_wave(const Visitor& visit) const {
    for_each_row([&](std::ptrdiff_t place, int i, int j) {
      for (int k = 0; k < row_; ++k) visit(place + k, i, j, k);
    });
  }
  /// Calls visit(place, i, j) for the first wavevector of each row, with k = 0.
  template <class Visitor>
  void for_each_row(const Visitor& visit) const {
    const auto signed_index = [](int i, int n) { return 2 * i > n ? i - n : i; };
    const auto [first, count] = waves_[rank_];
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < points_[0]; ++i)
        visit((std::ptrdiff_t{i} * count + j) * row_, signed_index(i, points_[0]),
              signed_index(first + j, points_[1]));
  }

 private:
  /// Consecutive planes, which one rank owns.
  struct Part {
    int first = 0, count = 0;
  };
  std::vector<Part> parts(int planes) const;
  template <class Copy>
  void for_each_message(const Copy& copy) const;
  void exchange(const FftwArray& from, const std::vector<Part>& before, const FftwArray& to,
                const std::vector<Part>& after) const;
  void transform_along_x(const FftwPlan& lines, const FftwArray& a) const;

  std::array<int, 3> points_;
  const Communicator& communicator_;
  int rank_;
  std::vector<Part> planes_;          ///< of the mesh, by rank
  std::vector<Part> waves_;           ///< of the Fourier transform, by rank
  std::ptrdiff_t row_;                ///< number of wavevectors along the third axis
  std::ptrdiff_t max_rows_;           ///< number of rows of an array
  std::array<FftwArray, 2> scratch_;  ///< a plane each
  FftwArray exchanged_;               ///< scratch for messages; null on one rank
  struct {
    FftwPlan along_z, along_y, along_x;
  } forward_, backward_;  ///< of all lines of a plane along an axis
};

}  // namespace beadswim
