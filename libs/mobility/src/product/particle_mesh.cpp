#include "particle_mesh.hpp"

#include <fmt/core.h>

#include <Eigen/QR>
#include <algorithm>
#include <numbers>
#include <numeric>

#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {
namespace {

/// Number of taps of the filter that undoes the windows, beside the one at 0.
constexpr int taps = 32;

/// Returns the taps d_0 to d_32 of a symmetric filter along one axis of a mesh of spacing h. Its Fourier
/// transform d(k) = d_0 + 2 sum d_j cos(j k h) has the smallest mean square of (d W^2 - 1) s(k)/k, the error
/// of the flow of random forces (ewald_plan.cpp).
Eigen::VectorXd filter(const WindowTable& window, const EwaldSplit& split, double h) {
  constexpr int samples = 240;
  Eigen::MatrixXd cosines(samples, taps + 1);
  Eigen::VectorXd wanted(samples);
  for (int n = 0; n < samples; ++n) {
    const double k = std::numbers::pi * (n + 0.5) / samples, w = window.transform(k);
    wanted[n] = split.far_share(k / h) / std::max(k, 0.1);
    for (int j = 0; j <= taps; ++j) cosines(n, j) = (j == 0 ? 1 : 2) * std::cos(j * k) * w * w * wanted[n];
  }
  return cosines.colPivHouseholderQr().solve(wanted);
}

}  // namespace

ParticleMesh::ParticleMesh(const EwaldPlan& plan, const ImagedSpheres& spheres,
                           const std::optional<FluidMemory>& memory,
                           const std::optional<HalfSpace>& half_space, Receivers receivers,
                           const Communicator& communicator)
    : plan_(plan),
      split_(plan.cutoff, plan.shape),
      window_(plan.window, plan.window_shape),
      spheres_(spheres),
      at_points_(receivers == Receivers::points),
      half_space_(half_space),
      communicator_(communicator) {
  const auto [smallest, largest] = std::ranges::minmax_element(spheres.radii);
  // At mirror points the velocities of one field would contain the size of the bead there, which the wall's
  // reflection takes into account itself (wall_reflection.hpp).
  const bool is_shared = spheres.order == 0 && *smallest == *largest &&
                         (at_points_ || !(plan.has_mirror_points && *largest > 0));
  if (is_shared) shared_size_ = (at_points_ ? 1 : 2) * (*largest * *largest);
  if (!is_shared) fields_ = 2;
  if (!is_periodic()) {
    filter_ = filter(window_, split_, plan_.spacing);
    return;
  }
  std::array<int, 3> points;
  for (int a = 0; a < 3; ++a) {
    points[a] = next_fft_size(spheres.lengths[a] / plan.spacing);
    spacing_[a] = spheres.lengths[a] / points[a];
  }
  set_points(points, points);
  if (memory) {
    memory_ = std::make_unique<MemoryField>(
        *memory, spheres_, points, std::array{inverse_windows(0), inverse_windows(1), inverse_windows(2)},
        *transform_);
    fields_ = memory_->classes().size();
  }
}

void ParticleMesh::set_points(const std::array<int, 3>& points, const std::array<int, 3>& used) {
  values_.clear();
  transform_ = std::make_unique<MeshTransform>(points, used, communicator_);
  geometry_.window = plan_.window;
  geometry_.row_length = 2 * (points[2] / 2 + 1);  // padded for transforms in place
  geometry_.first_plane = transform_->first_plane();
  geometry_.planes = transform_->planes();
  geometry_.degree = window_.degree();
  geometry_.polynomials = window_.polynomials();
  for (int a = 0; a < 3; ++a) {
    geometry_.points[a] = points[a];
    geometry_.inverse_spacing[a] = 1 / spacing_[a];
    geometry_.inverse_points[a] = 1.0 / points[a];
  }
}

/// Returns 1 over the Fourier transform of the windows along one axis, by the magnitude of the index.
std::vector<double> ParticleMesh::inverse_windows(int axis) const {
  const int points = geometry_.points[axis];
  std::vector<double> inverse;
  for (int i = 0; i <= points / 2; ++i)
    inverse.push_back(1 / window_.transform(2 * std::numbers::pi * i / points));
  return inverse;
}

