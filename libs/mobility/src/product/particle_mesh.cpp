#include "beadswim/mobility/particle_mesh.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "beadswim/core/error.hpp"
#include "beadswim/core/vec3.hpp"
#include "beadswim/mobility/ewald_split.hpp"
#include "beadswim/mobility/force_moments.hpp"
#include "memory_field.hpp"
#include "mesh_transform.hpp"
#include "moment_kernels.hpp"
#include "source_classes.hpp"
#include "wall_reflection.hpp"

namespace beadswim {
namespace {

/// Returns the product of a symmetric tensor, stored as (xx, xy, xz, yy, yz, zz), and a vector.
template <class T>
std::array<Complex, 3> times(const std::array<T, 6>& t, const std::array<Complex, 3>& f) {
  return {t[0] * f[0] + t[1] * f[1] + t[2] * f[2], t[1] * f[0] + t[3] * f[1] + t[4] * f[2],
          t[2] * f[0] + t[4] * f[1] + t[5] * f[2]};
}

}  // namespace

// If all beads have one radius a and only forces act, one field is transformed: the forces F, with D = a^2 F.
// Otherwise a second field D is transformed: the forces times a_j^2, where a_j is the radius of the bead on
// which the force acts. The velocity of bead i is then
//
//   u_i = (K F + L D) + a_i^2 (L F),     K: kernel of the Oseen tensor, L: kernel of its Laplacian/6
//
// With force moments, F is the source of a bead, and 6 c_l a^2 (force_moments.hpp) replaces a^2. Forces are
// the source of order 0.
//
// With memory of the fluid, each class of sources has its own field, because its form factor matters at all
// wavenumbers. F is the sum of all fields, D the sum of the fields times their 6 c_l a^2.
struct ParticleMesh::Mesh {
  EwaldPlan plan;
  Vec3 lengths;
  Beads beads;
  const Communicator& communicator;
  bool is_periodic;
  std::size_t fields = 1;
  std::optional<SourceClasses> classes{};  ///< nullopt: F, or F and D
  double shared_size = 0;  ///< a_i^2 + a_j^2, equal for all pairs if there is one field [length^2]
  WindowMesh geometry{};
  std::array<double, 3> spacing{};  ///< h [length]
  std::unique_ptr<MeshTransform> transform{};
  std::vector<std::array<FftwArray, 3>> values{};  ///< mesh values per field: forces, replaced by velocities
  std::vector<int> order{};                        ///< beads sorted by rows of the mesh, for memory locality
  std::vector<std::vector<std::array<double, 6>>> kernel{};  ///< open space: Fourier transforms of K and L
  /// Over a wall: imaginary part of the Fourier transform of the kernel of p/eta, and mesh values of p/eta.
  std::vector<std::array<double, 3>> pressure_kernel{};
  FftwArray pressure{};
  std::unique_ptr<MemoryField> memory{};  ///< null: steady flow

