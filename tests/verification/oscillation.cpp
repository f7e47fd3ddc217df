#include <fmt/core.h>

#include "beadswim/collinear/line_flow.hpp"
#include "beadswim/collinear/unsteady_sphere.hpp"
#include "beadswim/core/complex.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "references.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Measures the force on a sphere that oscillates as exp(i omega t) along x in a periodic cube of fluid
// (unsteady Stokes flow).

namespace beadswim::verification {
namespace {

constexpr double box_in_radii = 8;

struct Oscillation {
  int radius = 4;  ///< [cell]
  int period = 0;  ///< [step]
  double tau = 1.5;

  double omega() const { return 2 * pi / period; }
  double viscosity() const { return lattice_viscosity(tau); }
  int edge() const { return static_cast<int>(box_in_radii * radius); }
  /// Returns R sqrt(omega/(2 nu)): the radius divided by the penetration depth of the oscillating flow.
  double layers() const { return radius * std::sqrt(omega() / (2 * viscosity())); }
};

/// Returns the oscillation with the even period for which R sqrt(omega/(2 nu)) is closest to `layers`.
Oscillation oscillation(int radius, double layers, double tau) {
  const double omega = 2 * lattice_viscosity(tau) * layers * layers / (radius * radius);
  return {radius, 2 * static_cast<int>(std::lround(pi / omega)), tau};
}

/// Returns the exact friction f/(U - U_mean) in the box. f: force that the sphere induces in the fluid, if
/// fluid is assumed to fill also the sphere; U_mean: mean velocity of all this fluid. The friction follows
/// from the mobility of a single sphere and the flow of its images, without the uniform part U_mean
/// (docs/method/unsteady-stokes.md).
Complex friction_in_box(const Oscillation& of) {
  const double eta = of.viscosity(), edge = of.edge();
  const Complex alpha = std::sqrt(Complex(0, of.omega() / of.viscosity())), kappa = alpha * double(of.radius);
  const SizeFactor size = sphere_factor(kappa);
  const LineFlow flow(eta, {.lengths = {edge, edge, edge}}, 0, 0);
  const Complex images = total_flow(flow.unsteady_images(alpha, 0), size * size).value;
  const Complex uniform = 1.0 / (eta * alpha * alpha * std::pow(edge, 3));
  return 1.0 / (1.0 / (6 * pi * eta * of.radius * induced_force_factor(kappa)) + images - uniform);
}

/// Amplitude of exp(i omega t) in a signal, summed over whole periods.
class Amplitude {
 public:
  Amplitude(double omega, int steps) : omega_(omega), steps_(steps) {}
  void add(double time, double value) { sum_ += 2.0 / steps_ * value * std::polar(1.0, -omega_ * time); }
  Complex value() const { return sum_; }