/// In open space, fits the mesh to the positions of beads and mirror points.
void ParticleMesh::fit_to(const Eigen::AlignedBox3d& bounds) {
  const Vec3 &low = bounds.min(), &high = bounds.max();
  constexpr double max_points = 1e10;
  const Vec3 wanted = 2 * ((high - low) / plan_.spacing + Vec3::Constant(plan_.window));
  if (!(wanted.prod() < max_points)) {
    throw SolverError(
        fmt::format("the swarm of beads spans {:.3g} x {:.3g} x {:.3g}, too much for a mesh of spacing "
                    "{:.3g}; the run may have become unstable: reduce the driving amplitude",
                    high[0] - low[0], high[1] - low[1], high[2] - low[2], plan_.spacing));
  }
  std::array<int, 3> points, used;
  for (int a = 0; a < 3; ++a) {
    spacing_[a] = plan_.spacing;
    used[a] = static_cast<int>(std::floor((high[a] - low[a]) / plan_.spacing)) + plan_.window + 1;
    points[a] = next_fft_size(2 * used[a] - 3);
    used[a] = std::min(used[a], points[a]);
    geometry_.origin[a] = low[a] - 0.5 * plan_.window * plan_.spacing;
  }
  if (transform_ && std::ranges::equal(points, geometry_.points) && transform_->used() == used) return;
  set_points(points, used);
  sample_kernel();
  pressure_kernel_.clear();
}

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

}  // namespace

/// Returns the values of a function at the distances i h, j h, l h along the axes, without the windows, where
/// i = 0 to half the number of mesh points, likewise j and l. is_odd: true for an axis if the function
/// changes its sign with this coordinate.
std::vector<double> ParticleMesh::octant(const std::function<double(const Vec3&)>& function,
                                         const std::array<bool, 3>& is_odd) const {
  std::array<RowMajor, 3> filters;  // from the distances 0 to half + taps
  for (int a = 0; a < 3; ++a) {
    const int half = geometry_.points[a] / 2;
    filters[a].setZero(half + 1, half + 1 + taps);
    for (int to = 0; to <= half; ++to)
      for (int j = -taps; j <= taps; ++j) {
        const int from = to + j;
        filters[a](to, std::abs(from)) += (from < 0 && is_odd[a] ? -1 : 1) * filter_[std::abs(j)];
      }
  }
  const Eigen::Index nx = filters[0].cols(), ny = filters[1].cols(), nz = filters[2].cols(),
                     rows = filters[1].rows() * filters[2].rows();
  RowMajor planes(nx, rows), plane(ny, nz);
  for (Eigen::Index i = 0; i < nx; ++i) {
    for (Eigen::Index j = 0; j < ny; ++j)
      for (Eigen::Index l = 0; l < nz; ++l)
        plane(j, l) = function(plan_.spacing *
                               Vec3(static_cast<double>(i), static_cast<double>(j), static_cast<double>(l)));
    RowMajor filtered = filters[1] * (plane * filters[2].transpose());
    planes.row(i) = Eigen::Map<const Eigen::RowVectorXd>(filtered.data(), rows);
  }
  std::vector<double> values(filters[0].rows() * rows);
  Eigen::Map<RowMajor>(values.data(), filters[0].rows(), rows).noalias() = filters[0] * planes;
  return values;
}