  void set_points(const std::array<int, 3>& points);
  void fit_to_beads(std::span<const Vec3> positions);
  template <class Sample>
  void for_each_displacement(const Sample& sample) const;
  double open_scale() const;
  void sample_kernel();
  void sample_pressure_kernel();
  void set_pressure();
  void gather_mirrors(int axis, std::span<const Vec3> points, std::span<MirrorFlow> at_mirrors);
  void spread(std::span<const Vec3> positions, std::span<const double> sources);
  void gather(std::span<const Vec3> positions, std::span<double> flows);
  double weight_of(std::size_t field, int bead, std::size_t derivative) const;
  void sort(std::span<const Vec3> positions);
  void transform_forces();
  void multiply(FlowPart part);
  void set_memory();
  std::vector<FieldFactors> field_factors() const;
  void multiply_periodic();
  void multiply_open();
};

ParticleMesh::ParticleMesh(const EwaldPlan& plan, const Vec3& lengths, Beads beads,
                           const Communicator& communicator)
    : mesh_(new Mesh{.plan = plan,
                     .lengths = lengths,
                     .beads = std::move(beads),
                     .communicator = communicator,
                     .is_periodic = lengths[0] > 0}) {
  const std::vector<double>& squares = mesh_->beads.squared_radii;
  const auto [smallest, largest] = std::ranges::minmax_element(squares);
  // At mirror points the velocities of one field would contain the size of the bead there, which the wall's
  // reflection takes into account itself (wall_reflection.hpp).
  const bool is_shared = mesh_->beads.moment_order == 0 && !squares.empty() && *smallest == *largest &&
                         !(plan.has_mirror_points && *largest > 0);
  if (is_shared) mesh_->shared_size = 2 * *largest;
  if (!squares.empty() && !is_shared) mesh_->fields = 2;
  if (mesh_->beads.memory) {
    mesh_->classes.emplace(squares, mesh_->beads.moment_order);
    mesh_->fields = mesh_->classes->size();
  }
  if (!mesh_->is_periodic) return;
  std::array<int, 3> points;
  for (int a = 0; a < 3; ++a) {
    points[a] = next_fft_size(lengths[a] / plan.spacing);
    mesh_->spacing[a] = lengths[a] / points[a];
  }
  mesh_->set_points(points);
  if (mesh_->beads.memory) mesh_->set_memory();
}

ParticleMesh::~ParticleMesh() = default;

void ParticleMesh::Mesh::set_points(const std::array<int, 3>& points) {
  transform = std::make_unique<MeshTransform>(points, communicator);
  geometry.window = plan.window;
  geometry.row_length = 2 * (points[2] / 2 + 1);  // padded for transforms in place
  geometry.first_plane = transform->first_plane();
  geometry.planes = transform->planes();
  const double half = plan.window / 2.0, decay = plan.window_shape * plan.window_shape / (2 * half * half);
  for (int a = 0; a < 3; ++a) {
    geometry.points[a] = points[a];
    geometry.inverse_spacing[a] = 1 / spacing[a];
    geometry.inverse_points[a] = 1.0 / points[a];
    geometry.decay[a] = decay;
    geometry.height[a] = std::sqrt(decay / std::numbers::pi) / spacing[a];
    for (int p = 0; p < plan.window; ++p) geometry.decay_at[a][p] = std::exp(-decay * p * p);
  }
  values.resize(fields);
  for (auto& field : values)
    for (FftwArray& component : field) component = transform->array();
}

namespace {

/// Returns `share`, the part of the exponent of the far part's Gaussian that the windows apply along one
/// axis. It follows from 2 xi^2 h^2/share = decay, where h is the mesh spacing and the window is
/// exp(-decay d^2) at the distance d in units of h (particle_mesh.hpp).
double share_of(const EwaldPlan& plan, const WindowMesh& mesh, int axis) {
  const double xh = plan.xi / mesh.inverse_spacing[axis];
  return 2 * xh * xh / mesh.decay[axis];
}

}  // namespace

void ParticleMesh::Mesh::set_memory() {
  MemoryField::Law law{.fluid = *beads.memory,
                       .viscosity = beads.viscosity,
                       .lengths = lengths,
                       .points = {geometry.points[0], geometry.points[1], geometry.points[2]},
                       .exponent = {},
                       .classes = classes->classes()};
  for (int a = 0; a < 3; ++a) law.exponent[a] = share_of(plan, geometry, a) / (8 * plan.xi * plan.xi);
  memory = std::make_unique<MemoryField>(law, *transform);
}

void ParticleMesh::Mesh::fit_to_beads(std::span<const Vec3> positions) {
  const Eigen::AlignedBox3d bounds = bounding_box(positions);
  const Vec3 &low = bounds.min(), &high = bounds.max();
  constexpr double max_points = 1e10;
  const Vec3 wanted = 2 * ((high - low) / plan.spacing + Vec3::Constant(plan.window));
  if (!(wanted.prod() < max_points)) {
    throw SolverError(
        fmt::format("the swarm of beads spans {:.3g} x {:.3g} x {:.3g}, too much for a mesh of spacing "
                    "{:.3g}; the run may have become unstable: reduce the driving amplitude",
                    high[0] - low[0], high[1] - low[1], high[2] - low[2], plan.spacing));
  }
  std::array<int, 3> points;
  for (int a = 0; a < 3; ++a) {
    spacing[a] = plan.spacing;
    points[a] = next_fft_size(2 * (std::floor((high[a] - low[a]) / plan.spacing) + plan.window) - 1);
    geometry.origin[a] = low[a] - plan.window / 2 * plan.spacing;
  }
  if (transform && std::ranges::equal(points, geometry.points)) return;
  set_points(points);
  sample_kernel();
  pressure_kernel.clear();
}

/// Calls sample(place, d) for each mesh point of this rank in open space, with the vector d from a force to
/// the point [length].
template <class Sample>
void ParticleMesh::Mesh::for_each_displacement(const Sample& sample) const {
  const auto& n = geometry.points;
  const auto displacement = [&](int i, int axis) {
    return (2 * i >= n[axis] ? i - n[axis] : i) * plan.spacing;
  };
  for (int i = 0; i < geometry.planes; ++i) {
    for (int j = 0; j < n[1]; ++j) {
      const std::ptrdiff_t row = (std::ptrdiff_t{i} * n[1] + j) * geometry.row_length;
      for (int l = 0; l < n[2]; ++l)
        sample(row + l,
               Vec3(displacement(geometry.first_plane + i, 0), displacement(j, 1), displacement(l, 2)));
    }
  }
}

/// Returns the factor of a kernel in open space: volume of a mesh cell over number of mesh points.
double ParticleMesh::Mesh::open_scale() const {
  const auto& n = geometry.points;
  return std::pow(plan.spacing, 3) / (double(n[0]) * n[1] * n[2]);
}

void ParticleMesh::Mesh::sample_kernel() {
  kernel.assign(fields, std::vector<std::array<double, 6>>(transform->wave_count()));
  const double share = share_of(plan, geometry, 0), scale = open_scale();
  std::array<FftwArray, 6> samples;
  for (std::size_t k = 0; k < fields; ++k) {
    for (FftwArray& s : samples) s = transform->array();
    for_each_displacement([&](std::ptrdiff_t place, const Vec3& d) {
      const double r = d.norm();
      const SplitTensor parts = far_tensor(plan.xi, share, r, beads.viscosity);
      const PairTensor tensor = k == 0 ? parts.sphere_tensor(fields == 1 ? shared_size : 0)
                                       : PairTensor{parts.laplacian.isotropic / 6, parts.laplacian.axial / 6};
      const Vec3 unit = r > 0 ? Vec3(d / r) : Vec3::Zero();
      int c = 0;
      for (int a = 0; a < 3; ++a)
        for (int b = a; b < 3; ++b, ++c)
          samples[c][place] = (a == b ? tensor.isotropic : 0) + tensor.axial * unit[a] * unit[b];
    });
    for (int c = 0; c < 6; ++c) {
      transform->forward(samples[c]);  // the Fourier transform of an even function is real
      const Complex* waves = as_complex(samples[c]);
      for (std::ptrdiff_t w = 0; w < transform->wave_count(); ++w) kernel[k][w][c] = scale * waves[w].real();
    }
  }
}

/// Samples the kernel of p/eta, without the windows.
void ParticleMesh::Mesh::sample_pressure_kernel() {
  pressure = transform->array();
  pressure_kernel.resize(transform->wave_count());
  const double share = share_of(plan, geometry, 0), scale = open_scale();
  std::array<FftwArray, 3> samples;
  for (FftwArray& s : samples) s = transform->array();
  for_each_displacement([&](std::ptrdiff_t place, const Vec3& d) {
    const double factor = far_pressure(plan.xi, share, d.norm(), beads.viscosity);
    for (int c = 0; c < 3; ++c) samples[c][place] = factor * d[c];
  });
  for (int c = 0; c < 3; ++c) {
    transform->forward(samples[c]);  // the Fourier transform of an odd function is imaginary
    const Complex* waves = as_complex(samples[c]);
    for (std::ptrdiff_t w = 0; w < transform->wave_count(); ++w)
      pressure_kernel[w][c] = scale * waves[w].imag();
  }
}

/// Sets the Fourier transform of the pressure from that of the forces.
void ParticleMesh::Mesh::set_pressure() {
  if (pressure_kernel.empty()) sample_pressure_kernel();
  for (std::ptrdiff_t w = 0; w < transform->wave_count(); ++w) {
    Complex sum = 0;
    for (int c = 0; c < 3; ++c) sum += Complex(0, pressure_kernel[w][c]) * as_complex(values[0][c])[w];
    as_complex(pressure)[w] = sum;
  }
}

void ParticleMesh::Mesh::sort(std::span<const Vec3> positions) {
  const auto index = [&](const Vec3& x, int a) {
    const double place = (x[a] - geometry.origin[a]) * geometry.inverse_spacing[a], n = geometry.points[a];
    const double folded = place - n * std::floor(place / n);
    return folded > 0 ? static_cast<int>(std::min(folded, n - 1)) : 0;
  };
  std::vector<int> row(positions.size()), start(geometry.points[0] * geometry.points[1] + 1, 0);
  for (std::size_t b = 0; b < positions.size(); ++b)
    ++start[(row[b] = index(positions[b], 0) * geometry.points[1] + index(positions[b], 1)) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  order.resize(positions.size());
  for (std::size_t b = 0; b < positions.size(); ++b) order[start[row[b]]++] = static_cast<int>(b);
}

namespace {

std::vector<Vec3> in_order(const std::vector<int>& order, std::span<const Vec3> vectors) {
  std::vector<Vec3> sorted;
  sorted.reserve(order.size());
  for (const int b : order) sorted.push_back(vectors[b]);
  return sorted;
}

}  // namespace

/// Returns the factor of a derivative of a bead in a field: 1 in F, 6 c_l a^2 in D, or the share of a class.
double ParticleMesh::Mesh::weight_of(std::size_t field, int bead, std::size_t derivative) const {
  const int degree = derivative_table.order[derivative];
  if (classes) return classes->share(field, bead, degree);
  return field == 0 ? 1 : 6 * size_factors[degree] * beads.squared_radii[bead];
}

void ParticleMesh::Mesh::spread(std::span<const Vec3> positions, std::span<const double> sources) {
  sort(positions);
  const std::vector<Vec3> places = in_order(order, positions);
  const std::size_t count = derivative_count(beads.moment_order);
  std::vector<double> sorted(3 * count * order.size());
  for (std::size_t f = 0; f < fields; ++f) {
    for (std::size_t s = 0; s < order.size(); ++s)
      for (std::size_t n = 0; n < 3 * count; ++n)
        sorted[3 * count * s + n] = weight_of(f, order[s], n % count) * sources[3 * count * order[s] + n];
    std::array<double*, 3> onto;
    for (int c = 0; c < 3; ++c) {
      onto[c] = values[f][c].get();
      std::fill_n(onto[c], transform->reals(), 0.0);
    }
    best_kernels<MomentKernels>().spread_moments(
        beads.moment_order, geometry, {std::ssize(places), places[0].data()}, sorted.data(), onto.data());
  }
}

void ParticleMesh::Mesh::gather(std::span<const Vec3> positions, std::span<double> flows) {
  const std::size_t count = derivative_count(beads.moment_order);
  std::erase_if(order, [&](int b) { return 3 * count * b >= flows.size(); });
  const std::vector<Vec3> places = in_order(order, positions);
  const double volume = spacing[0] * spacing[1] * spacing[2];
  for (std::size_t f = 0; f < fields; ++f) {
    const std::array<const double*, 3> from{values[f][0].get(), values[f][1].get(), values[f][2].get()};
    std::vector<double> sums(3 * count * places.size(), 0.0);
    best_kernels<MomentKernels>().gather_moments(
        beads.moment_order, geometry, {std::ssize(places), places[0].data()}, from.data(), sums.data());
    for (std::size_t s = 0; s < places.size(); ++s)
      for (std::size_t n = 0; n < 3 * count; ++n)
        flows[3 * count * order[s] + n] +=
            volume * weight_of(f, order[s], n % count) * sums[3 * count * s + n];
  }
}

void ParticleMesh::Mesh::gather_mirrors(int axis, std::span<const Vec3> points,
                                        std::span<MirrorFlow> at_mirrors) {
  sort(points);
  const std::vector<Vec3> places = in_order(order, points);
  std::vector<MirrorFlow> flows(places.size());
  const std::array<const double*, 4> from{values[0][0].get(), values[0][1].get(), values[0][2].get(),
                                          pressure.get()};
  best_kernels<MomentKernels>().gather_mirror_flows(
      beads.moment_order, axis, geometry, {std::ssize(places), places[0].data()}, from.data(), flows.data());
  const double volume = spacing[0] * spacing[1] * spacing[2];
  for (std::size_t s = 0; s < places.size(); ++s) at_mirrors[order[s]].add(volume, flows[s]);
}

void ParticleMesh::Mesh::transform_forces() {
  for (auto& field : values)
    for (FftwArray& component : field) transform->forward(component);
  if (memory) memory->read_forces(values);
}

void ParticleMesh::Mesh::multiply(FlowPart part) {
  if (is_periodic) {
    multiply_periodic();
  } else {
    multiply_open();
  }
  if (memory) memory->add_flow(values, part == FlowPart::all);
  for (auto& field : values)
    for (FftwArray& component : field) transform->backward(component);
}

/// Returns the factors of each field in F and in D.
std::vector<FieldFactors> ParticleMesh::Mesh::field_factors() const {
  if (fields == 1) return {{1, shared_size / 2}};
  if (!classes) return {{1, 0}, {0, 1}};
  std::vector<FieldFactors> factors;
  for (const SourceClass& each : classes->classes())
    factors.push_back({1, 6 * size_factors[each.degree] * each.radius * each.radius});
  return factors;
}

/// Replaces the Fourier modes of the sources in a periodic box by those of their flow.
void ParticleMesh::Mesh::multiply_periodic() {
  const auto& n = geometry.points;
  std::array<double, 3> wave;                // wavenumber per index
  std::array<std::vector<double>, 3> decay;  // factor of the kernel's Gaussian, by the magnitude of the index
  for (int a = 0; a < 3; ++a) {
    wave[a] = 2 * std::numbers::pi / lengths[a];
    const double exponent = (1 - share_of(plan, geometry, a)) * wave[a] * wave[a] / (4 * plan.xi * plan.xi);
    for (int i = 0; i <= n[a] / 2; ++i) decay[a].push_back(std::exp(-exponent * i * i));
  }
  const std::vector<FieldFactors> factors = field_factors();
  std::vector<double> kz, decay_z;
  for (int l = 0; l < geometry.row_length; ++l) {
    kz.push_back(l / 2 * wave[2]);
    decay_z.push_back(decay[2][l / 2]);
  }
  const double scale = 1 / (double(n[0]) * n[1] * n[2]);  // h^3/V: mesh cell over box volume
  std::vector<double*> rows(3 * fields);
  const auto multiply = best_kernels<MobilityKernels>().multiply_waves;
  transform->for_each_row([&](std::ptrdiff_t place, int i, int j) {
    for (std::size_t f = 0; f < fields; ++f)
      for (int c = 0; c < 3; ++c) rows[3 * f + c] = values[f][c].get() + 2 * place;
    multiply({.count = geometry.row_length,
              .kx = i * wave[0],
              .ky = j * wave[1],
              .kz = kz.data(),
              .xi = plan.xi,
              .scale = scale * decay[0][std::abs(i)] * decay[1][std::abs(j)] / beads.viscosity,
              .decay = decay_z.data()},
             static_cast<int>(fields), factors.data(), rows.data());
  });
}

void ParticleMesh::Mesh::multiply_open() {
  for (std::ptrdiff_t place = 0; place < transform->wave_count(); ++place) {
    std::array<Complex, 3> F, D;
    for (int c = 0; c < 3; ++c) {
      F[c] = as_complex(values[0][c])[place];
      if (fields == 2) D[c] = as_complex(values[1][c])[place];
    }
    auto u = times(kernel[0][place], F);
    if (fields == 2) {
      const auto by_size = times(kernel[1][place], D), second = times(kernel[1][place], F);
      for (int c = 0; c < 3; ++c) {
        u[c] += by_size[c];
        as_complex(values[1][c])[place] = second[c];
      }
    }
    for (int c = 0; c < 3; ++c) as_complex(values[0][c])[place] = u[c];
  }
}

void ParticleMesh::add_velocities(std::span<const Vec3> positions, std::span<const Vec3> forces,
                                  FlowPart part, std::span<Vec3> velocities) {
  add_flows(positions, {forces[0].data(), 3 * forces.size()}, part,
            {velocities[0].data(), 3 * velocities.size()});
}

void ParticleMesh::add_flows(std::span<const Vec3> positions, std::span<const double> sources, FlowPart part,
                             std::span<double> flows) {
  Mesh& mesh = *mesh_;
  if (!mesh.is_periodic) mesh.fit_to_beads(positions);
  mesh.spread(positions, sources);
  mesh.transform_forces();
  mesh.multiply(part);
  mesh.gather(positions, flows);
}

void ParticleMesh::add_flows_and_mirrors(const HalfSpace& half_space, std::span<const Vec3> positions,
                                         std::span<const double> sources, std::span<double> flows,
                                         std::span<MirrorFlow> at_mirrors) {
  Mesh& mesh = *mesh_;
  std::vector<Vec3> points(positions.begin(), positions.end());
  for (const Vec3& position : positions) points.push_back(half_space.mirrored(position));
  mesh.fit_to_beads(points);
  mesh.spread(positions, sources);
  mesh.transform_forces();
  mesh.set_pressure();
  mesh.multiply(FlowPart::forces);
  mesh.transform->backward(mesh.pressure);
  mesh.gather(positions, flows);
  mesh.gather_mirrors(half_space.axis, std::span(points).subspan(positions.size()), at_mirrors);
}

void ParticleMesh::read_sources(std::span<const Vec3> positions, std::span<const double> sources) {
  mesh_->spread(positions, sources);
  mesh_->transform_forces();
}

MemoryField* ParticleMesh::memory() const {
  return mesh_->memory.get();
}

}  // namespace beadswim
