#include "beadswim/theory/reynolds_stress.hpp"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <type_traits>
#include <vector>

#include "beadswim/collinear/unsteady_sphere.hpp"
#include "beadswim/core/box.hpp"
#include "beadswim/core/complex.hpp"
#include "beadswim/theory/box_mobility.hpp"

namespace beadswim {

namespace {

/// Positions of the beads and of their mirror images, which have the bead number s % 3, and the directions of
/// the forces on them. Along periodic axes, the middle bead is at 0, so that the mesh moves with the swimmer.
struct Sources {
  std::vector<Vec3> positions, directions;
};

Sources sources(const CollinearSwimmer& swimmer, const BoxPlace& place) {
  Vec3 origin = Vec3::Zero();
  for (int axis = 0; axis < 3; ++axis)
    if (!place.box.has_mirrors(axis)) origin[axis] = place.middle_bead[axis];
  Sources all;
  for (const double x : rest_positions(swimmer, place)) {
    all.positions.emplace_back(Vec3(x, place.middle_bead[1], place.middle_bead[2]) - origin);
    all.directions.emplace_back(Vec3::UnitX());
  }
  for (auto* vectors : {&all.positions, &all.directions}) add_mirror_images(place.box, *vectors);
  return all;
}

/// Mesh of a periodic box with the Fourier transform of fields on it.
class Mesh {
 public:
  using Field = std::vector<Complex>;

  Mesh(const Vec3& lengths, const std::array<int, 3>& points) : points_(points) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int n = 0; n < points[axis]; ++n) {
        const int wave = n <= points[axis] / 2 ? n : n - points[axis];
        waves_[axis].push_back(2 * std::numbers::pi * wave / lengths[axis]);
      }
    }
  }

  std::size_t size() const { return waves_[0].size() * waves_[1].size() * waves_[2].size(); }

  /// Calls visit(index, wave vector) for all waves except the mean of the field and the shortest waves along
  /// each axis, which have no opposite wave on the mesh.
  void for_each_wave(auto&& visit) const {
    for (int x = 0; x < points_[0]; ++x) {
      for (int y = 0; y < points_[1]; ++y) {
        for (int z = 0; z < points_[2]; ++z) {
          const bool is_mean = x == 0 && y == 0 && z == 0;
          if (is_mean || 2 * x == points_[0] || 2 * y == points_[1] || 2 * z == points_[2]) continue;
          const std::size_t index = (static_cast<std::size_t>(x) * points_[1] + y) * points_[2] + z;
          visit(index, Vec3(waves_[0][x], waves_[1][y], waves_[2][z]));
        }
      }
    }
  }

  void to_space(Field& field) const { transform(field, FFTW_BACKWARD); }
  void to_waves(Field& field) const {
    transform(field, FFTW_FORWARD);
    for (Complex& value : field) value /= static_cast<double>(size());
  }

 private:
  struct PlanFree {
    void operator()(fftw_plan plan) const { fftw_destroy_plan(plan); }
  };

  void transform(Field& field, int direction) const {
    auto* data = reinterpret_cast<fftw_complex*>(field.data());
    const std::unique_ptr<std::remove_pointer_t<fftw_plan>, PlanFree> plan(
        fftw_plan_dft_3d(points_[0], points_[1], points_[2], data, data, direction, FFTW_ESTIMATE));
    fftw_execute(plan.get());
  }

  std::array<int, 3> points_;
  std::array<std::vector<double>, 3> waves_;  ///< wavenumbers along each axis [1/length]
};

std::optional<Mesh> mesh_for(const CollinearSwimmer& swimmer, const Box& box) {
  constexpr double max_points = 1 << 19;
  const double spacing = *std::ranges::min_element(swimmer.radius);
  std::array<int, 3> points{};
  double count = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double pairs = std::ceil(box.lengths[axis] / (2 * spacing)) * (box.has_mirrors(axis) ? 2 : 1);
    count *= 2 * pairs;
    if (count > max_points) return std::nullopt;
    points[axis] = 2 * static_cast<int>(pairs);
  }
  return Mesh(mirrored_lengths(box), points);
}

