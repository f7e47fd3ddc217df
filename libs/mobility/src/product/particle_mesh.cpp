#include "particle_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "beadswim/core/error.hpp"
#include "beadswim/core/keyed_random.hpp"
#include "beadswim/mobility/ewald_split.hpp"
#include "mobility_kernels.hpp"

namespace beadswim {

ParticleMesh::ParticleMesh(const EwaldPlan& plan, const ImagedSpheres& spheres,
                           const std::optional<FluidMemory>& memory,
                           const std::optional<HalfSpace>& half_space, Receivers receivers,
                           const Communicator& communicator)
    : plan_(plan),
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
  if (!is_periodic()) return;
  std::array<int, 3> points;
  for (int a = 0; a < 3; ++a) {
    points[a] = next_fft_size(spheres.lengths[a] / plan.spacing);
    spacing_[a] = spheres.lengths[a] / points[a];
  }
  set_points(points);
  if (memory) {
    std::array<double, 3> exponent;
    for (int a = 0; a < 3; ++a) exponent[a] = share(a) / (8 * plan_.xi * plan_.xi);
    memory_ = std::make_unique<MemoryField>(*memory, spheres_, points, exponent, *transform_);
    fields_ = memory_->classes().size();
  }
}

void ParticleMesh::set_points(const std::array<int, 3>& points) {
  values_.clear();
  transform_ = std::make_unique<MeshTransform>(points, communicator_);
  geometry_.window = plan_.window;
  geometry_.row_length = 2 * (points[2] / 2 + 1);  // padded for transforms in place
  geometry_.first_plane = transform_->first_plane();
  geometry_.planes = transform_->planes();
  const double half = plan_.window / 2.0, decay = plan_.window_shape * plan_.window_shape / (2 * half * half);
  for (int a = 0; a < 3; ++a) {
    geometry_.points[a] = points[a];
    geometry_.inverse_spacing[a] = 1 / spacing_[a];
    geometry_.inverse_points[a] = 1.0 / points[a];
    geometry_.decay[a] = decay;
    geometry_.height[a] = std::sqrt(decay / std::numbers::pi) / spacing_[a];
    for (int p = 0; p < plan_.window; ++p) geometry_.decay_at[a][p] = std::exp(-decay * p * p);
  }
}

/// Returns `share`, the part of the exponent of the far part's Gaussian that the windows apply along one
/// axis. It follows from 2 xi^2 h^2/share = decay, where h is the mesh spacing and the window is
/// exp(-decay d^2) at the distance d in units of h.
double ParticleMesh::share(int axis) const {
  const double xh = plan_.xi / geometry_.inverse_spacing[axis];
  return 2 * xh * xh / geometry_.decay[axis];
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
  std::array<int, 3> points;
  for (int a = 0; a < 3; ++a) {
    spacing_[a] = plan_.spacing;
    points[a] = next_fft_size(2 * (std::floor((high[a] - low[a]) / plan_.spacing) + plan_.window) - 1);
    geometry_.origin[a] = low[a] - plan_.window / 2 * plan_.spacing;
  }
  if (transform_ && std::ranges::equal(points, geometry_.points)) return;
  set_points(points);
  sample_kernel();
  pressure_kernel_.clear();
}

/// Returns the Fourier transforms of the components of function(d), where d is the vector from a force to a
/// mesh point in open space [length], times the volume of a mesh cell over the number of mesh points. part(z)
/// selects the part of the complex number z that is not 0: real for an even function, imaginary for an odd
/// one.
template <std::size_t components, class Function, class Part>
std::vector<std::array<double, components>> ParticleMesh::transformed(const Function& function,
                                                                      const Part& part) const {
  const auto& n = geometry_.points;
  const auto displacement = [&](int i, int axis) {
    return (2 * i >= n[axis] ? i - n[axis] : i) * plan_.spacing;
  };
  std::array<FftwArray, components> samples;
  for (FftwArray& s : samples) s = transform_->array();
  for (int i = 0; i < geometry_.planes; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      const std::ptrdiff_t row = (std::ptrdiff_t{i} * n[1] + j) * geometry_.row_length;
      for (int l = 0; l < n[2]; ++l) {
        const std::array<double, components> values = function(
            Vec3(displacement(geometry_.first_plane + i, 0), displacement(j, 1), displacement(l, 2)));
        for (std::size_t c = 0; c < components; ++c) samples[c][row + l] = values[c];
      }
    }
  }
  std::vector<std::array<double, components>> waves(transform_->wave_count());
  const double scale = std::pow(plan_.spacing, 3) / (double(n[0]) * n[1] * n[2]);
  for (std::size_t c = 0; c < components; ++c) {
    transform_->forward(samples[c]);
    for (std::ptrdiff_t w = 0; w < transform_->wave_count(); ++w)
      waves[w][c] = scale * part(as_complex(samples[c])[w]);
  }
  return waves;
}

