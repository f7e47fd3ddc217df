#include <fmt/core.h>

#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the motion of a sphere with the density of the fluid that falls through a periodic cube under a
// constant force. A uniform body force on the fluid balances this force.

namespace beadswim::verification {
namespace {

struct Fall {
  double phi = 0.027;
  int cells_per_diameter = 8;
  std::string along = "x";
  double speed = 1e-3;  ///< expected velocity [cell/step]
  double cells = 6;     ///< distance of the measurement, a whole number along x [cell]
};

Vec3 direction_of(const Fall& fall) {
  return fall.along == "x" ? Vec3::UnitX() : Vec3(1, 0.6180, 0.3820).normalized();
}

struct Motion {
  double velocity;         ///< mean velocity along the force, relative to the mean flow
  double rms, peak;        ///< deviations from the mean velocity, divided by it
  double sideways;         ///< mean velocity perpendicular to the force / mean velocity
  double force_rms;        ///< force of the fluid, mean of two steps, divided by its mean
  double momentum_defect;  ///< change of total momentum / momentum of the sphere
};

/// Sphere that a constant force pulls through the fluid.
class FallingSphere {
 public:
  FallingSphere(const CubicArray& array, double tau, BeadScheme scheme, const Vec3& force,
                const Vec3& velocity)
      : force_(force),
        mass_(4 * pi / 3 * std::pow(array.radius, 3)),
        inertia_(0.4 * mass_ * array.radius * array.radius),
        fluid_(Index3::Constant(array.edge), tau, scheme,
               {{array.radius, Vec3::Constant(array.edge / 2.0) + Vec3(0.2, 0.3, 0.1)}}) {
    fluid_.start_fluid(-mass_ / fluid_.fluid_cells() * velocity);
    motion().velocity = velocity;
    momentum_at_start_ = momentum();
  }

  void step() {
    fluid_.body_force = -force_ / fluid_.fluid_cells();
    const Load now = fluid_.step()[0];
    mean_load_ = {0.5 * (now.force + last_.force), 0.5 * (now.torque + last_.torque)};
    last_ = now;
    // Relative to the mean flow in the middle of the step.
    relative_velocity_ =
        motion().velocity - (fluid_.mid_step_momentum() + mass_ * motion().velocity) / fluid_.volume();
    motion().velocity += (force_ + mean_load_.force) / mass_;
    motion().angular_velocity += mean_load_.torque / inertia_;
    fluid_.move();
  }

  BeadMotion& motion() { return fluid_.motion(0); }
  const Vec3& relative_velocity() const { return relative_velocity_; }
  const Load& mean_load() const { return mean_load_; }
  double momentum_defect() const {
    return (momentum() - momentum_at_start_).norm() / (mass_ * fluid_.motion(0).velocity.norm());
  }

 private:
  /// Returns the total momentum, summed over all cells: fluid, sphere, and momentum that is being transferred
  /// between them.
  Vec3 momentum() const {
    return fluid_.counted_fluid().momentum + mass_ * fluid_.motion(0).velocity + 0.5 * last_.force;
  }