 private:
  double omega_;
  int steps_;
  Complex sum_ = 0;
};

/// Returns the measured friction f/(U - U_mean). The sphere stays at its position, which is exact to first
/// order in the amplitude.
Complex friction(const Oscillation& of, const Vec3& offset, BeadScheme scheme) {
  constexpr double speed = 1e-6;
  const Index3 cells = Index3::Constant(of.edge());
  SpheresInFluid fluid(cells, of.tau, scheme,
                       {{double(of.radius), Vec3::Constant(of.edge() / 2.0) + offset}});
  const int transient = static_cast<int>(10 * diffusion_time(cells, of.tau)) + 400;
  const int periods = 1 + 1000 / of.period, steps = periods * of.period;
  Amplitude velocity(of.omega(), steps), force(of.omega(), steps), gravity(of.omega(), steps),
      momentum(of.omega(), steps);
  for (int n = -transient; n < steps; ++n) {
    // Links reflect in the middle of the step, n + 1/2; the body force acts at its end.
    const double middle = n + 0.5, end = n + 1;
    fluid.motion(0).velocity = Vec3(speed * std::cos(of.omega() * middle), 0, 0);
    fluid.hold_fluid_momentum(Vec3::Zero());
    const double handed_over = fluid.step()[0].force[0];
    if (n < 0) continue;
    velocity.add(middle, fluid.motion(0).velocity[0]);
    force.add(middle, handed_over);
    gravity.add(end, fluid.body_force[0]);
    momentum.add(end, fluid.mid_step_momentum()[0]);
  }
  const double volume = 4 * pi / 3 * std::pow(of.radius, 3);
  const Complex u = velocity.value();
  // Newton for the fluid thought to fill the sphere: i omega m U = link force + body force + induced force,
  // which is -f on the sphere's side.
  const Complex induced = Complex(0, of.omega()) * volume * u - force.value() - gravity.value() * volume;
  const Complex mean_flow = (momentum.value() + volume * u) / fluid.volume();
  return induced / (u - mean_flow);
}

void measure(const Oscillation& of, int places, BeadScheme scheme, const Emit& emit) {
  const Complex reference = friction_in_box(of);
  const double stokes = 6 * pi * of.viscosity() * of.radius;
  std::vector<double> amplitudes, phases;
  for (const Vec3& place : random_places(places)) {
    const Complex ratio = friction(of, place, scheme) / reference;
    amplitudes.push_back(std::abs(ratio));
    phases.push_back(std::arg(ratio));
  }
  const auto [amplitude, deviation] = mean_and_deviation(amplitudes);
  const auto [phase, phase_deviation] = mean_and_deviation(phases);
  emit({{"case", "oscillation"},
        {"scheme", to_text(scheme)},
        {"tau", of.tau},
        {"layers", of.layers()},
        {"period", of.period},
        {"cells_per_diameter", 2 * of.radius},
        {"diameter", 2 * of.radius},
        {"edge", of.edge()},
        {"places", places},
        {"measured", amplitude * std::abs(reference) / stokes},
        {"reference", std::abs(reference) / stokes},
        {"reference_phase", std::arg(reference)},
        {"error", amplitude - 1},
        {"spread", deviation},
        {"phase_error", phase},
        {"phase_spread", phase_deviation}});
}

/// Returns the delay of the force [step] as text.
std::string delay(const Json& record) {
  const double steps_per_radian = record["period"].get<double>() / (2 * pi);
  return fmt::format("{:.2f}", -record["phase_error"].get<double>() * steps_per_radian);
}

}  // namespace

void measure_oscillation(BeadScheme scheme, Extent extent, const Emit& emit) {
  if (extent == Extent::brief) return measure(oscillation(3, 0.5, 1.5), 1, scheme, emit);
  for (const double layers : {0.1, 0.2, 0.5, 1.0}) measure(oscillation(4, layers, 1.5), 4, scheme, emit);
  for (const int radius : {2, 3, 6, 8})
    measure(oscillation(radius, 0.5, 1.5), radius <= 3 ? 4 : 2, scheme, emit);
  for (const double tau : {0.8, 3.0}) measure(oscillation(4, 0.5, tau), 4, scheme, emit);
  for (const double tau : {1.5, 3.0, 6.0}) measure(oscillation(3, 0.2, tau), 2, scheme, emit);
}

Law oscillation_law() {
  Law law{
      .title = "Oscillating sphere",
      .claim =
          "Amplitude and lag of the friction Z = f/(U - U_mean) of a sphere with velocity U cos ωt in a "
          "periodic cube of edge 8 R; R√(ω/2ν) = 0.5 unless stated",
      .reference =
          "Basset's friction with [images](method/unsteady-stokes.md); "
          "[lag](method/force-delay.md) of 1.5 (τ - 1/2) steps",
      .test = "6 cells per diameter",
  };
  const auto add_row = [&](const std::string& conditions, const Oscillation& of, Print print) {
    law.rows.push_back(
        {conditions, {{"cells_per_diameter", 2 * of.radius}, {"period", of.period}, {"tau", of.tau}}, print});
  };
  for (const int radius : {2, 3, 4, 6, 8}) {
    add_row(fmt::format("{} cells", 2 * radius), oscillation(radius, 0.5, 1.5), error_and_spread);
  }
  add_row("R√(ω/2ν) = 1, 8 cells", oscillation(4, 1, 1.5), error_and_spread);
  for (const double tau : {1.5, 3.0, 6.0}) {
    add_row(fmt::format("lag [step], τ = {:g}; expected {:g}", tau, 1.5 * (tau - 0.5)),
            oscillation(3, 0.2, tau), delay);
  }
  return law;
}

}  // namespace beadswim::verification
