#pragma once

#include <fftw3-mpi.h>

#include <array>
#include <complex>
#include <memory>

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
class MeshTransform {
 public:
  /// Collective.
  MeshTransform(const std::array<int, 3>& points, const Communicator& communicator);

  FftwArray array() const;
  std::ptrdiff_t reals() const { return 2 * size_; }
  void forward(const FftwArray& a) const {
    fftw_mpi_execute_dft_r2c(forward_.get(), a.get(), reinterpret_cast<fftw_complex*>(a.get()));
  }
  void backward(const FftwArray& a) const {
    fftw_mpi_execute_dft_c2r(backward_.get(), reinterpret_cast<fftw_complex*>(a.get()), a.get());
  }

  int planes() const { return static_cast<int>(planes_); }
  int first_plane() const { return static_cast<int>(first_plane_); }
  std::ptrdiff_t wave_count() const { return waves_ * points_[0] * (points_[2] / 2 + 1); }

  /// Calls visit(place, i, j, k) for each wavevector of this rank. `place` is the index of the wavevector in
  /// the array. i, j and k are the components along x, y and z in units of 2 pi/edge of the mesh; they have a
  /// sign.
  template <class Visitor>
  void for_each_wave(const Visitor& visit) const {
    const auto signed_index = [](int i, int n) { return 2 * i > n ? i - n : i; };
    std::ptrdiff_t place = 0;
    for (int j = 0; j < waves_; ++j)
      for (int i = 0; i < points_[0]; ++i)
        for (int k = 0; k <= points_[2] / 2; ++k, ++place)
          visit(place, signed_index(i, points_[0]),
                signed_index(static_cast<int>(first_wave_) + j, points_[1]), k);
  }

 private:
  std::array<int, 3> points_;
  std::ptrdiff_t size_ = 0, planes_ = 0, first_plane_ = 0, waves_ = 0, first_wave_ = 0;
  FftwPlan forward_, backward_;
};

}  // namespace beadswim