void ParticleMesh::sample_kernel() {
  kernel_.clear();
  for (std::size_t k = 0; k < fields_; ++k) {
    const auto tensor_at = [&](const Vec3& d) {
      const double r = d.norm();
      const SplitTensor parts = far_tensor(plan_.xi, share(0), r, spheres_.viscosity);
      const PairTensor tensor = k == 0 ? parts.sphere_tensor({.squares = fields_ == 1 ? shared_size_ : 0})
                                       : PairTensor{parts.laplacian.isotropic / 6, parts.laplacian.axial / 6};
      const Vec3 unit = r > 0 ? Vec3(d / r) : Vec3::Zero();
      std::array<double, 6> elements;
      int c = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b, ++c)
          elements[c] = (a == b ? tensor.isotropic : 0) + tensor.axial * unit[a] * unit[b];
      return elements;
    };
    kernel_.push_back(transformed<6>(tensor_at, [](const Complex& z) { return z.real(); }));
  }
}

/// Samples the kernel of p/eta, without the windows.
void ParticleMesh::sample_pressure_kernel() {
  pressure_ = transform_->array();
  const auto pressure_at = [&](const Vec3& d) {
    const double factor = far_pressure(plan_.xi, share(0), d.norm(), spheres_.viscosity);
    return std::array{factor * d[0], factor * d[1], factor * d[2]};
  };
  pressure_kernel_ = transformed<3>(pressure_at, [](const Complex& z) { return z.imag(); });
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
      std::fill_n(onto[c], transform_->reals(), 0.0);
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
  std::array<double, 3> wave;                // wavenumber per index
  std::array<std::vector<double>, 3> decay;  // factor of the kernel's Gaussian, by the magnitude of the index
  for (int a = 0; a < 3; ++a) {
    wave[a] = 2 * std::numbers::pi / spheres_.lengths[a];
    const double exponent = (1 - share(a)) * wave[a] * wave[a] / (4 * plan_.xi * plan_.xi);
    for (int i = 0; i <= n[a] / 2; ++i) decay[a].push_back(std::exp(-exponent * i * i));
  }
  const std::vector<FieldFactors> factors = field_factors();
  std::vector<double> kz, decay_z;
  for (int l = 0; l < geometry_.row_length; ++l) {
    kz.push_back(l / 2 * wave[2]);
    decay_z.push_back(decay[2][l / 2]);
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
              .xi = plan_.xi,
              .scale = scale * decay[0][std::abs(i)] * decay[1][std::abs(j)] / spheres_.viscosity,
              .decay = decay_z.data()},
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
  std::array<double, 3> wave, exponent;
  for (int a = 0; a < 3; ++a) {
    wave[a] = 2 * std::numbers::pi / spheres_.lengths[a];
    exponent[a] = (1 - share(a)) / (4 * plan_.xi * plan_.xi);
  }
  // Beyond this wavenumber the mesh has no modes along one axis, and the far part is negligible.
  const double largest = (1 - 1e-9) * std::numbers::pi / std::ranges::max(spacing_);
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
    const double decay =
        std::exp(-(exponent[0] * k[0] * k[0] + exponent[1] * k[1] * k[1] + exponent[2] * k[2] * k[2]));
    const double size = std::sqrt(scale * decay * (1 + k2 / (4 * plan_.xi * plan_.xi)) / k2 / 2);
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

namespace {

/// Returns the product of a symmetric tensor, stored as (xx, xy, xz, yy, yz, zz), and a vector.
std::array<Complex, 3> times(const std::array<double, 6>& t, const std::array<Complex, 3>& f) {
  return {t[0] * f[0] + t[1] * f[1] + t[2] * f[2], t[1] * f[0] + t[3] * f[1] + t[4] * f[2],
          t[2] * f[0] + t[4] * f[1] + t[5] * f[2]};
}

}  // namespace

void ParticleMesh::multiply_open() {
  for (std::ptrdiff_t place = 0; place < transform_->wave_count(); ++place) {
    std::array<Complex, 3> F, D;
    for (int c = 0; c < 3; ++c) {
      F[c] = as_complex(values_[0][c])[place];
      if (fields_ == 2) D[c] = as_complex(values_[1][c])[place];
    }
    auto u = times(kernel_[0][place], F);
    if (fields_ == 2) {
      const auto by_size = times(kernel_[1][place], D), second = times(kernel_[1][place], F);
      for (int c = 0; c < 3; ++c) {
        u[c] += by_size[c];
        as_complex(values_[1][c])[place] = second[c];
      }
    }
    for (int c = 0; c < 3; ++c) as_complex(values_[0][c])[place] = u[c];
  }
}

}  // namespace beadswim
