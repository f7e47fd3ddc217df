#include "memory_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beadswim/mobility/ewald_plan.hpp"

namespace beadswim {

StepFactors step_factors(double z) {
  if (z < 1e-3)  // series: the differences cancel
    return {std::exp(-z), 1 - z / 2 * (1 - z / 3 * (1 - z / 4)), 0.5 - z / 6 * (1 - z / 4 * (1 - z / 5))};
  const double delay = -std::expm1(-z) / z;
  return {std::exp(-z), delay, (1 - delay) / z};
}

namespace {

/// Returns the form factor P_l of a source of degree l: j_0(x), 3 j_1(x)/x or 15 j_2(x)/x^2.
double form_factor(int degree, double x) {
  if (degree == 0) return std::sph_bessel(0, x);
  return degree == 1 ? 3 * std::sph_bessel(1, x) / x : 15 * std::sph_bessel(2, x) / (x * x);
}

/// Removes from the Fourier mode f with the wavevector k its part along k.
Eigen::Vector3cd transverse(const Vec3& k, const Eigen::Vector3cd& f) {
  return f - k * (k.dot(f) / k.squaredNorm());
}

/// Returns the squared radii of the classes: all that occur, or four Chebyshev points between the smallest
/// and the largest.
std::vector<double> squares_of_classes(std::vector<double> squares) {
  std::ranges::sort(squares);
  squares.erase(std::unique(squares.begin(), squares.end()), squares.end());
  constexpr std::size_t points = max_exact_radii;
  if (squares.size() <= points) return squares;
  const double middle = (squares.back() + squares.front()) / 2, half = (squares.back() - squares.front()) / 2;
  std::vector<double> nodes;
  for (std::size_t n = 0; n < points; ++n)
    nodes.push_back(middle - half * std::cos(std::numbers::pi * static_cast<double>(n) / (points - 1)));
  return nodes;
}

/// Returns the numbers of points of the mesh on which the Reynolds stress is evaluated, in a box with edges
/// of these lengths.
std::array<int, 3> stress_points(const FluidMemory& fluid, const Vec3& lengths) {
  std::array<int, 3> points;
  for (int a = 0; a < 3; ++a) points[a] = next_fft_size(lengths[a] / fluid.spacing);
  return points;
}

}  // namespace

double memory_cutoff(const FluidMemory& fluid, const Vec3& lengths) {
  const std::array<int, 3> points = stress_points(fluid, lengths);
  double cutoff = INFINITY;
  for (int a = 0; a < 3; ++a)
    cutoff = std::min(cutoff, 2 * std::numbers::pi / lengths[a] * (points[a] / 3.0));
  return cutoff * (1 - 1e-12);
}

void MemoryField::set_classes(const ImagedSpheres& spheres) {
  std::vector<double> squared_radii;
  for (const double radius : spheres.radii) squared_radii.push_back(radius * radius);
  const std::vector<double> squares = squares_of_classes(squared_radii);
  radii_ = squares.size();
  for (int degree = 0; degree <= spheres.order; ++degree)
    for (const double square : squares) classes_.push_back({.degree = degree, .radius = std::sqrt(square)});
  for (const double square : squared_radii) {
    for (const double own : squares) {  // polynomials of Lagrange
      double share = 1;
      for (const double other : squares)
        if (other != own) share *= (square - other) / (own - other);
      shares_.push_back(share);
    }
  }
}

MemoryField::MemoryField(const FluidMemory& fluid, const ImagedSpheres& spheres,
                         const std::array<int, 3>& points,
                         const std::array<std::vector<double>, 3>& inverse_windows,
                         const MeshTransform& transform)
    : fluid_(fluid),
      transform_(transform),
      stress_transform_(stress_points(fluid, spheres.lengths), stress_points(fluid, spheres.lengths),
                        transform.communicator(), &transform),
      scale_(1 / (double(points[0]) * points[1] * points[2])),
      cutoff_(memory_cutoff(fluid, spheres.lengths)) {
  set_classes(spheres);
  Vec3 wave;
  for (int a = 0; a < 3; ++a) wave[a] = 2 * std::numbers::pi / spheres.lengths[a];
  const double diffusion = spheres.viscosity / fluid.density * fluid.step;  // nu h
  transform.for_each_wave([&](std::ptrdiff_t place, int i, int j, int l) {
    const Vec3 k(i * wave[0], j * wave[1], l * wave[2]);
    const double k2 = k.squaredNorm();
    if (k2 == 0) has_mean_ = true;
    if (k2 == 0 || k2 > cutoff_ * cutoff_) return;
    for (const SourceClass& each : classes_)
      form_factors_.push_back(form_factor(each.degree, std::sqrt(k2) * each.radius));
    const StepFactors step = step_factors(diffusion * k2);
    const double window =
        inverse_windows[0][std::abs(i)] * inverse_windows[1][std::abs(j)] * inverse_windows[2][l];
    modes_.push_back({.place = place,
                      .on_stress_mesh = stress_transform_.place(i, j, l),
                      .k = k,
                      .window = window,
                      .unit = scale_ * window / (spheres.viscosity * k2),
                      .decay = step.decay,
                      .delay = step.delay,
                      .ramp = step.ramp});
  });
  for (auto* fields : {&steady_, &flow_, &remaining_flow_, &previous_stress_})
    fields->assign(modes_.size(), Velocity::Zero());
}

void MemoryField::read_forces(Values values) {
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    const double* const forms = &form_factors_[m * values.size()];
    Velocity steady;
    for (int c = 0; c < 3; ++c) {
      Complex force = 0;
      for (std::size_t f = 0; f < values.size(); ++f)
        force += forms[f] * as_complex(values[f][c])[mode.place];
      steady[c] = mode.unit * force;
    }
    steady_[m] = transverse(mode.k, steady);
  }
}