/// Calls set(w, value) for the Fourier transform of a function of the vector from a force to a mesh point
/// [length] at each wavevector w: its real part if the function is even, its imaginary part if it is odd. The
/// values contain the volume of a mesh cell over the number of mesh points.
void ParticleMesh::transform_kernel(const MeshTransform& whole,
                                    const std::function<double(const Vec3&)>& function,
                                    const std::array<bool, 3>& is_odd,
                                    const std::function<void(std::ptrdiff_t, double)>& set) const {
  const auto& n = geometry_.points;
  const std::vector<double> values = octant(function, is_odd);
  const FftwArray samples = whole.array();
  const auto folded = [&](int i, int a) { return 2 * i >= n[a] ? n[a] - i : i; };
  const auto sign = [&](int i, int a) { return 2 * i >= n[a] && is_odd[a] ? -1 : 1; };
  for (int p = 0; p < whole.planes(); ++p) {
    const int i = whole.first_plane() + p;
    for (int j = 0; j < n[1]; ++j) {
      double* const row = samples.get() + (std::ptrdiff_t{p} * n[1] + j) * geometry_.row_length;
      const double* const from =
          &values[(std::ptrdiff_t{folded(i, 0)} * (n[1] / 2 + 1) + folded(j, 1)) * (n[2] / 2 + 1)];
      for (int l = 0; l < n[2]; ++l) row[l] = sign(i, 0) * sign(j, 1) * sign(l, 2) * from[folded(l, 2)];
    }
  }
  whole.forward(samples);
  const double scale = std::pow(plan_.spacing, 3) / (double(n[0]) * n[1] * n[2]);
  const bool is_imaginary = (is_odd[0] ? 1 : 0) + (is_odd[1] ? 1 : 0) + (is_odd[2] ? 1 : 0) == 1;
  for (std::ptrdiff_t w = 0; w < transform_->wave_count(); ++w) {
    const Complex& z = as_complex(samples)[w];
    set(w, scale * (is_imaginary ? z.imag() : z.real()));
  }
}

void ParticleMesh::sample_kernel() {
  kernel_.assign(6 * fields_, std::vector<double>(transform_->wave_count()));
  const MeshTransform whole(transform_->points(), transform_->points(), communicator_);
  for (std::size_t k = 0; k < fields_; ++k) {
    const auto tensor_at = [&](double r) {
      const SplitTensor parts = far_tensor(split_, r, spheres_.viscosity);
      return k == 0 ? parts.sphere_tensor({.squares = fields_ == 1 ? shared_size_ : 0})
                    : PairTensor{parts.laplacian.isotropic / 6, parts.laplacian.axial / 6};
    };
    int c = 0;
    for (int a = 0; a < 3; ++a)
      for (int b = a; b < 3; ++b, ++c) {
        std::array<bool, 3> is_odd{};
        if (a != b) is_odd[a] = is_odd[b] = true;
        const auto element = [&](const Vec3& d) {
          const double r = d.norm();
          const PairTensor tensor = tensor_at(r);
          return (a == b ? tensor.isotropic : 0) + (r > 0 ? tensor.axial * d[a] * d[b] / (r * r) : 0);
        };
        transform_kernel(whole, element, is_odd,
                         [&](std::ptrdiff_t w, double value) { kernel_[6 * k + c][w] = value; });
      }
  }
}

/// Samples the kernel of p/eta, without the windows.
void ParticleMesh::sample_pressure_kernel() {
  pressure_ = transform_->array();
  pressure_kernel_.resize(transform_->wave_count());
  const MeshTransform whole(transform_->points(), transform_->points(), communicator_);
  for (int c = 0; c < 3; ++c) {
    std::array<bool, 3> is_odd{};
    is_odd[c] = true;
    transform_kernel(
        whole, [&](const Vec3& d) { return far_pressure(split_, d.norm(), spheres_.viscosity) * d[c]; },
        is_odd, [&](std::ptrdiff_t w, double value) { pressure_kernel_[w][c] = value; });
  }
}

/// Sets the Fourier transform of the pressure from that of the forces.
void ParticleMesh::set_pressure() {
  if (pressure_kernel_.empty()) sample_pressure_kernel();
  for (std::ptrdiff_t w = 0; w < transform_->wave_count(); ++w) {
    Complex sum = 0;
    for (int c = 0; c < 3; ++c) sum += Complex(0, pressure_kernel_[w][c]) * as_complex(values_[0][c])[w];
    as_complex(pressure_)[w] = sum;
  }
}