/// Spherical Bessel functions j_0(x) and j_1(x)/x.
struct Bessel {
  explicit Bessel(double x)
      : of_order_0(std::sin(x) / x), first_over_x((of_order_0 - std::cos(x)) / (x * x)) {}
  double of_order_0, first_over_x;
};

Complex induced_force_in_waves(double wave_times_radius, Complex kappa) {
  const Bessel j(wave_times_radius);
  return ((1.0 + kappa) * j.of_order_0 + kappa * kappa * j.first_over_x) / induced_force_factor(kappa);
}

/// Returns the first-order flow at the points of the mesh, one field per component.
std::array<Mesh::Field, 3> flow_on(const Mesh& mesh, const CollinearSwimmer& swimmer, Complex alpha,
                                   const Sources& all, const Eigen::Vector3cd& force, double volume) {
  std::array<Mesh::Field, 3> flow;
  for (Mesh::Field& component : flow) component.resize(mesh.size());
  mesh.for_each_wave([&](std::size_t index, const Vec3& k) {
    const double k2 = k.squaredNorm(), wave = std::sqrt(k2);
    std::array<Complex, 3> strength;
    for (int i = 0; i < 3; ++i)
      strength[i] = force[i] * induced_force_in_waves(wave * swimmer.radius[i], alpha * swimmer.radius[i]);
    Complex sum = 0;
    for (std::size_t s = 0; s < all.positions.size(); ++s)
      sum += all.directions[s].x() * strength[s % 3] * std::polar(1.0, -k.dot(all.positions[s]));
    const Complex u = sum / (swimmer.viscosity * volume * (k2 + alpha * alpha));
    for (int axis = 0; axis < 3; ++axis) flow[axis][index] = u * ((axis == 0 ? 1 : 0) - k[0] * k[axis] / k2);
  });
  for (Mesh::Field& component : flow) mesh.to_space(component);
  return flow;
}

}  // namespace

std::optional<Eigen::Vector3d> reynolds_velocities_in_box(const CollinearSwimmer& swimmer,
                                                          double fluid_density, const BoxPlace& place,
                                                          const Eigen::Vector3cd& force) {
  const std::optional<Mesh> mesh = mesh_for(swimmer, place.box);
  if (!mesh) return std::nullopt;
  const Complex alpha = inverse_penetration_depth(swimmer, fluid_density);
  const Sources all = sources(swimmer, place);
  const std::array<Mesh::Field, 3> flow =
      flow_on(*mesh, swimmer, alpha, all, force, mirrored_lengths(place.box).prod());

  std::array<Mesh::Field, 3> mean_force;  // in waves
  for (Mesh::Field& component : mean_force) component.resize(mesh->size());
  Mesh::Field stress(mesh->size());
  for (int a = 0; a < 3; ++a) {
    for (int b = a; b < 3; ++b) {
      for (std::size_t n = 0; n < stress.size(); ++n)
        stress[n] = fluid_density / 2 * (flow[a][n] * std::conj(flow[b][n])).real();
      mesh->to_waves(stress);
      mesh->for_each_wave([&](std::size_t index, const Vec3& k) {
        mean_force[a][index] -= i_unit * k[b] * stress[index];
        if (b != a) mean_force[b][index] -= i_unit * k[a] * stress[index];
      });
    }
  }

  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  mesh->for_each_wave([&](std::size_t index, const Vec3& k) {
    const double k2 = k.squaredNorm(), wave = std::sqrt(k2);
    const Complex along =
        k[0] * mean_force[0][index] + k[1] * mean_force[1][index] + k[2] * mean_force[2][index];
    const Complex flow_x = (mean_force[0][index] - k[0] * along / k2) / (swimmer.viscosity * k2);
    for (int j = 0; j < 3; ++j) {
      const Complex at_bead = flow_x * std::polar(1.0, k.dot(all.positions[j]));
      velocity[j] += at_bead.real() * Bessel(wave * swimmer.radius[j]).of_order_0;
    }
  });
  return velocity;
}

}  // namespace beadswim