void MemoryField::add_flow(Values values, bool with_memory) const {
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    const double* const forms = &form_factors_[m * values.size()];
    for (int c = 0; c < 3; ++c) {
      Complex flow = -mode.delay * steady_[m][c];
      if (with_memory) flow += remaining_flow_[m][c];
      flow *= mode.window;
      for (std::size_t f = 0; f < values.size(); ++f) as_complex(values[f][c])[mode.place] += forms[f] * flow;
    }
  }
}

void MemoryField::start() {
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    remaining_flow_[m] = (modes_[m].delay - modes_[m].decay) * steady_[m];
    previous_stress_[m].setZero();
  }
}

void MemoryField::end_step(const Vec3& mean_flow) {
  mean_flow_ = mean_flow;
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    flow_[m] = remaining_flow_[m] + (1 - mode.delay) * steady_[m];
    remaining_flow_[m] = mode.decay * remaining_flow_[m] + mode.delay * (1 - mode.decay) * steady_[m];
  }
  if (fluid_.has_reynolds_stress) add_reynolds_stress();
}

void MemoryField::set_remainder(std::array<FftwArray, 3>& values) const {
  for (int c = 0; c < 3; ++c) {
    std::fill_n(values[c].get(), transform_.reals(), 0.0);
    for (std::size_t m = 0; m < modes_.size(); ++m)
      as_complex(values[c])[modes_[m].place] = modes_[m].window * (flow_[m][c] - steady_[m][c]);
    if (has_mean_) as_complex(values[c])[0] = mean_flow_[c];
  }
}

void MemoryField::add_reynolds_stress() {
  for (FftwArray& component : velocity_and_curl_) {
    if (!component) component = stress_transform_.array();
    std::fill_n(component.get(), stress_transform_.reals(), 0.0);
  }
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Vec3& k = modes_[m].k;
    const Velocity& flow = flow_[m];
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      as_complex(velocity_and_curl_[c])[modes_[m].on_stress_mesh] = flow[c];
      as_complex(velocity_and_curl_[3 + c])[modes_[m].on_stress_mesh] =
          Complex(0, 1) * (k[d] * flow[e] - k[e] * flow[d]);
    }
  }
  if (has_mean_)
    for (int c = 0; c < 3; ++c) as_complex(velocity_and_curl_[c])[0] = mean_flow_[c];
  for (const FftwArray& component : velocity_and_curl_) stress_transform_.backward(component);
  for (std::ptrdiff_t p = 0; p < stress_transform_.reals(); ++p) {
    const Vec3 u(velocity_and_curl_[0][p], velocity_and_curl_[1][p], velocity_and_curl_[2][p]),
        curl(velocity_and_curl_[3][p], velocity_and_curl_[4][p], velocity_and_curl_[5][p]);
    const Vec3 force = -fluid_.density * curl.cross(u);
    for (int c = 0; c < 3; ++c) velocity_and_curl_[c][p] = force[c];
  }
  for (int c = 0; c < 3; ++c) stress_transform_.forward(velocity_and_curl_[c]);
  const auto& points = stress_transform_.points();
  const double scale = 1 / (double(points[0]) * points[1] * points[2]);
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    Velocity stress;
    for (int c = 0; c < 3; ++c) stress[c] = scale * as_complex(velocity_and_curl_[c])[mode.on_stress_mesh];
    stress = transverse(mode.k, stress);
    remaining_flow_[m] +=
        fluid_.step / fluid_.density * (mode.delay * stress + mode.ramp * (stress - previous_stress_[m]));
    previous_stress_[m] = stress;
  }
}

std::vector<double> MemoryField::state() const {
  std::vector<double> state;
  state.reserve(12 * modes_.size());
  for (std::size_t m = 0; m < modes_.size(); ++m)
    for (const auto* field : {&remaining_flow_, &previous_stress_})
      for (int c = 0; c < 3; ++c) state.insert(state.end(), {(*field)[m][c].real(), (*field)[m][c].imag()});
  return state;
}

void MemoryField::restore(std::span<const double> state) {
  std::size_t next = 0;
  for (std::size_t m = 0; m < modes_.size(); ++m)
    for (auto* field : {&remaining_flow_, &previous_stress_})
      for (int c = 0; c < 3; ++c, next += 2) (*field)[m][c] = {state[next], state[next + 1]};
}

}  // namespace beadswim
