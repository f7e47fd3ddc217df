#include "memory_field.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

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

}  // namespace

MemoryField::MemoryField(const Law& law, const MeshTransform& transform) : law_(law), transform_(transform) {
  const auto& n = law.points;
  Vec3 wave;
  cutoff_ = INFINITY;
  for (int a = 0; a < 3; ++a) {
    wave[a] = 2 * std::numbers::pi / law.lengths[a];
    cutoff_ = std::min(cutoff_, wave[a] * (n[a] / 3.0) * (1 - 1e-12));
  }
  const double scale = 1 / (double(n[0]) * n[1] * n[2]);
  const double diffusion = law.viscosity / law.fluid.density * law.fluid.step;  // nu h
  transform.for_each_wave([&](std::ptrdiff_t place, int i, int j, int l) {
    const Vec3 k(i * wave[0], j * wave[1], l * wave[2]);
    const double k2 = k.squaredNorm();
    if (k2 == 0) has_mean_ = true;
    if (k2 == 0 || k2 > cutoff_ * cutoff_) return;
    for (const SourceClass& each : law.classes)
      form_factors_.push_back(form_factor(each.degree, std::sqrt(k2) * each.radius));
    const StepFactors step = step_factors(diffusion * k2);
    double exponent = 0;
    for (int a = 0; a < 3; ++a) exponent += law.exponent[a] * k[a] * k[a];
    const double window = std::exp(exponent);
    modes_.push_back({.place = place,
                      .k = k,
                      .window = window,
                      .unit = scale * window / (law.viscosity * k2),
                      .decay = step.decay,
                      .delay = step.delay,
                      .ramp = step.ramp});
  });
  for (auto* fields : {&steady_, &remaining_flow_, &previous_stress_})
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
  std::vector<Velocity> flow;
  if (law_.fluid.has_reynolds_stress) flow.resize(modes_.size());
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    if (!flow.empty()) flow[m] = remaining_flow_[m] + (1 - mode.delay) * steady_[m];
    remaining_flow_[m] = mode.decay * remaining_flow_[m] + mode.delay * (1 - mode.decay) * steady_[m];
  }
  if (law_.fluid.has_reynolds_stress) add_reynolds_stress(flow, mean_flow);
}

void MemoryField::add_reynolds_stress(std::span<const Velocity> flow, const Vec3& mean_flow) {
  for (FftwArray& component : velocity_and_curl_) {
    if (!component) component = transform_.array();
    std::fill_n(component.get(), transform_.reals(), 0.0);
  }
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Vec3& k = modes_[m].k;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      as_complex(velocity_and_curl_[c])[modes_[m].place] = flow[m][c];
      as_complex(velocity_and_curl_[3 + c])[modes_[m].place] =
          Complex(0, 1) * (k[d] * flow[m][e] - k[e] * flow[m][d]);
    }
  }
  if (has_mean_)
    for (int c = 0; c < 3; ++c) as_complex(velocity_and_curl_[c])[0] = mean_flow[c];
  for (const FftwArray& component : velocity_and_curl_) transform_.backward(component);
  for (std::ptrdiff_t p = 0; p < transform_.reals(); ++p) {
    const Vec3 u(velocity_and_curl_[0][p], velocity_and_curl_[1][p], velocity_and_curl_[2][p]),
        curl(velocity_and_curl_[3][p], velocity_and_curl_[4][p], velocity_and_curl_[5][p]);
    const Vec3 force = -law_.fluid.density * curl.cross(u);
    for (int c = 0; c < 3; ++c) velocity_and_curl_[c][p] = force[c];
  }
  for (int c = 0; c < 3; ++c) transform_.forward(velocity_and_curl_[c]);
  const double scale = 1 / (double(law_.points[0]) * law_.points[1] * law_.points[2]);
  for (std::size_t m = 0; m < modes_.size(); ++m) {
    const Mode& mode = modes_[m];
    Velocity stress;
    for (int c = 0; c < 3; ++c) stress[c] = scale * as_complex(velocity_and_curl_[c])[mode.place];
    stress = transverse(mode.k, stress);
    remaining_flow_[m] += law_.fluid.step / law_.fluid.density *
                          (mode.delay * stress + mode.ramp * (stress - previous_stress_[m]));
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
