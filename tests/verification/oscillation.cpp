#include <fmt/format.h>

#include <complex>

#include "beadswim/mobility/line_flow.hpp"
#include "beadswim/mobility/unsteady_sphere.hpp"
#include "cases.hpp"
#include "places.hpp"
#include "records.hpp"
#include "settling.hpp"
#include "spheres_in_fluid.hpp"

// Force on a sphere that oscillates along x in a periodic cube of unsteady Stokes flow, as exp(i omega t).

namespace beadswim::verification {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr double box_in_radii = 8;

struct Oscillation {
  int radius = 4;  ///< [cell]
  int period = 0;  ///< [step]
  double tau = 1.5;

  double omega() const { return 2 * pi / period; }
  double viscosity() const { return lattice_viscosity(tau); }
  int edge() const { return static_cast<int>(box_in_radii * radius); }
  /// R sqrt(omega/(2 nu)): radius over the thickness of the layer that vorticity reaches.
  double layers() const { return radius * std::sqrt(omega() / (2 * viscosity())); }
};

/// The even period that comes nearest to R sqrt(omega/(2 nu)) = layers.
Oscillation oscillation(int radius, double layers, double tau) {
  const double omega = 2 * lattice_viscosity(tau) * layers * layers / (radius * radius);
  return {radius, 2 * static_cast<int>(std::lround(pi / omega)), tau};
}

/// Friction f/(U - U_mean): f the force that a sphere induces in the fluid, the one thought to fill it
/// included, U_mean the mean velocity of all this fluid. The lone sphere's, and its images' flow without the
/// uniform part, which is U_mean (docs/method/unsteady-stokes.md).
Complex friction_in_box(const Oscillation& of) {
  const double eta = of.viscosity(), edge = of.edge();
  const Complex alpha = std::sqrt(Complex(0, of.omega() / of.viscosity())), kappa = alpha * double(of.radius);
  const SizeFactor size = sphere_factor(kappa);
  const LineFlow flow(eta, {.lengths = {edge, edge, edge}}, 0, 0);
  const Complex images = total_flow(flow.unsteady_images(alpha, 0), size * size).value;
  const Complex uniform = 1.0 / (eta * alpha * alpha * std::pow(edge, 3));
  return 1.0 / (1.0 / (6 * pi * eta * of.radius * induced_force_factor(kappa)) + images - uniform);
}

/// Amplitude of exp(i omega t) in a signal, added up over whole periods.
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

/// The same friction, measured: places are held, as to first order in the amplitude.
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

double degrees(const Json& radians) {
  return radians.get<double>() * 180 / pi;
}

std::string table(const std::vector<Json>& records) {
  std::string text = table_head(
      "R√(ω/2ν), period, cells a diameter, τ",
      {"\\|Z\\|/6πηR, phase", "scheme", "amplitude", "phase", "as a delay [step]", "1.5 (τ - 1/2)"});
  for (const Json& r : records) {
    text += fmt::format(
        "| {:.3f}, {}, {}, {:g} | {:.3f}, {:.2f}° | {} | {} | {:+.3f} ± {:.3f}° | {:.2f} | {:.2f} |\n",
        r["layers"].get<double>(), r["period"].get<int>(), r["cells_per_diameter"].get<int>(),
        r["tau"].get<double>(), r["reference"].get<double>(), degrees(r["reference_phase"]),
        r["scheme"].get<std::string>(), error_and_spread(r), degrees(r["phase_error"]),
        degrees(r["phase_spread"]), -r["phase_error"].get<double>() * r["period"].get<double>() / (2 * pi),
        1.5 * (r["tau"].get<double>() - 0.5));
  }
  return text;
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

std::string report_oscillation(const std::vector<Json>& records) {
  return "## An oscillating sphere\n\n"
         "A sphere oscillates along x in a periodic cube of 8 R, to first order: it is held in place and its "
         "surface given the velocity U cos ωt. From the force at its links, f = iωm_f U - F_links - g m_f is "
         "what "
         "it induces in a fluid thought to fill it as well (m_f the mass of that, g the body force that "
         "keeps the box "
         "from drifting), and Z = f/(U - U_mean) its friction at no mean flow, complex. Given are the errors "
         "of "
         "amplitude and phase of Z.\n\n"
         "Reference: Basset's friction of a lone sphere, 6πηR(1 + κ + κ²/3), κ = (1 + i) R√(ω/2ν), and the "
         "flow of its "
         "periodic images with the sphere's finite size (docs/method/unsteady-stokes.md), incompressible. "
         "Reflections "
         "of higher order, in the steady limit 27 (R/L)⁶ = 1e-4, are left out. Velocity and force are both "
         "taken at "
         "the middle of the step, where links reflect.\n\n"
         "The force lags behind that of an incompressible Newtonian fluid, by a time that tends to 1.5 (τ - "
         "1/2) steps "
         "at low frequency. This is the fluid's doing, not the beads': ν/c_s² = τ - 1/2 "
         "steps is the time in which the stress of a lattice-Boltzmann fluid follows the rate of strain, "
         "η(ω) = η (1 - "
         "iων/c_s²), and the finite speed of sound adds half as much, as a sphere's friction in a "
         "compressible fluid is "
         "6πηR/(1 + iων/(2c_s²)) at low frequency. What differs from it, with links up to 0.8 steps earlier "
         "and with "
         "psm up to 0.5 later, is of the order of 1/(4 (τ - 1/2)), in which schemes differ. The phase "
         "error falls with the square of the resolution at given τ and "
         "R√(ω/2ν), as "
         "the period grows; at a period of 2000 steps and τ = 1.5 it is 0.27°.\n\n"
         "In a coupled run a bead's velocity at the step's start is used at the links, and the mean of two "
         "steps' "
         "forces moves it: together a delay of one more step, which this case does not contain.\n\n" +
         table(records);
}

}  // namespace beadswim::verification