ParticleMesh::SortedBeads ParticleMesh::sorted(std::span<const Vec3> positions) const {
  const auto index = [&](const Vec3& x, int a) {
    const double place = (x[a] - geometry_.origin[a]) * geometry_.inverse_spacing[a], n = geometry_.points[a];
    const double folded = place - n * std::floor(place / n);
    return folded > 0 ? static_cast<int>(std::min(folded, n - 1)) : 0;
  };
  std::vector<int> row(positions.size()), start(geometry_.points[0] * geometry_.points[1] + 1, 0);
  for (std::size_t b = 0; b < positions.size(); ++b)
    ++start[(row[b] = index(positions[b], 0) * geometry_.points[1] + index(positions[b], 1)) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  SortedBeads beads{.order = std::vector<int>(positions.size()), .places = {}};
  for (std::size_t b = 0; b < positions.size(); ++b) beads.order[start[row[b]]++] = static_cast<int>(b);
  for (const int b : beads.order) beads.places.push_back(positions[b]);
  return beads;
}

void ParticleMesh::set_sources(std::span<const Vec3> positions, const Eigen::AlignedBox3d& around_receivers) {
  if (!is_periodic()) {
    Eigen::AlignedBox3d bounds = bounding_box(positions).merged(around_receivers);
    if (plan_.has_mirror_points)
      for (const Vec3& corner : {around_receivers.min(), around_receivers.max()})
        bounds.extend(half_space_->mirrored(corner));
    fit_to(bounds);
  }
  sources_ = sorted(positions);
}

void ParticleMesh::set_receivers(std::span<const Vec3> positions) {
  receivers_ = sorted(positions);
  if (!plan_.has_mirror_points) return;
  std::vector<Vec3> mirror_points;
  for (const Vec3& position : positions) mirror_points.push_back(half_space_->mirrored(position));
  mirrors_ = sorted(mirror_points);
}

/// Returns the factor of a derivative of a bead in a field: 1 in F, 6 c_l a^2 in D, or the share of a class.
double ParticleMesh::weight_of(std::size_t field, int bead, std::size_t derivative) const {
  const int degree = derivative_table.order[derivative];
  if (memory_) return memory_->share(field, bead, degree);
  return field == 0 ? 1 : 6 * size_factors[degree] * (spheres_.radii[bead] * spheres_.radii[bead]);
}

void ParticleMesh::read_sources(std::span<const double> sources) {
  const std::size_t elements = spheres_.elements(), count = elements / 3;
  std::vector<double> sorted(sources.size());
  values_.resize(fields_);
  for (std::size_t f = 0; f < fields_; ++f) {
    for (std::size_t s = 0; s < sources_.order.size(); ++s) {
      const int bead = sources_.order[s];
      for (std::size_t n = 0; n < elements; ++n)
        sorted[elements * s + n] = weight_of(f, bead, n % count) * sources[elements * bead + n];
    }
    std::array<double*, 3> onto;
    for (int c = 0; c < 3; ++c) {
      if (!values_[f][c]) values_[f][c] = transform_->array();
      onto[c] = values_[f][c].get();
      std::fill_n(onto[c], std::ptrdiff_t{geometry_.planes} * geometry_.points[1] * geometry_.row_length,
                  0.0);
    }
    best_kernels<MobilityKernels>().spread(spheres_.order, geometry_, sources_.windows(), sorted.data(),
                                           onto.data());
  }
  for (auto& field : values_)
    for (FftwArray& component : field) transform_->forward(component);
  if (memory_) memory_->read_forces(values_);
}

/// Replaces the Fourier modes of the sources by those of the flow, and transforms back.
void ParticleMesh::multiply(FlowPart part) {
  is_periodic() ? multiply_periodic() : multiply_open();
  if (memory_) memory_->add_flow(values_, part == FlowPart::all);
  for (auto& field : values_)
    for (FftwArray& component : field) transform_->backward(component);
}

std::vector<double> ParticleMesh::gathered(std::size_t field, const SortedBeads& receivers, int order) const {
  const std::array<const double*, 3> from{values_[field][0].get(), values_[field][1].get(),
                                          values_[field][2].get()};
  std::vector<double> sums(3 * derivative_count(order) * receivers.order.size(), 0.0);
  best_kernels<MobilityKernels>().gather(order, geometry_, receivers.windows(), 3, from.data(), sums.data());
  return sums;
}

void ParticleMesh::gather(std::span<double> flows) const {
  const std::size_t count = derivative_count(receiver_order()), elements = 3 * count;
  const double volume = cell_volume();
  for (std::size_t f = 0; f < (at_points_ ? 1 : fields_); ++f) {
    const std::vector<double> sums = gathered(f, receivers_, receiver_order());
    for (std::size_t s = 0; s < receivers_.order.size(); ++s) {
      const int bead = receivers_.order[s];
      for (std::size_t n = 0; n < elements; ++n)
        flows[elements * bead + n] +=
            volume * (at_points_ ? 1 : weight_of(f, bead, n % count)) * sums[elements * s + n];
    }
  }
}

void ParticleMesh::add_flows(std::span<const double> sources, FlowPart part, std::span<double> flows,
                             std::span<MirrorFlow> at_mirrors) {
  evaluate(sources, part);
  gather_flows(flows, at_mirrors);
}

void ParticleMesh::evaluate(std::span<const double> sources, FlowPart part) {
  read_sources(sources);
  if (plan_.has_mirror_points) set_pressure();
  multiply(part);
  if (plan_.has_mirror_points) transform_->backward(pressure_);
}

void ParticleMesh::gather_flows(std::span<double> flows, std::span<MirrorFlow> at_mirrors) const {
  gather(flows);
  if (plan_.has_mirror_points) gather_mirrors(at_mirrors);
}

void ParticleMesh::evaluate_remainder() {
  memory_->set_remainder(values_[0]);
  for (const FftwArray& component : values_[0]) transform_->backward(component);
}

void ParticleMesh::gather_remainder(std::span<const Vec3> points, std::span<double> flows) const {
  const SortedBeads receivers = sorted(points);
  const std::vector<double> sums = gathered(0, receivers, 0);
  for (std::size_t s = 0; s < points.size(); ++s)
    for (int c = 0; c < 3; ++c) flows[3 * receivers.order[s] + c] += cell_volume() * sums[3 * s + c];
}

void ParticleMesh::gather_mirrors(std::span<MirrorFlow> at_mirrors) const {
  const std::size_t points = mirrors_.order.size();
  const int order = receiver_order(), high_order = at_points_ ? 1 : order + 2;
  const std::size_t count = derivative_count(order), high = derivative_count(high_order);
  std::vector<double> velocities(2 * count * points, 0.0), others(2 * high * points, 0.0);
  const int axis = half_space_->axis;
  const std::array<const double*, 2> along{values_[0][(axis + 1) % 3].get(),
                                           values_[0][(axis + 2) % 3].get()},
      across{values_[0][axis].get(), pressure_.get()};
  const auto gather = best_kernels<MobilityKernels>().gather;
  gather(order, geometry_, mirrors_.windows(), 2, along.data(), velocities.data());
  gather(high_order, geometry_, mirrors_.windows(), 2, across.data(), others.data());
  const double volume = cell_volume();
  for (std::size_t s = 0; s < points; ++s) {
    MirrorFlow& flow = at_mirrors[mirrors_.order[s]];
    for (int t = 0; t < 2; ++t)
      for (std::size_t d = 0; d < count; ++d)
        flow.along[t][d] += volume * velocities[(2 * s + t) * count + d];
    for (std::size_t d = 0; d < high; ++d) {
      flow.across[d] += volume * others[2 * high * s + d];
      flow.pressure[d] += volume * others[2 * high * s + high + d];
    }
  }
}

/// Returns the factors of each field in F and in D.
std::vector<FieldFactors> ParticleMesh::field_factors() const {
  if (fields_ == 1) return {{1, shared_size_ / 2}};
  if (!memory_) return {{1, 0}, {0, 1}};
  std::vector<FieldFactors> factors;
  for (const SourceClass& each : memory_->classes())
    factors.push_back({1, 6 * size_factors[each.degree] * each.radius * each.radius});
  return factors;
}

/// Replaces the Fourier modes of the sources in a periodic box by those of their flow.
void ParticleMesh::multiply_periodic() {
  const auto& n = geometry_.points;
  std::array<double, 3> wave;                  // wavenumber per index
  std::array<std::vector<double>, 3> windows;  // inverse squares, by the magnitude of the index
  for (int a = 0; a < 3; ++a) {
    wave[a] = 2 * std::numbers::pi / spheres_.lengths[a];
    windows[a] = inverse_windows(a);
    for (double& window : windows[a]) window *= window;
  }
  const std::vector<FieldFactors> factors = field_factors();
  std::vector<double> kz, window_z;
  for (int l = 0; l < geometry_.row_length; ++l) {
    kz.push_back(l / 2 * wave[2]);
    window_z.push_back(windows[2][l / 2]);
  }
  const double scale = 1 / (double(n[0]) * n[1] * n[2]);  // h^3/V: mesh cell over box volume
  std::vector<double*> rows(3 * fields_);
  const auto multiply = best_kernels<MobilityKernels>().multiply_waves;
  transform_->for_each_row([&](std::ptrdiff_t place, int i, int j) {
    for (std::size_t f = 0; f < fields_; ++f)
      for (int c = 0; c < 3; ++c) rows[3 * f + c] = values_[f][c].get() + 2 * place;
    multiply({.count = geometry_.row_length,
              .kx = i * wave[0],
              .ky = j * wave[1],
              .kz = kz.data(),
              .scale = scale * windows[0][std::abs(i)] * windows[1][std::abs(j)] / spheres_.viscosity,
              .window = window_z.data(),
              .far_terms = split_.far_terms.data(),
              .terms = static_cast<int>(split_.far_terms.size()),
              .square = split_.shape * split_.shape,
              .cutoff_square = split_.cutoff * split_.cutoff},
             static_cast<int>(fields_), factors.data(), rows.data());
  });
}

void ParticleMesh::set_noise(std::uint64_t seed) {
  values_.resize(fields_);
  for (auto& field : values_)
    for (FftwArray& component : field) {
      if (!component) component = transform_->array();
      std::fill_n(component.get(), transform_->reals(), 0.0);
    }
  const auto& n = geometry_.points;
  std::array<double, 3> wave;
  std::array<std::vector<double>, 3> windows;
  for (int a = 0; a < 3; ++a) {
    wave[a] = 2 * std::numbers::pi / spheres_.lengths[a];
    windows[a] = inverse_windows(a);
  }
  // Beyond this wavenumber the mesh has no modes along one axis, and the far part is negligible.
  const double largest =
      std::min((1 - 1e-9) * std::numbers::pi / std::ranges::max(spacing_), split_.shape / split_.cutoff);
  const double scale = 1 / (double(n[0]) * n[1] * n[2] * cell_volume() * spheres_.viscosity);
  const std::vector<FieldFactors> factors = field_factors();
  transform_->for_each_wave([&](std::ptrdiff_t place, int i, int j, int l) {
    // Of two modes that are conjugate, the mesh contains both if l is 0. The largest wavenumber excludes
    // others.
    const bool is_mirrored = l == 0 && (i < 0 || (i == 0 && j < 0));
    const std::int64_t x = is_mirrored ? -i : i, y = is_mirrored ? -j : j;
    const Vec3 k(static_cast<double>(x) * wave[0], static_cast<double>(y) * wave[1], l * wave[2]);
    const double k2 = k.squaredNorm();
    if (k2 == 0 || k2 > largest * largest) return;
    KeyedRandom random(seed, static_cast<std::uint64_t>((x * n[1] + y) * n[2] + l), 0);
    const double window = windows[0][std::abs(i)] * windows[1][std::abs(j)] * windows[2][l];
    const double size = window * std::sqrt(scale * split_.far_share(std::sqrt(k2)) / k2 / 2);
    const Vec3 first = k.unitOrthogonal(), second = k.cross(first) / std::sqrt(k2);
    const auto [a, b] = random.normal_pair();
    const auto [c, d] = random.normal_pair();
    const Vec3 real = size * (a * first + c * second),
               imaginary = (is_mirrored ? -size : size) * (b * first + d * second);
    for (std::size_t f = 0; f < fields_; ++f)
      for (int axis = 0; axis < 3; ++axis)
        as_complex(values_[f][axis])[place] =
            (factors[f].p - factors[f].q * k2 / 6) * Complex(real[axis], imaginary[axis]);
  });
  for (auto& field : values_)
    for (FftwArray& component : field) transform_->backward(component);
}

void ParticleMesh::multiply_open() {
  std::vector<const double*> kernel;
  for (const auto& element : kernel_) kernel.push_back(element.data());
  std::vector<double*> values;
  for (auto& field : values_)
    for (FftwArray& component : field) values.push_back(component.get());
  best_kernels<MobilityKernels>().multiply_tensors(transform_->wave_count(), static_cast<int>(fields_),
                                                   kernel.data(), values.data());
}

}  // namespace beadswim