  Vec3 force_;
  double mass_, inertia_;
  SpheresInFluid fluid_;
  Load last_, mean_load_;
  Vec3 relative_velocity_ = Vec3::Zero(), momentum_at_start_ = Vec3::Zero();
};

/// Returns the velocity of the array divided by the force: 1/(6 pi eta R K). This force includes the share of
/// the mean pressure gradient; it is the pulling force divided by 1 - phi.
double array_mobility(const CubicArray& array, double tau) {
  return 1 / (6 * pi * lattice_viscosity(tau) * array.radius * cubic_array_drag(array.phi) * (1 - array.phi));
}

Motion fall(const Fall& fall, double tau, BeadScheme scheme) {
  const CubicArray array = cubic_array(fall.phi, fall.cells_per_diameter);
  const Vec3 along = direction_of(fall);
  FallingSphere sphere(array, tau, scheme, fall.speed / array_mobility(array, tau) * along,
                       fall.speed * along);
  const double friction_time = array_mobility(array, tau) * std::pow(array.edge, 3);
  const int until_steady =
      static_cast<int>(10 * std::max(friction_time, diffusion_time(Index3::Constant(array.edge), tau)));
  for (int n = 0; n < until_steady; ++n) sphere.step();

  const Vec3 start = sphere.motion().position;
  std::vector<double> velocities, forces, sideways;
  while ((sphere.motion().position - start).norm() < fall.cells) {
    sphere.step();
    const Vec3& v = sphere.relative_velocity();
    velocities.push_back(v.dot(along));
    sideways.push_back((v - v.dot(along) * along).norm());
    forces.push_back(sphere.mean_load().force.dot(along));
  }
  const auto [mean, deviation] = mean_and_deviation(velocities);
  double peak = 0;
  for (const double v : velocities) peak = std::max(peak, std::abs(v - mean));
  const auto [mean_force, force_deviation] = mean_and_deviation(forces);
  return {.velocity = mean,
          .rms = deviation / mean,
          .peak = peak / mean,
          .sideways = mean_and_deviation(sideways).mean / mean,
          .force_rms = force_deviation / std::abs(mean_force),
          .momentum_defect = sphere.momentum_defect()};
}

void measure(const Fall& of, double tau, BeadScheme scheme, const Emit& emit) {
  const CubicArray array = cubic_array(of.phi, of.cells_per_diameter);
  const Motion m = fall(of, tau, scheme);
  emit({{"case", "sedimentation"},
        {"scheme", to_text(scheme)},
        {"tau", tau},
        {"phi", of.phi},
        {"cells_per_diameter", of.cells_per_diameter},
        {"diameter", 2 * array.radius},
        {"edge", array.edge},
        {"along", of.along},
        {"speed", of.speed},
        {"reynolds", of.speed * 2 * array.radius / lattice_viscosity(tau)},
        {"measured", m.velocity},
        {"reference", of.speed},
        {"error", m.velocity / of.speed - 1},
        {"spread", m.rms},
        {"peak", m.peak},
        {"sideways", m.sideways},
        {"force_rms", m.force_rms},
        {"momentum_defect", m.momentum_defect}});
}

std::string sideways(const Json& record) {
  return fmt::format("{:.2f}", 100 * record["sideways"].get<double>());
}

}  // namespace

void measure_sedimentation(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) return measure({.cells_per_diameter = 6, .cells = 2}, 1.5, scheme, emit);
  for (const std::string along : {"x", "oblique"}) {
    for (const int cells : {6, 8, 12, 16})
      measure({.cells_per_diameter = cells, .along = along}, 1.5, scheme, emit);
  }
  for (const double speed : {2.5e-4, 4e-3, 1.6e-2})
    measure({.along = "oblique", .speed = speed}, 1.5, scheme, emit);
}

Law sedimentation_law() {
  Law law{
      .title = "Sphere moving through the lattice",
      .claim =
          "Velocity relative to the mean flow under a constant force along (1, 0.618, 0.382), mean ± "
          "rms over time; φ = 0.027",
      .reference = "drag of the array: 6πηRKU = force/(1 - φ)",
      .test = "along x, 6 cells per diameter",
  };
  const auto add_row = [&](const std::string& conditions, int cells, double speed, Print print) {
    law.rows.push_back(
        {conditions, {{"along", "oblique"}, {"cells_per_diameter", cells}, {"speed", speed}}, print});
  };
  for (const int cells : {6, 8, 12, 16})
    add_row(fmt::format("{} cells", cells), cells, 1e-3, error_and_spread);
  add_row("8 cells, 0.016 cells per step", 8, 1.6e-2, error_and_spread);
  add_row("8 cells, velocity across the force", 8, 1e-3, sideways);
  return law;
}

}  // namespace beadswim::verification
