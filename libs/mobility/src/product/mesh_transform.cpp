#include "mesh_transform.hpp"

#include <algorithm>
#include <new>

#include "beadswim/core/communicator.hpp"

namespace beadswim {
namespace {

fftw_complex* fftw(Complex* values) {
  return reinterpret_cast<fftw_complex*>(values);
}

FftwArray allocate(std::ptrdiff_t reals) {
  FftwArray memory(fftw_alloc_real(std::max<std::ptrdiff_t>(reals, 1)));
  if (!memory) throw std::bad_alloc();
  return memory;
}

}  // namespace

/// Returns the parts of all ranks; they differ by one plane at most.
std::vector<MeshTransform::Planes> MeshTransform::parts(int planes) const {
  std::vector<Planes> parts;
  for (int r = 0; r < communicator_.size(); ++r) {
    const auto [first, end] = rank_share(planes, r, communicator_.size());
    parts.push_back({static_cast<int>(first), static_cast<int>(end - first)});
  }
  return parts;
}

/// Returns the parts of the planes perpendicular to the second axis of a mesh of `planes` planes that contain
/// the wavevectors of this mesh.
std::vector<MeshTransform::Planes> MeshTransform::parts_on(int planes) const {
  const auto same_wave = [&](int index) {  // of the first wavevector at or beyond this one
    return 2 * index <= points_[1] ? std::min(index, (planes + 1) / 2)
                                   : std::max(index + planes - points_[1], (planes + 1) / 2);
  };
  std::vector<Planes> parts;
  for (const Planes& part : wave_planes_) {
    const int first = same_wave(part.first);
    parts.push_back({first, same_wave(part.first + part.count) - first});
  }
  return parts;
}

MeshTransform::MeshTransform(const std::array<int, 3>& points, const std::array<int, 3>& used,
                             const Communicator& communicator, const MeshTransform* like)
    : points_(points),
      used_(used),
      communicator_(communicator),
      rank_(communicator.rank()),
      planes_(parts(used[0])),
      wave_planes_(like ? like->parts_on(points[1]) : parts(points[1])),
      row_(points[2] / 2 + 1),
      max_rows_(std::max(std::ptrdiff_t{planes()} * points[1],
                         std::ptrdiff_t{wave_planes_[rank_].count} * points[0])) {
  const auto [nx, ny, nz] = points;
  const int row = static_cast<int>(row_);
  for (FftwArray& plane : scratch_) plane = allocate(2 * row_ * std::max(nx, ny));
  if (communicator.size() > 1) exchanged_ = array();
  // FFTW_ESTIMATE selects an algorithm without timing, so every run uses the same algorithm and gets the
  // same bits.
  const unsigned flags = FFTW_ESTIMATE;
  double* const reals = scratch_[0].get();
  auto* const a = fftw(as_complex(scratch_[0]));
  auto* const b = fftw(as_complex(scratch_[1]));
  forward_.along_z.reset(
      fftw_plan_many_dft_r2c(1, &nz, used[1], reals, nullptr, 1, 2 * row, b, nullptr, 1, row, flags));
  backward_.along_z.reset(
      fftw_plan_many_dft_c2r(1, &nz, used[1], b, nullptr, 1, row, reals, nullptr, 1, 2 * row, flags));
  forward_.along_y.reset(
      fftw_plan_many_dft(1, &ny, row, b, nullptr, row, 1, a, nullptr, row, 1, FFTW_FORWARD, flags));
  backward_.along_y.reset(
      fftw_plan_many_dft(1, &ny, row, a, nullptr, row, 1, b, nullptr, row, 1, FFTW_BACKWARD, flags));
  forward_.along_x.reset(
      fftw_plan_many_dft(1, &nx, row, a, nullptr, row, 1, b, nullptr, row, 1, FFTW_FORWARD, flags));
  backward_.along_x.reset(
      fftw_plan_many_dft(1, &nx, row, a, nullptr, row, 1, b, nullptr, row, 1, FFTW_BACKWARD, flags));
}

FftwArray MeshTransform::array() const {
  return allocate(reals());
}

/// Calls copy(in_array, in_messages, count) for each piece of a message, which contains the Fourier modes of
/// one plane that are sent to one rank: indices of the first mode in an array and in the messages to all
/// ranks, number of modes.
template <class Copy>
void MeshTransform::for_each_piece(const Copy& copy) const {
  for (const Planes& to : wave_planes_)
    for (int i = 0; i < planes(); ++i)
      copy((std::ptrdiff_t{i} * points_[1] + to.first) * row_,
           (std::ptrdiff_t{planes()} * to.first + std::ptrdiff_t{i} * to.count) * row_, to.count * row_);
}

/// Exchanges rows among all ranks. A rank owns the planes before[rank] before the exchange and after[rank]
/// after it. The rows in `from` are in the order of their receivers, those in `to` in the order of their
/// senders.
void MeshTransform::exchange(const FftwArray& from, const std::vector<Planes>& before, const FftwArray& to,
                             const std::vector<Planes>& after) const {
  std::vector<int> sent, first_sent, received, first_received;
  for (const Planes& part : after) {
    sent.push_back(before[rank_].count * part.count);
    first_sent.push_back(before[rank_].count * part.first);
  }
  for (const Planes& part : before) {
    received.push_back(after[rank_].count * part.count);
    first_received.push_back(after[rank_].count * part.first);
  }
  MPI_Datatype row;
  MPI_Type_contiguous(static_cast<int>(2 * row_), MPI_DOUBLE, &row);
  MPI_Type_commit(&row);
  MPI_Alltoallv(from.get(), sent.data(), first_sent.data(), row, to.get(), received.data(),
                first_received.data(), row, communicator_.get());
  MPI_Type_free(&row);
}

void MeshTransform::forward(const FftwArray& a) const {
  const std::ptrdiff_t plane_size = points_[1] * row_;
  for (int i = 0; i < planes(); ++i) {
    Complex* const own = as_complex(a) + i * plane_size;
    std::fill(as_complex(scratch_[1]) + used_[1] * row_, as_complex(scratch_[1]) + plane_size, 0);
    fftw_execute_dft_r2c(forward_.along_z.get(), reinterpret_cast<double*>(own),
                         fftw(as_complex(scratch_[1])));
    fftw_execute_dft(forward_.along_y.get(), fftw(as_complex(scratch_[1])), fftw(own));
  }
  if (exchanged_) {
    for_each_piece([&](std::ptrdiff_t in_array, std::ptrdiff_t in_messages, std::ptrdiff_t count) {
      std::copy_n(as_complex(a) + in_array, count, as_complex(exchanged_) + in_messages);
    });
    exchange(exchanged_, planes_, a, wave_planes_);
  }
  transform_along_x(forward_.along_x, a, used_[0], points_[0]);
}

void MeshTransform::backward(const FftwArray& a) const {
  transform_along_x(backward_.along_x, a, points_[0], used_[0]);
  if (exchanged_) {
    exchange(a, wave_planes_, exchanged_, planes_);
    for_each_piece([&](std::ptrdiff_t in_array, std::ptrdiff_t in_messages, std::ptrdiff_t count) {
      std::copy_n(as_complex(exchanged_) + in_messages, count, as_complex(a) + in_array);
    });
  }
  const std::ptrdiff_t plane_size = points_[1] * row_;
  for (int i = 0; i < planes(); ++i) {
    Complex* const own = as_complex(a) + i * plane_size;
    std::copy_n(own, plane_size, as_complex(scratch_[0]));  // faster than reading columns from memory
    fftw_execute(backward_.along_y.get());
    fftw_execute_dft_c2r(backward_.along_z.get(), fftw(as_complex(scratch_[1])),
                         reinterpret_cast<double*>(own));
  }
}

/// Transforms along the first axis, one plane of wavevectors after the other.
/// `read` and `written`: number of planes along this axis; beyond those read, the values are 0.
void MeshTransform::transform_along_x(const FftwPlan& lines, const FftwArray& a, int read,
                                      int written) const {
  const std::ptrdiff_t stride = wave_planes_[rank_].count * row_;
  for (int j = 0; j < wave_planes_[rank_].count; ++j) {
    Complex* const own = as_complex(a) + j * row_;
    for (int i = 0; i < read; ++i) std::copy_n(own + i * stride, row_, as_complex(scratch_[0]) + i * row_);
    std::fill(as_complex(scratch_[0]) + read * row_, as_complex(scratch_[0]) + points_[0] * row_, 0);
    fftw_execute(lines.get());
    for (int i = 0; i < written; ++i) std::copy_n(as_complex(scratch_[1]) + i * row_, row_, own + i * stride);
  }
}

}  // namespace beadswim
