#include <fmt/format.h>

#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// A sphere of the fluid's density falls through a periodic cube under a constant force, which a uniform body
// force on the fluid balances.

namespace beadswim::verification {
namespace {

constexpr double pi = std::numbers::pi;

struct Fall {
  double phi = 0.027;
  int cells_per_diameter = 8;
  std::string along = "x";
  double speed = 1e-3;  ///< expected [cell/step]
  double cells = 6;     ///< to fall while it is measured, a whole number along x
};

Vec3 direction_of(const Fall& fall) {
  return fall.along == "x" ? Vec3::UnitX() : Vec3(1, 0.6180, 0.3820).normalized();
}

struct Motion {
  double velocity;         ///< mean, along the force, relative to the mean flow
  double rms, peak;        ///< of what is over and above the mean, over it
  double sideways;         ///< mean velocity across the force, over that along
  double force_rms;        ///< of the fluid's force in the mean of two steps, over its mean
  double momentum_defect;  ///< of everything, over the sphere's
};

/// A sphere pulled by `force` for as long as it is asked to.
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
  /// Counted over all cells: of fluid, sphere, and what is under way between them.
  Vec3 momentum() const {
    return fluid_.counted_fluid().momentum + mass_ * fluid_.motion(0).velocity + 0.5 * last_.force;
  }

  Vec3 force_;
  double mass_, inertia_;
  SpheresInFluid fluid_;
  Load last_, mean_load_;
  Vec3 relative_velocity_ = Vec3::Zero(), momentum_at_start_ = Vec3::Zero();
};

/// Velocity of the array over force, 1/(6 pi eta R K). The force is that with the share of the mean
/// pressure gradient, the pull over 1 - phi.
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

std::string table(const std::vector<Json>& records) {
  std::string text = table_head("scheme, cells a diameter, along, speed",
                                {"velocity", "its rms", "its peak", "sideways", "rms of force"});
  for (const Json& r : records) {
    text +=
        fmt::format("| {}, {}, {}, {:g} | {} | {} | {} | {} | {} |\n", r["scheme"].get<std::string>(),
                    r["cells_per_diameter"].get<int>(), r["along"].get<std::string>(),
                    r["speed"].get<double>(), percent(r["error"]), plain_percent(r["spread"]),
                    plain_percent(r["peak"]), plain_percent(r["sideways"]), plain_percent(r["force_rms"]));
  }
  return text;
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

std::string report_sedimentation(const std::vector<Json>& records) {
  double defect = 0, reynolds = 0;
  for (const Json& r : records) {
    defect = std::max(defect, r["momentum_defect"].get<double>());
    reynolds = std::max(reynolds, r["reynolds"].get<double>());
  }
  return "## A sphere falling through the lattice\n\n"
         "A sphere of the fluid's density in a periodic cube, φ = 0.027, pulled by a constant force that a "
         "uniform "
         "body force on the fluid balances; it crosses 6 cells along x, or along (1, 0.618, 0.382), after 10 "
         "times the longer of the relaxation times of its velocity and of the flow in the box. Velocity "
         "relative to "
         "the mean flow: error of the mean, rms and greatest deviation from the mean on the way, mean "
         "velocity "
         "across the force; rms of the fluid's force on it (mean of two steps). τ = 1.5.\n\n"
         "Reference: the drag of the cubic array (above; Hasimoto 1959), pull/(1 - φ) = 6πηRKU. No inertia "
         "in "
         "it: the Reynolds number 2RU/ν is " +
         fmt::format(
             "at most {:.2g}. Total momentum, counted over all cells, is that of the start to {:.0e} of the "
             "sphere's.\n\n",
             reynolds, defect) +
         table(records);
}

}  // namespace beadswim::verification
