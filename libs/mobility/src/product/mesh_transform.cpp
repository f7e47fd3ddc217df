#include "mesh_transform.hpp"

#include <algorithm>
#include <new>

namespace beadswim {

MeshTransform::MeshTransform(const std::array<int, 3>& points, const Communicator& communicator)
    : points_(points) {
  static const bool started = (fftw_mpi_init(), true);
  (void)started;
  const std::array<std::ptrdiff_t, 3> n{points[0], points[1], points[2]};
  size_ = fftw_mpi_local_size_3d_transposed(n[0], n[1], n[2] / 2 + 1, communicator.get(), &planes_,
                                            &first_plane_, &waves_, &first_wave_);
  const FftwArray scratch = array();
  auto* complex = reinterpret_cast<fftw_complex*>(scratch.get());
  // FFTW_ESTIMATE selects an algorithm without timing, so every run uses the same algorithm and gets the
  // same bits.
  forward_.reset(fftw_mpi_plan_dft_r2c_3d(n[0], n[1], n[2], scratch.get(), complex, communicator.get(),
                                          FFTW_ESTIMATE | FFTW_MPI_TRANSPOSED_OUT));
  backward_.reset(fftw_mpi_plan_dft_c2r_3d(n[0], n[1], n[2], complex, scratch.get(), communicator.get(),
                                           FFTW_ESTIMATE | FFTW_MPI_TRANSPOSED_IN));
}

FftwArray MeshTransform::array() const {
  FftwArray memory(fftw_alloc_real(2 * std::max<std::ptrdiff_t>(size_, 1)));
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace beadswim
